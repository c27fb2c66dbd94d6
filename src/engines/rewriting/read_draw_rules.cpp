#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "derivation/start_shapes.h"
#include "engines/rewriting/draw_rules.h"
#include "engines/rewriting/setting_values.h"
#include "language/check.h"
#include "language/colour_words.h"
#include "language/form_value.h"
#include "language/parameter_value.h"
#include "language/word_settings.h"

namespace filigree::rewriting {
namespace {

struct ActWord {
    std::string_view word;
    Act act;
};
constexpr std::array act_words = {
    ActWord{"nothing", Act::nothing},
    ActWord{"line", Act::line},
    ActWord{"move", Act::move},
    ActWord{"corner", Act::corner},
    ActWord{"head_x", Act::head_x},
    ActWord{"head_y", Act::head_y},
    ActWord{"head_z", Act::head_z},
    ActWord{"turn", Act::select_up},
    ActWord{"pitch", Act::select_left},
    ActWord{"roll", Act::select_heading},
    ActWord{"plus", Act::plus},
    ActWord{"minus", Act::minus},
    ActWord{"less", Act::less},
    ActWord{"greater", Act::greater},
    ActWord{"formula", Act::formula},
    ActWord{"push", Act::push},
    ActWord{"pop", Act::pop},
    ActWord{"wider", Act::wider},
    ActWord{"narrower", Act::narrower},
    ActWord{"next_colour", Act::next_colour},
    ActWord{"previous_colour", Act::previous_colour},
    ActWord{"begin_polygon", Act::begin_polygon},
    ActWord{"end_polygon", Act::end_polygon},
};

// The value of `letter b ...` as a parameter, so that forms are bound and checked as everywhere.
const ParameterDescription& letter_parameter() {
    static const ParameterDescription parameter = [] {
        ParameterDescription made{.name = "letter",
                                  .type = ParameterType::form,
                                  .help = "what a letter makes the turtle do, or a shape that it places",
                                  .forms = &letter_forms()};
        for (const ActWord& known : act_words) made.words.push_back(known.word);
        return made;
    }();
    return parameter;
}

constexpr std::array<std::string_view, 7> formula_names = {"k", "t", "depth", "age", "x", "y", "z"};

class DrawRulesReader {
public:
    DrawRulesReader(const Settings& settings, const Document& document)
        : settings_(settings), document_(document), values_(settings, document) {}

    Result<DrawRules> run() {
        read(document_.statements, true);
        if (has_errors(values_.diagnostics)) return std::move(values_.diagnostics);
        return Result<DrawRules>(std::move(rules_), std::move(values_.diagnostics));
    }

private:
    void read(const std::vector<Statement>& statements, bool is_outermost) {
        std::set<std::string_view> said;
        for (const Statement& statement : statements) {
            if (const auto* system = std::get_if<SystemStatement>(&statement.node)) read(system->statements, false);
            const auto* setting = std::get_if<SettingStatement>(&statement.node);
            if (setting == nullptr || !find_word_setting(setting->name.text)->is_of_drawing) continue;
            const std::string& name = setting->name.text;
            if (!is_outermost && find_word_setting(name)->is_of_systems) continue;  // read_grammar
            if (!is_outermost) {
                values_.report(error("rewriting.misplaced-setting",
                                     "'" + name + "' is said of the whole document, outside its systems",
                                     setting->name.span));
            } else if (name != "letter" && !said.insert(name).second) {
                values_.report(
                    error("rewriting.repeated-setting", "found a second '" + name + "'", setting->name.span));
            } else {
                read_setting(*setting);
            }
        }
    }

    void read_setting(const SettingStatement& setting) {
        const std::string& name = setting.name.text;
        TurtleSettings& turtle = rules_.turtle;
        if (name == "letter") return read_letter(setting);
        if (name == "formula") return read_formula(setting);
        if (name == "colours") return read_colours(setting);
        if (name == "view") return read_view(setting);
        if (!values_.has_values(setting, 1, 1)) return;
        const ExpressionPtr& value = setting.values[0];
        if (name == "angle") {
            turtle.angle = values_.angle_of(value).value_or(0);
        } else if (name == "angle2") {
            turtle.angle2 = values_.angle_of(value);
        } else if (name == "plus") {
            turtle.plus = static_cast<PlusTurn>(values_.one_of(value, {"clockwise", "counterclockwise"}));
        } else if (name == "step") {
            turtle.step = values_.length_from(value, smallest_step).value_or(1);
            rules_.has_own_step = true;
        } else if (name == "width") {
            turtle.width = values_.length_from(value, 0).value_or(1);
        } else if (name == "tubes") {
            rules_.tubes = static_cast<std::uint32_t>(values_.whole_of(value, 3, 64).value_or(3));
        } else if (name == "widening") {
            const std::optional<double> ratio = values_.number_of(value);
            if (ratio && !(*ratio >= 0.01 && *ratio <= 100)) {
                values_.report(error("rewriting.out-of-range", "expected a ratio from 0.01 to 100", value->span));
            }
            turtle.width_ratio = ratio.value_or(1);
        }
    }

    void read_letter(const SettingStatement& setting) {
        if (!values_.has_values(setting, 2, 2)) return;
        const std::optional<char32_t> letter = values_.letter_of(setting.values[0]);
        if (!letter) return;
        const ExpressionPtr& said = setting.values[1];
        const Evaluation at = expected_by(letter_parameter(), document_, &settings_.globals);
        if (Diagnostics problems = check_expression(*said, at); !problems.empty()) {
            return append(values_.diagnostics, std::move(problems));
        }
        const Result<Value> value = evaluate(*said, at);
        if (!value) return append(values_.diagnostics, value.diagnostics());
        const Result<Value> form = to_form(letter_parameter(), *value, document_, said->span);
        if (!form) return append(values_.diagnostics, form.diagnostics());
        LetterUse use;
        use.letter = *letter;
        if (const auto* call = std::get_if<SymbolicCall>(&form->data)) {
            use.act = Act::shape;
            use.shape = std::to_string(rules_.forms.size());
            rules_.forms.push_back({*call, said->span});
        } else {
            const std::string& word = std::get<filigree::Symbol>(form->data).name;
            use.act = std::find_if(act_words.begin(), act_words.end(), [&](const ActWord& known) {
                          return known.word == word;
                      })->act;
        }
        rules_.turtle.letters.push_back(std::move(use));
    }

    // One expression, or a list of angles.
    void read_formula(const SettingStatement& setting) {
        if (!values_.has_values(setting, 1, 1)) return;
        const ExpressionPtr& value = setting.values[0];
        if (const auto* list = std::get_if<ListExpression>(&value->node)) {
            for (const ExpressionPtr& item : list->items) {
                if (const std::optional<double> angle = values_.angle_of(item)) rules_.turtle.angles.push_back(*angle);
            }
            if (list->items.empty()) values_.fail_usage(setting);
            return;
        }
        const Scope example = example_scope(formula_names, &settings_.globals);
        Evaluation at;
        at.document = &document_;
        at.scope = &example;
        append(values_.diagnostics, check_expression(*value, at));
        rules_.formula = value;
    }

    void read_colours(const SettingStatement& setting) {
        if (!values_.has_values(setting, 1, 1)) return;
        const std::optional<Value> value = values_.value_of(setting.values[0], colour_words_beside(&settings_.globals));
        if (!value) return;
        const auto* list = std::get_if<ValueList>(&value->data);
        if (list == nullptr || list->items.empty()) return values_.fail_usage(setting);
        for (const Value& item : list->items) {
            const Result<Colour> colour = as_colour(item);
            if (!colour) return append(values_.diagnostics, colour.diagnostics());
            rules_.colours.push_back(*colour);
        }
    }

    void read_view(const SettingStatement& setting) {
        if (!values_.has_values(setting, 2, 2)) return;
        const std::optional<double> azimuth = values_.angle_of(setting.values[0]);
        const std::optional<double> elevation = values_.angle_of(setting.values[1]);
        if (!azimuth || !elevation) return;
        if (!(*elevation >= -90 && *elevation <= 90)) {
            values_.report(error("rewriting.out-of-range", "expected an elevation from -90 to 90 degrees",
                                 setting.values[1]->span));
        }
        rules_.view.emplace();
        rules_.view->azimuth = *azimuth;
        rules_.view->elevation = *elevation;
    }

    const Settings& settings_;
    const Document& document_;
    SettingValues values_;
    DrawRules rules_;
};

}  // namespace

const std::vector<OperatorDescription>& letter_forms() {
    static const std::vector<OperatorDescription> forms = [] {
        std::vector<OperatorDescription> all = shape_forms();
        for (OperatorDescription& form : all) {  // a page may scale what it places
            for (ParameterDescription& parameter : form.parameters) {
                if (parameter.type == ParameterType::length && parameter.low == 1) parameter.low = 1e-3;
            }
        }
        const auto size = [](std::string_view name, std::string_view help) {
            return ParameterDescription{
                .name = name, .type = ParameterType::length, .help = help, .low = 1e-3, .high = largest_length};
        };
        ParameterDescription height = size("height", "upwards; 0 is as much as the breadth");
        height.default_text = "0px";
        height.low = 0;
        all.push_back({.name = "box",
                       .help = "a box that begins where the turtle stands; in the plane a rectangle",
                       .source = "GDesign, figure 9",
                       .parameters = {size("length", "ahead"), size("breadth", "from left to right"), height},
                       .example = "letter b box(20, 10, 6)"});
        return all;
    }();
    return forms;
}

std::size_t form_number(const TurtleDrawing& turtled, std::uint32_t name) {
    return static_cast<std::size_t>(std::stoul(turtled.shape_names[name]));
}

Result<DrawRules> read_draw_rules(const Settings& settings, const Document& document) {
    return DrawRulesReader(settings, document).run();
}

}  // namespace filigree::rewriting
