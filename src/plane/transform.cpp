#include "plane/transform.h"

#include "base/elementary.h"

namespace filigree {

namespace {

double tan_degrees(double angle) {
    const elementary::CosSin turn = elementary::cos_sin_degrees(angle);
    return turn.sin / turn.cos;
}

}  // namespace

Vec unit_at_degrees(double angle) {
    const elementary::CosSin turn = elementary::cos_sin_degrees(angle);
    return {turn.cos, turn.sin};
}

Transform rotation_degrees(double angle) {
    const elementary::CosSin turn = elementary::cos_sin_degrees(angle);
    return {turn.cos, turn.sin, -turn.sin, turn.cos, 0, 0};
}

Transform skew_degrees(double x_angle, double y_angle) {
    return {1, tan_degrees(y_angle), tan_degrees(x_angle), 1, 0, 0};
}

}  // namespace filigree
