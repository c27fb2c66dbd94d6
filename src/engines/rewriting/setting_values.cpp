#include "engines/rewriting/setting_values.h"

#include <algorithm>
#include <cmath>

#include "language/evaluate.h"
#include "language/word_settings.h"

namespace filigree::rewriting {

const std::string* SettingValues::word_of(const ExpressionPtr& expression) {
    const auto* name = std::get_if<NameReference>(&expression->node);
    return name == nullptr ? nullptr : &name->name;
}
const std::string* SettingValues::text_of(const ExpressionPtr& expression) {
    const auto* text = std::get_if<TextLiteral>(&expression->node);
    return text == nullptr ? nullptr : &text->text;
}

std::optional<Value> SettingValues::value_of(const ExpressionPtr& expression, std::vector<std::string_view> words) {
    Evaluation at;
    at.document = &document_;
    at.scope = &settings_.globals;
    at.words = std::move(words);
    if (has_choice(*expression)) {
        report(error("rewriting.choice-in-setting", "a setting draws nothing", expression->span,
                     {"give what is drawn a name, as in 'let bend = 20..40'"}));
        return std::nullopt;
    }
    Result<Value> value = evaluate(*expression, at);
    if (value) {
        value->span = expression->span;
        return std::move(*value);
    }
    append(diagnostics, value.diagnostics());
    return std::nullopt;
}
template <class Convert>
std::optional<double> SettingValues::converted(const ExpressionPtr& expression, Convert convert) {
    const std::optional<Value> value = value_of(expression);
    if (!value) return std::nullopt;
    const Result<double> number = convert(*value);
    if (number) return *number;
    append(diagnostics, number.diagnostics());
    return std::nullopt;
}
std::optional<double> SettingValues::number_of(const ExpressionPtr& expression) {
    return converted(expression, [](const Value& value) { return as_number(value); });
}
std::optional<double> SettingValues::angle_of(const ExpressionPtr& expression) {
    return converted(expression, [](const Value& value) { return as_angle(value); });
}
std::optional<double> SettingValues::length_of(const ExpressionPtr& expression) {
    return converted(expression, [&](const Value& value) { return as_length(value, document_); });
}
std::optional<double> SettingValues::length_from(const ExpressionPtr& expression, double least) {
    const std::optional<double> px = length_of(expression);
    if (!px || (*px >= least && *px <= largest_length)) return px;
    report(error("rewriting.out-of-range", "this length is too small or too large", expression->span));
    return std::nullopt;
}

std::optional<double> SettingValues::whole_of(const ExpressionPtr& expression, double least, double most) {
    const std::optional<double> number = number_of(expression);
    if (!number) return std::nullopt;
    if (*number >= least && *number <= most && *number == std::floor(*number)) return number;
    report(error("rewriting.out-of-range",
                 "expected a whole number from " + std::to_string(static_cast<std::int64_t>(least)) + " to " +
                     std::to_string(static_cast<std::int64_t>(most)),
                 expression->span));
    return std::nullopt;
}

std::optional<char32_t> SettingValues::letter_of(const ExpressionPtr& expression) {
    const std::string* said = word_of(expression) != nullptr ? word_of(expression) : text_of(expression);
    const std::u32string letters = said == nullptr ? std::u32string() : letters_of(*said);
    if (letters == U"=") {
        report(
            error("rewriting.bad-letter", "'=' lets the symbol before it sleep and is none itself", expression->span));
        return std::nullopt;
    }
    if (letters.size() == 1) return letters[0];
    report(error("rewriting.bad-letter", "expected one letter", expression->span,
                 {"signs are written in quotes, as in \"+\""}));
    return std::nullopt;
}

std::size_t SettingValues::one_of(const ExpressionPtr& expression, std::initializer_list<std::string_view> words) {
    const std::string* said = word_of(expression);
    const auto found = said == nullptr ? words.end() : std::find(words.begin(), words.end(), *said);
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    std::string list;
    for (const std::string_view word : words) list += (list.empty() ? "'" : ", '") + std::string(word) + "'";
    report(error("rewriting.bad-word", "expected one of " + list, expression->span));
    return 0;
}

void SettingValues::fail_usage(const SettingStatement& setting) {
    const WordSetting* known = find_word_setting(setting.name.text);
    report(error("rewriting.bad-setting", "'" + setting.name.text + "' does not take these values", setting.name.span,
                 {"write it as in '" + std::string(known->example) + "'"}));
}
bool SettingValues::has_values(const SettingStatement& setting, std::size_t least, std::size_t most) {
    const bool has = setting.values.size() >= least && setting.values.size() <= most;
    if (!has) fail_usage(setting);
    return has;
}

}  // namespace filigree::rewriting
