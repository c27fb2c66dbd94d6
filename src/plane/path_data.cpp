// SVG path data to paths and back (SVG 1.1, section 8.3).
#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "plane/path.h"

namespace filigree {

namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
char to_upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

class Reader {
public:
    explicit Reader(std::string_view data) : data_(data) {}

    Result<Path> read() {
        skip_spaces();
        while (!failed_ && at_ < data_.size()) {
            read_command();
            skip_spaces();
        }
        if (failed_) return std::move(reason_);
        return std::move(path_);
    }

private:
    void fail(std::string code, std::string message, std::size_t begin, std::size_t end) {
        if (failed_) return;
        failed_ = true;
        reason_ = error(std::move(code), std::move(message),
                        {SourceSpan::no_file, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)});
    }
    void fail_at(std::size_t at, std::string_view wanted) {
        std::string found = "path data ends";
        if (at < data_.size()) {
            const auto byte = static_cast<unsigned char>(data_[at]);
            found = "path data has ";
            found += byte > 0x20 && byte < 0x7F ? "'" + std::string(1, data_[at]) + "'"
                                                : "byte 0x" + to_hex(byte).substr(14);
        }
        fail("path.unexpected", found + " where it needs " + std::string(wanted), at, std::min(at + 1, data_.size()));
    }
    std::string argument(std::string_view name) const {
        return std::string(name) + " of '" + std::string(1, command_) + "'";
    }

    bool skip_spaces() {
        const std::size_t before = at_;
        while (at_ < data_.size() && is_space(data_[at_])) ++at_;
        return at_ != before;
    }
    // What may stand between two arguments: spaces and at most one comma.
    bool skip_separator() {
        skip_spaces();
        if (at_ >= data_.size() || data_[at_] != ',') return false;
        ++at_;
        skip_spaces();
        return true;
    }
    bool is_at_number() const {
        std::size_t i = at_;
        if (i < data_.size() && (data_[i] == '+' || data_[i] == '-')) ++i;
        if (i < data_.size() && data_[i] == '.') ++i;
        return i < data_.size() && is_digit(data_[i]);
    }
    void skip_digits() {
        while (at_ < data_.size() && is_digit(data_[at_])) ++at_;
    }

    double number(std::string_view name) {
        if (failed_) return 0;
        if (is_first_argument_) {
            skip_spaces();
            is_first_argument_ = false;
        } else {
            skip_separator();
        }
        if (!is_at_number()) {
            fail_at(at_, argument(name));
            return 0;
        }
        const std::size_t begin = at_;
        if (data_[at_] == '+' || data_[at_] == '-') ++at_;
        skip_digits();
        if (at_ < data_.size() && data_[at_] == '.') {
            ++at_;
            skip_digits();
        }
        if (at_ < data_.size() && (data_[at_] == 'e' || data_[at_] == 'E')) {
            std::size_t exponent = at_ + 1;
            if (exponent < data_.size() && (data_[exponent] == '+' || data_[exponent] == '-')) ++exponent;
            if (exponent < data_.size() && is_digit(data_[exponent])) {
                at_ = exponent;
                skip_digits();
            }
        }
        const std::optional<double> value = parse_number(data_.substr(begin, at_ - begin));
        if (!value) fail("path.number-range", "path data has a number that is too large", begin, at_);
        return value.value_or(0);
    }
    bool flag(std::string_view name) {
        if (failed_) return false;
        skip_separator();
        if (at_ >= data_.size() || (data_[at_] != '0' && data_[at_] != '1')) {
            fail_at(at_, argument(name) + ", 0 or 1");
            return false;
        }
        return data_[at_++] == '1';
    }
    Vec point(std::string_view x_name, std::string_view y_name) {
        const double x = number(x_name);
        const double y = number(y_name);
        return is_relative_ ? here_ + Vec{x, y} : Vec{x, y};
    }

    void add(Verb verb, std::initializer_list<Vec> points) {
        if (failed_) return;
        for (const Vec p : points) {
            if (std::isfinite(p.x) && std::isfinite(p.y)) continue;
            return fail("path.number-range", "path data leads to a coordinate that is too large", arguments_begin_,
                        at_);
        }
        path_.verbs.push_back(verb);
        path_.points.insert(path_.points.end(), points);
        here_ = verb == Verb::close ? start_ : path_.points.back();
        if (verb == Verb::move) start_ = here_;
        // Where the control point of a following smooth curve is mirrored from.
        last_control_ = verb == Verb::quadratic || verb == Verb::cubic ? path_.points[path_.points.size() - 2] : here_;
        last_verb_ = verb;
    }
    Vec mirrored_control(Verb after) const { return last_verb_ == after ? 2.0 * here_ - last_control_ : here_; }

    void read_command() {
        const char letter = data_[at_];
        const char kind = to_upper(letter);
        if (std::string_view("MLHVCSQTAZ").find(kind) == std::string_view::npos) {
            return fail_at(at_, path_.verbs.empty() ? "'M'" : "a command");
        }
        if (path_.verbs.empty() && kind != 'M') return fail_at(at_, "'M'");
        command_ = letter;
        is_relative_ = letter != kind;
        ++at_;
        if (kind == 'Z') return add(Verb::close, {});
        is_first_argument_ = true;
        read_arguments(kind);
        while (!failed_) {
            const std::size_t before = at_;
            const bool had_comma = skip_separator();
            if (!had_comma && !is_at_number()) {
                at_ = before;
                return;
            }
            at_ = before;
            read_arguments(kind == 'M' ? 'L' : kind);
        }
    }

    void read_arguments(char kind) {
        arguments_begin_ = at_;
        switch (kind) {
            case 'M':
                return add(Verb::move, {point("x", "y")});
            case 'L':
                return add(Verb::line, {point("x", "y")});
            case 'H': {
                const double x = number("x");
                return add(Verb::line, {{is_relative_ ? here_.x + x : x, here_.y}});
            }
            case 'V': {
                const double y = number("y");
                return add(Verb::line, {{here_.x, is_relative_ ? here_.y + y : y}});
            }
            case 'C': {
                const Vec first = point("x1", "y1");
                const Vec second = point("x2", "y2");
                const Vec to = point("x", "y");
                return add(Verb::cubic, {first, second, to});
            }
            case 'S': {
                const Vec first = mirrored_control(Verb::cubic);
                const Vec second = point("x2", "y2");
                const Vec to = point("x", "y");
                return add(Verb::cubic, {first, second, to});
            }
            case 'Q': {
                const Vec control = point("x1", "y1");
                const Vec to = point("x", "y");
                return add(Verb::quadratic, {control, to});
            }
            case 'T': {
                const Vec control = mirrored_control(Verb::quadratic);
                const Vec to = point("x", "y");
                return add(Verb::quadratic, {control, to});
            }
            default: {
                const double rx = number("rx");
                const double ry = number("ry");
                const double rotation = number("the rotation");
                const bool is_large = flag("the large-arc flag");
                const bool is_sweep = flag("the sweep flag");
                const Vec to = point("x", "y");
                return add(Verb::arc, {{rx, ry}, {rotation, (is_large ? 1.0 : 0.0) + (is_sweep ? 2.0 : 0.0)}, to});
            }
        }
    }

    std::string_view data_;
    std::size_t at_ = 0;
    char command_ = 'M';
    bool is_relative_ = false;
    bool is_first_argument_ = false;  // right after the letter, where no comma may stand
    std::size_t arguments_begin_ = 0;
    Path path_;
    Vec start_, here_, last_control_;
    Verb last_verb_ = Verb::close;
    bool failed_ = false;
    Diagnostic reason_;
};

void append_number(std::string& out, double value) {
    const std::string text = to_text(value);
    const bool is_first = out.back() >= 'A' && out.back() <= 'Z';
    if (!is_first && text[0] != '-') out += ' ';
    out += text;
}

char letter_of(Verb verb) {
    switch (verb) {
        case Verb::move:
            return 'M';
        case Verb::line:
            return 'L';
        case Verb::quadratic:
            return 'Q';
        case Verb::cubic:
            return 'C';
        case Verb::arc:
            return 'A';
        case Verb::close:
            return 'Z';
    }
    return 'Z';
}

}  // namespace

Result<Path> parse_path_data(std::string_view data) { return Reader(data).read(); }

std::string to_path_data(const Path& path) {
    std::string out;
    std::size_t at = 0;
    for (const Verb verb : path.verbs) {
        const std::size_t count = point_count(verb);
        if (path.points.size() - at < count) break;
        if (out.empty() && verb != Verb::move) out += "M0 0";
        out += letter_of(verb);
        for (std::size_t i = at; i < at + count; ++i) {
            append_number(out, path.points[i].x);
            if (verb == Verb::arc && i == at + 1) {
                const double flags = path.points[i].y;
                out += flags == 1 || flags == 3 ? " 1" : " 0";
                out += flags >= 2 ? " 1" : " 0";
            } else {
                append_number(out, path.points[i].y);
            }
        }
        at += count;
    }
    return out;
}

}  // namespace filigree
