#include "formats/svg_values.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include "base/number_text.h"

namespace filigree {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

void skip_space(std::string_view& text) {
    while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
}
// White space around at most one comma; whether there was a comma.
bool skip_separator(std::string_view& text) {
    skip_space(text);
    if (!text.starts_with(',')) return false;
    text.remove_prefix(1);
    skip_space(text);
    return true;
}

// How many characters at the start are a number as SVG writes one; 0 for none.
std::size_t number_length(std::string_view text) {
    std::size_t i = 0;
    const auto skip_digits = [&] {
        const std::size_t first = i;
        while (i < text.size() && is_digit(text[i])) ++i;
        return i - first;
    };
    if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
    std::size_t digits = skip_digits();
    if (i < text.size() && text[i] == '.') {
        ++i;
        digits += skip_digits();
    }
    if (digits == 0) return 0;
    if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
        const std::size_t mantissa = i++;
        if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
        if (skip_digits() == 0) return mantissa;  // 2em
    }
    return i;
}

std::optional<double> take_number(std::string_view& text) {
    const std::size_t length = number_length(text);
    if (length == 0) return std::nullopt;
    std::string_view digits = text.substr(0, length);
    if (digits.front() == '+') digits.remove_prefix(1);
    const std::optional<double> value = parse_number(digits);
    if (value) text.remove_prefix(length);
    return value;
}

struct Unit {
    std::string_view name;
    double px;
};
constexpr std::array units = {
    Unit{"", 1},           Unit{"px", 1},   Unit{"mm", 96 / 25.4}, Unit{"cm", 96 / 2.54},
    Unit{"Q", 96 / 101.6}, Unit{"in", 96},  Unit{"pt", 96.0 / 72}, Unit{"pc", 16},
    Unit{"em", 16},        Unit{"rem", 16}, Unit{"ex", 8},
};

bool equals_ignoring_case(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](char x, char y) { return lower(x) == lower(y); });
}

std::optional<Transform> named_transform(std::string_view name, const std::vector<double>& v) {
    const std::size_t n = v.size();
    if (name == "matrix" && n == 6) return Transform{v[0], v[1], v[2], v[3], v[4], v[5]};
    if (name == "translate" && (n == 1 || n == 2)) return translation({v[0], n == 2 ? v[1] : 0});
    if (name == "scale" && (n == 1 || n == 2)) return scaling(v[0], n == 2 ? v[1] : v[0]);
    if (name == "rotate" && n == 1) return rotation_degrees(v[0]);
    if (name == "rotate" && n == 3) {
        const Vec centre{v[1], v[2]};
        return compose(translation(centre), compose(rotation_degrees(v[0]), translation(-centre)));
    }
    if (name == "skewX" && n == 1) return skew_degrees(v[0], 0);
    if (name == "skewY" && n == 1) return skew_degrees(0, v[0]);
    return std::nullopt;
}

std::optional<double> alignment(std::string_view text) {
    if (text == "Min") return 0;
    if (text == "Mid") return 0.5;
    if (text == "Max") return 1;
    return std::nullopt;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
    skip_space(text);
    while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
    return text;
}

std::optional<std::vector<double>> parse_number_list(std::string_view text) {
    std::vector<double> numbers;
    text = trimmed(text);
    bool must_follow = false;  // after a comma
    while (!text.empty() || must_follow) {
        const std::optional<double> value = take_number(text);
        if (!value) return std::nullopt;
        numbers.push_back(*value);
        must_follow = skip_separator(text);
    }
    return numbers;
}

std::optional<SvgLength> parse_length(std::string_view text) {
    text = trimmed(text);
    const std::optional<double> value = take_number(text);
    if (!value) return std::nullopt;
    if (text == "%") return SvgLength{*value, true};
    for (const Unit& unit : units) {
        if (equals_ignoring_case(text, unit.name)) return SvgLength{*value * unit.px, false};
    }
    return std::nullopt;
}

std::optional<Transform> parse_transform_list(std::string_view text) {
    text = trimmed(text);
    Transform all;
    if (text == "none") return all;
    bool must_follow = false;
    while (!text.empty() || must_follow) {
        const std::size_t open = text.find('(');
        if (open == std::string_view::npos) return std::nullopt;
        const std::size_t close = text.find(')', open);
        if (close == std::string_view::npos) return std::nullopt;
        const auto numbers = parse_number_list(text.substr(open + 1, close - open - 1));
        if (!numbers) return std::nullopt;
        const std::optional<Transform> next = named_transform(trimmed(text.substr(0, open)), *numbers);
        if (!next) return std::nullopt;
        all = compose(all, *next);
        text.remove_prefix(close + 1);
        must_follow = skip_separator(text);
    }
    return all;
}

std::optional<ViewBox> parse_view_box(std::string_view text) {
    const auto numbers = parse_number_list(text);
    if (!numbers || numbers->size() != 4) return std::nullopt;
    const ViewBox box{{(*numbers)[0], (*numbers)[1]}, {(*numbers)[2], (*numbers)[3]}};
    if (!(box.size.x > 0 && box.size.y > 0)) return std::nullopt;
    return box;
}

std::optional<AspectRatio> parse_aspect_ratio(std::string_view text) {
    text = trimmed(text);
    if (text.starts_with("defer")) text = trimmed(text.substr(5));
    const std::size_t space = std::min(text.find_first_of(" \t\n\r\f"), text.size());
    const std::string_view align = text.substr(0, space), how = trimmed(text.substr(space));
    AspectRatio ratio;
    if (how == "slice") {
        ratio.slice = true;
    } else if (how != "meet" && !how.empty()) {
        return std::nullopt;
    }
    if (align == "none") {
        ratio.stretch = true;
        return ratio;
    }
    if (align.size() != 8 || align[0] != 'x' || align[4] != 'Y') return std::nullopt;
    const std::optional<double> x = alignment(align.substr(1, 3)), y = alignment(align.substr(5, 3));
    if (!x || !y) return std::nullopt;
    ratio.align_x = *x;
    ratio.align_y = *y;
    return ratio;
}

Transform fit(const ViewBox& box, Vec size, const AspectRatio& ratio) {
    double scale_x = size.x / box.size.x, scale_y = size.y / box.size.y;
    if (!ratio.stretch) {
        scale_x = ratio.slice ? std::max(scale_x, scale_y) : std::min(scale_x, scale_y);
        scale_y = scale_x;
    }
    const Vec left{(size.x - box.size.x * scale_x) * ratio.align_x, (size.y - box.size.y * scale_y) * ratio.align_y};
    return {scale_x, 0, 0, scale_y, left.x - box.origin.x * scale_x, left.y - box.origin.y * scale_y};
}

}  // namespace filigree
