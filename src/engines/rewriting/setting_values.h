// The values of settings (language/word_settings.h), with what is wrong with them.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "engines/rewriting/symbols.h"
#include "language/document.h"
#include "language/settings.h"

namespace filigree::rewriting {

constexpr double largest_length = 0x1p20;  // px
constexpr double smallest_step = 1e-6;

class SettingValues {
public:
    SettingValues(const Settings& settings, const Document& document) : settings_(settings), document_(document) {}

    Diagnostics diagnostics;

    void report(Diagnostic diagnostic) { diagnostics.push_back(std::move(diagnostic)); }

    // The word or text that an expression is, such as the q of `gain q 1`; null where it is none.
    static const std::string* word_of(const ExpressionPtr& expression);
    static const std::string* text_of(const ExpressionPtr& expression);

    // Nothing is given back for what is wrong, which is reported. `words` mean themselves.
    std::optional<Value> value_of(const ExpressionPtr& expression, std::vector<std::string_view> words = {});
    std::optional<double> number_of(const ExpressionPtr& expression);
    std::optional<double> angle_of(const ExpressionPtr& expression);                   // degrees
    std::optional<double> length_of(const ExpressionPtr& expression);                  // px
    std::optional<double> length_from(const ExpressionPtr& expression, double least);  // to largest_length
    std::optional<double> whole_of(const ExpressionPtr& expression, double least, double most);
    std::optional<char32_t> letter_of(const ExpressionPtr& expression);  // bare or in quotes
    std::size_t one_of(const ExpressionPtr& expression, std::initializer_list<std::string_view> words);

    void fail_usage(const SettingStatement& setting);
    // Reports where there are more or fewer.
    bool has_values(const SettingStatement& setting, std::size_t least, std::size_t most);

private:
    template <class Convert>
    std::optional<double> converted(const ExpressionPtr& expression, Convert convert);

    const Settings& settings_;
    const Document& document_;
};

}  // namespace filigree::rewriting
