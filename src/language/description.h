// Operators described by data: the one source of parsing checks, error messages, `describe`, reference
// pages and, later, the studio's forms.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace filigree {

struct OperatorDescription;

enum class ParameterType {
    whole,      // a whole number
    real,       // a number
    length,     // px after evaluation; bare numbers are in the document's unit
    angle,      // degrees
    direction,  // degrees, or one of `words`, or a call named in `calls`
    flag,       // true, false, yes, no, 0, 1, or the parameter's own name
    word,       // one of `words`
    lengths,    // one length or a list of them
    text,
    point,  // (x, y) in lengths
    colour,
    form,  // one of `words`, or a call of one of `forms`; also a number where `low` and `high` bound it, or a point
    any,   // what it is, unconverted; a bare word that names nothing stands for itself
};

struct ParameterDescription {
    std::string_view name = {};  // snake_case
    ParameterType type = ParameterType::real;
    std::string_view help = {};  // one line, lower case, no full stop
    // As the document would write it; may use the parameters before it. Empty: must be given.
    std::string_view default_text = {};
    double low = -1e300, high = 1e300;           // allowed values, both ends included (px, degrees, plain)
    std::vector<std::string_view> words = {};    // for `word`, `direction` and `form`
    std::vector<std::string_view> calls = {};    // for `direction`: names of calls with one argument
    std::vector<std::string_view> aliases = {};  // other names for the argument
    // For `form`: the calls that may stand here, such as star(5, 20, 8). Must outlive the description.
    const std::vector<OperatorDescription>* forms = nullptr;
    bool takes_points = false;  // for `form`
    bool repeats = false;       // of a form: takes all further values without a name too, as a list
};

// Whether that is the parameter's name or an alias of it.
bool has_name(const ParameterDescription& parameter, std::string_view name);

struct PortDescription {
    std::string_view name = {};
    std::string_view help = {};
};

struct OperatorDescription {
    std::string_view name = {};                  // snake_case
    std::vector<std::string_view> aliases = {};  // the papers' spellings
    std::string_view help = {};                  // one line
    std::string_view source = {};                // "gTangle, section 4.2"
    std::vector<ParameterDescription> parameters = {};
    std::vector<PortDescription> ports = {};  // in the order of the outputs
    std::string_view example = {};            // a rule, as in a document
    bool shrinks = true;                      // whether its outputs are smaller than its inputs
    bool regroups = false;                    // whether one port may give several groups
};

// The description with this name or alias, or null.
const OperatorDescription* find_operator(std::span<const OperatorDescription> operators, std::string_view name);
std::string_view type_name(ParameterType type);  // "a length", "a whole number", ...

}  // namespace filigree
