// The arguments of one edit of one word: those that are evaluated once, and those that are for every token.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engines/rewriting/word_edit.h"
#include "engines/rewriting/word_edits.h"
#include "language/bind.h"

namespace filigree::rewriting {

Result<std::vector<ChunkPair>> put_pairs(const std::vector<WordEdit::Pair>& pairs, const Document& document,
                                         const Scope& names, std::uint64_t most);

class EditArguments {
public:
    // `names`: what is known of the word. `key` addresses the choices. All must outlive this.
    EditArguments(const WordEdit& edit, const Document& document, const Scope& names, const StepChoices& choices,
                  Key key)
        : edit_(edit), document_(document), names_(names), choices_(choices), key_(key) {}

    // Evaluates what is evaluated once, texts with their repeats, at most `most` letters each. What is wrong, if
    // anything is.
    Diagnostics evaluate_common(std::uint64_t most);

    bool is_given(std::string_view parameter) const;
    double number(std::string_view parameter) const { return common_.number(parameter); }
    bool flag(std::string_view parameter) const { return common_.flag(parameter); }
    std::string_view word(std::string_view parameter) const { return common_.word(parameter); }
    const Value& value(std::string_view parameter) const { return common_.value(parameter); }
    const std::u32string& letters(std::string_view parameter) const { return letters_[index_of(parameter)]; }

    // Whether it is evaluated for every token.
    bool varies(std::string_view parameter) const { return find_by_token(parameter) != nullptr; }
    // For one of them: `facts` in the order of EditOperator::TokenParameter::facts, `token` addresses choices. Of what
    // does not vary it is the common value. From the first problem on, false and 0.
    bool holds(std::string_view parameter, std::uint32_t token, std::span<const Value> facts);
    double number_of(std::string_view parameter, std::uint32_t token, std::span<const Value> facts);
    const std::optional<Diagnostic>& problem() const { return problem_; }

private:
    // What is known of a token, under the names of one parameter.
    struct Facts {
        Scope scope;
        std::vector<Value*> values;
    };

    std::size_t index_of(std::string_view parameter) const;
    const WordEdit::TokenExpression* find_by_token(std::string_view parameter) const;
    std::optional<Value> value_at(std::string_view parameter, std::uint32_t token, std::span<const Value> facts);
    Facts& facts_for(const WordEdit::TokenExpression& expression);

    const WordEdit& edit_;
    const Document& document_;
    const Scope& names_;
    const StepChoices& choices_;
    Key key_;
    Arguments common_;
    std::vector<std::u32string> letters_;               // of parameters that are texts
    std::vector<std::pair<std::size_t, Facts>> facts_;  // by parameter
    std::optional<Diagnostic> problem_;
};

}  // namespace filigree::rewriting
