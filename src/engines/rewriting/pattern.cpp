#include "engines/rewriting/pattern.h"

#include <cmath>

#include "language/parse.h"

namespace filigree::rewriting {
namespace {

constexpr int deepest = 100;

class Reader {
public:
    Reader(std::u32string_view letters, SourceSpan at, bool free_braces)
        : letters_(letters), at_(at), free_braces_(free_braces) {}

    Result<Pattern> read() {
        Pattern pattern;
        if (!read_parts(pattern.parts, 0)) return std::move(*problem_);
        return pattern;
    }

private:
    bool fail(std::string_view code, std::string message, std::vector<std::string> hints = {}) {
        problem_ = error(std::string(code), std::move(message), at_, std::move(hints));
        return false;
    }

    bool read_parts(std::vector<Pattern::Part>& parts, int depth) {
        if (depth > deepest) return fail("rewriting.too-deep", "repeats are nested too deeply");
        std::u32string letters;
        const auto put = [&] {
            if (!letters.empty()) parts.push_back({std::move(letters), nullptr, {}});
            letters.clear();
        };
        for (; next_ < letters_.size(); ++next_) {
            const char32_t letter = letters_[next_];
            if (is_blank(letter)) continue;
            if (!free_braces_ && letter == U'}') {
                if (depth == 0) return fail("rewriting.unmatched-brace", "found '}' without its '{'");
                put();
                return true;
            }
            if (free_braces_ || letter != U'{') {
                letters += letter;
                continue;
            }
            put();
            ++next_;
            Pattern::Part part;
            if (!read_count(part.count) || !read_parts(part.repeated, depth + 1)) return false;
            if (next_ == letters_.size()) return fail("rewriting.unmatched-brace", "found '{' without its '}'");
            if (part.repeated.empty() && is_freeze_next()) part.repeated.push_back({U"=", nullptr, {}});
            parts.push_back(std::move(part));
        }
        put();
        return true;
    }

    bool read_count(ExpressionPtr& count) {
        std::u32string digits;
        while (next_ < letters_.size() && is_blank(letters_[next_])) ++next_;
        if (next_ < letters_.size() && letters_[next_] == U'$') {
            for (++next_; next_ < letters_.size() && is_name_letter(letters_[next_]); ++next_)
                digits += letters_[next_];
            if (digits.empty()) return fail("rewriting.missing-count", "expected a name behind '$'");
        } else if (next_ < letters_.size() && letters_[next_] == U'(') {
            int open = 0;
            do {
                open += letters_[next_] == U'(' ? 1 : letters_[next_] == U')' ? -1 : 0;
                digits += letters_[next_++];
            } while (open > 0 && next_ < letters_.size());
            if (open > 0) return fail("rewriting.missing-count", "found '(' without its ')'");
        } else {
            if (next_ < letters_.size() && letters_[next_] == U'-') digits += letters_[next_++];
            while (next_ < letters_.size() && letters_[next_] >= U'0' && letters_[next_] <= U'9') {
                digits += letters_[next_++];
            }
            if (digits == U"-") {  // a turn, not a number
                --next_;
                digits.clear();
            }
            if (digits.empty()) digits += U'1';
        }
        Result<ExpressionPtr> parsed = parse_expression(to_utf8(digits));
        if (!parsed) {
            return fail("rewriting.bad-count",
                        "the number of repeats is no expression: " + parsed.diagnostics().front().message);
        }
        count = std::move(*parsed);
        return true;
    }

    // Whether the '}' is followed by a '=', which is taken then.
    bool is_freeze_next() {
        std::size_t behind = next_ + 1;
        while (behind < letters_.size() && is_blank(letters_[behind])) ++behind;
        if (behind == letters_.size() || letters_[behind] != U'=') return false;
        next_ = behind;
        return true;
    }

    static bool is_name_letter(char32_t c) {
        return (c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z') || (c >= U'0' && c <= U'9') || c == U'_';
    }

    std::u32string_view letters_;
    SourceSpan at_;
    const bool free_braces_;
    std::size_t next_ = 0;
    std::optional<Diagnostic> problem_;
};

std::optional<double> constant_of(const ExpressionPtr& count) {
    const Expression* node = count.get();
    double sign = 1;
    if (const auto* unary = std::get_if<UnaryExpression>(&node->node)) {
        if (unary->op != UnaryOperator::negate) return std::nullopt;
        sign = -1;
        node = unary->operand.get();
    }
    const auto* number = std::get_if<NumberLiteral>(&node->node);
    if (number == nullptr) return std::nullopt;
    return sign * number->value;
}

double whole_count(double count) { return std::floor(count + 1e-9); }

bool are_constant(const std::vector<Pattern::Part>& parts) {
    for (const Pattern::Part& part : parts) {
        if (part.count && (!constant_of(part.count) || !are_constant(part.repeated))) return false;
    }
    return true;
}

std::optional<double> letter_count(const std::vector<Pattern::Part>& parts) {
    double length = 0;
    for (const Pattern::Part& part : parts) {
        const std::optional<double> count = part.count ? constant_of(part.count) : 1;
        const std::optional<double> once =
            part.count ? letter_count(part.repeated) : static_cast<double>(part.letters.size());
        if (!count || !once) return std::nullopt;
        const double times = whole_count(*count);
        if (times > 0 && *once > 0) length += times * *once;
    }
    return length;
}

Diagnostic too_long() {
    return fault(Fault::limit, "limit.elements", "a text with its repeats has more symbols than the limit allows");
}

std::optional<Diagnostic> expand(const std::vector<Pattern::Part>& parts, std::uint64_t most, const CountOf& count_of,
                                 std::u32string& into) {
    for (const Pattern::Part& part : parts) {
        if (!part.count) {
            if (part.letters.size() > most - into.size()) return too_long();
            into += part.letters;
            continue;
        }
        double count = 0;
        if (const std::optional<double> constant = constant_of(part.count)) {
            count = *constant;
        } else {
            const Result<double> evaluated = count_of(part.count);
            if (!evaluated) return evaluated.diagnostics().front();
            count = *evaluated;
        }
        count = whole_count(count);
        if (!(count > 0)) continue;
        std::u32string once;
        if (std::optional<Diagnostic> problem = expand(part.repeated, most, count_of, once)) return problem;
        if (once.empty()) continue;
        if (count > static_cast<double>((most - into.size()) / once.size())) return too_long();
        for (auto left = static_cast<std::uint64_t>(count); left > 0; --left) into += once;
    }
    return std::nullopt;
}

}  // namespace

Result<Pattern> read_pattern(std::string_view text, SourceSpan at, bool free_braces) {
    const std::u32string letters = letters_of(text, true);
    return Reader(letters, at, free_braces).read();
}

bool is_constant(const Pattern& pattern) { return are_constant(pattern.parts); }
std::optional<double> letter_count(const Pattern& pattern) { return letter_count(pattern.parts); }

Result<std::u32string> expanded(const Pattern& pattern, std::uint64_t most, const CountOf& count_of) {
    std::u32string letters;
    if (std::optional<Diagnostic> problem = expand(pattern.parts, most, count_of, letters)) return std::move(*problem);
    return letters;
}

Result<std::u32string> put_text(const Pattern& text, const Document* document, const Scope& names, std::uint64_t most) {
    Evaluation at;
    at.document = document;
    at.scope = &names;
    return expanded(text, most, [&](const ExpressionPtr& count) -> Result<double> {
        const Result<Value> value = evaluate(*count, at);
        if (!value) return value.diagnostics();
        return as_number(*value);
    });
}

}  // namespace filigree::rewriting
