// Elementary functions with the same bits on every machine.
//
// The C library picks variants of sin, exp, log, ... by the processor at run time, and some results differ
// in the last bit. These are plain polynomials over +, -, * and / in double precision, compiled without
// contraction, so that a drawing never depends on where it was made. Errors stay below 1.5 ulp over the stated
// ranges (measured: 0.5 for log and cbrt, 0.6 for power, 0.8 for cos_sin and exp, 1.3 for the others); a test
// compares with long double. Whole powers and roots that are doubles come out exactly. sqrt and fma-free arithmetic are
// exact already and come from <cmath>.
#pragma once

namespace filigree::elementary {

constexpr double pi = 3.14159265358979323846;

struct CosSin {
    double cos = 1;
    double sin = 0;
};

// Any finite angle up to 1e9 in magnitude; not-a-number beyond.
CosSin cos_sin(double radians);
// Any finite angle. Exact at multiples of 90 degrees, never -0; cos 60 and sin 30 are exactly 0.5, and cos 45 is
// sin 45.
CosSin cos_sin_degrees(double degrees);
double tan(double radians);

double atan(double x);
double atan2(double y, double x);  // in (-pi, pi], whatever the sign of a zero; atan2(0, 0) is 0
double asin(double x);             // NaN outside [-1, 1]
double acos(double x);             // NaN outside [-1, 1]

double exp(double x);                        // 0 below -745, infinite above 709.79
double log(double x);                        // natural; -infinity at 0, NaN below
double power(double base, double exponent);  // as std::pow for finite arguments
double cbrt(double x);

}  // namespace filigree::elementary
