#include "engines/shape/read_grammar.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "curves/affine.h"
#include "curves/algebra.h"
#include "curves/faces.h"
#include "curves/maximal.h"
#include "curves/symmetry.h"
#include "derivation/inputs.h"
#include "engines/shape/applications.h"
#include "engines/shape/doubts.h"
#include "engines/shape/match_words.h"
#include "engines/shape/shape_values.h"
#include "language/evaluate.h"
#include "language/shape_forms.h"
#include "language/shape_rules.h"
#include "language/step_choices.h"
#include "language/walk.h"

namespace filigree::shape {
namespace {

using curves::Element;
using curves::Shape;

// What lies so near is the same: of the start's diagonal, where nothing else is said. Files have few decimals.
constexpr double exact_share = 1e-9, file_share = 1e-4;
constexpr double least_tolerance = 1e-12;

class Reader {
public:
    Reader(const Settings& settings, const Document& document, const ShapeSource& files)
        : settings_(settings), document_(document), files_(files) {
        default_match_.options.group = curves::MatchGroup::similarity;
    }

    Result<Grammar> run() {
        read_drawings();
        const Scope varying = example_scope(settings_);
        const Result<ShapeRules> named = read_shape_rules(document_, settings_.globals, drawn_names_, &varying);
        if (!named) {
            fail(named.diagnostics());
            return problems_;
        }
        read_settings(*named);
        read_start();
        if (has_errors(problems_)) return problems_;
        grammar_.rules.resize(named->rules.size());
        for (const std::size_t r : named->in_order) read_rule(*named, r);
        check_labels();
        read_steps(*named);
        read_show(*named);
        for (const Statement& statement : document_.statements) refuse(statement);
        if (has_errors(problems_)) return problems_;
        for (Rule& rule : grammar_.rules) {
            rule.options.tolerance = grammar_.tolerance;
            if (rule.by_corners) continue;
            rule.variants = variants_of(rule);
            if (rule.options.group != curves::MatchGroup::affine) continue;
            if (!fixes_affine_maps(rule.left, grammar_.tolerance)) {
                fail(error("shape.too-little-fixed", "the left side of '" + rule.name + "' does not fix an affine map",
                           rule.span,
                           {"it takes three places, where its curves meet, labelled points, or centres of circles",
                            "`match similarity` takes any curve"}));
            }
        }
        if (has_errors(problems_)) return problems_;
        return {std::move(grammar_), std::move(problems_)};
    }

private:
    ValueReading reading() { return {document_, files_, grammar_.tolerance, &grammar_.labels, &problems_, &doubts_}; }
    void fail(Diagnostic problem) { problems_.push_back(std::move(problem)); }
    void fail(const Diagnostics& problems) { append(problems_, problems); }  // warnings, too

    // Those that have come up since.
    void tell_doubts(SourceSpan span) {
        if (auto doubt = warning_of(doubts_, document_, span)) fail(*std::move(doubt));
        doubts_ = {};
    }

    Evaluation evaluation() const {
        Evaluation at;
        at.document = &document_;
        at.scope = &settings_.globals;
        return with_shapes(at);
    }
    // A value that must not hang on chance: the same for all steps.
    std::optional<Value> value_of(const Expression& expression, const Evaluation& at) {
        if (has_choice(expression)) {
            fail(error("shape.choice-here", "only the right side of a rule can draw at random", expression.span,
                       {"`let` draws once for the whole document"}));
            return std::nullopt;
        }
        Result<Value> value = evaluate(expression, at);
        if (value) return std::move(*value);
        fail(value.diagnostics());
        return std::nullopt;
    }
    std::optional<double> number_of(const Expression& expression) {
        const std::optional<Value> value = value_of(expression, evaluation());
        if (!value) return std::nullopt;
        const Result<double> number = as_number(*value);
        if (number) return *number;
        fail(number.diagnostics());
        return std::nullopt;
    }
    std::optional<Shape> shape_at(const Expression& expression) {
        const std::optional<Value> value = value_of(expression, evaluation());
        if (!value) return std::nullopt;
        Result<Shape> shape = shape_of(*value, reading());
        tell_doubts(expression.span);
        if (shape) return std::move(*shape);
        fail(shape.diagnostics());
        return std::nullopt;
    }
    Evaluation with_words(std::vector<std::string_view> words, std::vector<std::string_view> calls) const {
        Evaluation at;
        at.document = &document_;
        at.scope = &settings_.globals;
        at.words = std::move(words);
        at.calls = std::move(calls);
        at.words_in_calls = true;
        return at;
    }

    // --- settings -------------------------------------------------------------------------------------------------

    void read_settings(const ShapeRules& named) {
        for (const SettingStatement* setting : named.settings) {
            const std::string& name = setting->name.text;
            if (name == "show") continue;  // when the rules are known
            const Expression& value = *setting->values.front();
            if (name == "steps") {
                const std::optional<double> steps = number_of(value);
                if (steps && !(*steps >= 0 && *steps <= 1e6 && *steps == std::floor(*steps))) {
                    fail(error("shape.bad-steps", "'steps' takes a whole number from 0 to 1000000", value.span));
                } else if (steps) {
                    grammar_.steps = static_cast<std::uint64_t>(*steps);
                }
            } else if (name == "tolerance") {
                const std::optional<Value> found = value_of(value, evaluation());
                if (!found) continue;
                const Result<double> tolerance = as_length(*found, document_);
                if (!tolerance) {
                    fail(tolerance.diagnostics());
                } else if (!(*tolerance >= least_tolerance && *tolerance <= 1000)) {
                    fail(error("shape.bad-tolerance", "'tolerance' takes a length above 0 and up to 1000px",
                               value.span));
                } else {
                    grammar_.tolerance = *tolerance;
                }
            } else if (name == "choose") {
                read_choose(value);
            } else if (name == "match") {
                if (auto word = match_at(value)) default_match_ = *word;
            }
        }
    }

    void read_choose(const Expression& expression) {
        const std::optional<Value> value = value_of(expression, with_words({"*"}, {}));
        if (!value) return;
        const std::string word = plain_text(*value);
        if (word == "random")
            grammar_.pick = Pick::random;
        else if (word == "first")
            grammar_.pick = Pick::first;
        else if (word == "all")
            grammar_.pick = Pick::all;
        else if (word == "orbit")
            grammar_.pick = Pick::orbit;
        else {
            std::vector<std::string> hints = did_you_mean(word, {"random", "first", "all", "orbit"});
            if (hints.empty()) hints.push_back("one of random, first, all and orbit");
            fail(error("shape.bad-choose", "'choose' does not know '" + word + "'", expression.span, hints));
        }
    }

    std::optional<MatchWord> match_at(const Expression& expression) {
        std::vector<std::string_view> calls;
        for (const OperatorDescription& one : match_words()) calls.push_back(one.name);
        const std::optional<Value> value = value_of(expression, with_words({"*"}, calls));
        if (!value) return std::nullopt;
        Result<MatchWord> word = match_of(*value, document_);
        if (word) return *word;
        fail(word.diagnostics());
        return std::nullopt;
    }

    void read_show(const ShapeRules& named) {
        for (const SettingStatement* setting : named.settings) {
            if (setting->name.text != "show") continue;
            for (const ExpressionPtr& expression : setting->values) {
                const std::optional<Value> value = value_of(*expression, with_words({"*"}, {"matches", "film"}));
                if (value) read_shown(*value, expression->span);
            }
        }
    }
    void read_shown(const Value& value, SourceSpan span) {
        const auto* call = std::get_if<SymbolicCall>(&value.data);
        const auto* word = std::get_if<Symbol>(&value.data);
        const std::string name = call != nullptr ? call->name : word != nullptr ? word->name : plain_text(value);
        Show& show = grammar_.show;
        if (name == "control_polygons")
            show.control_polygons = true;
        else if (name == "points")
            show.points = true;
        else if (name == "labels")
            show.labels = true;
        else if (name == "dots")
            show.dots = true;
        else if (name == "film") {
            show.film = 0;
            if (call == nullptr || call->arguments.empty()) return;
            const NamedValue& columns = call->arguments.front();
            const Result<double> count = as_number(columns.value);
            const bool is_columns = columns.name.empty() || columns.name == "columns";
            if (call->arguments.size() == 1 && is_columns && count && *count >= 1 && *count <= 1000 &&
                *count == std::floor(*count)) {
                show.film = static_cast<std::uint32_t>(*count);
            } else {
                fail(error("shape.bad-film", "film takes the number of its columns, as in film(columns: 4)", span));
            }
        } else if (name == "matches") {
            if (call == nullptr || call->arguments.empty()) {
                for (std::uint32_t r = 0; r < grammar_.rules.size(); ++r) show.matches.push_back(r);
                return;
            }
            for (const NamedValue& argument : call->arguments) {
                const std::string rule = plain_text(argument.value);
                std::vector<std::string_view> known;
                for (const Rule& one : grammar_.rules) known.push_back(one.name);
                if (const auto found = find_rule(grammar_, rule)) {
                    show.matches.push_back(*found);
                } else {
                    fail(error("language.unknown-rule", "there is no rule '" + rule + "'", span,
                               did_you_mean(rule, known)));
                }
            }
        } else {
            const std::vector<std::string_view> known = {"control_polygons", "points", "labels", "dots",
                                                         "matches",          "film"};
            std::vector<std::string> hints = did_you_mean(name, known);
            if (hints.empty()) hints.push_back("one of control_polygons, points, labels, dots, matches(RULE) and film");
            fail(error("shape.bad-show", "there is no '" + name + "' to show", span, hints));
        }
    }

    // --- the start ------------------------------------------------------------------------------------------------

    void read_start() {
        std::vector<const StartStatement*> starts;
        for (const Statement& statement : document_.statements) {
            const auto* start = std::get_if<StartStatement>(&statement.node);
            if (start == nullptr) continue;
            if (start->from) {
                fail(error("shape.start-from", "a shape grammar starts from one shape", statement.span,
                           {"write start design = file(\"" + start->from->text + "\")"}));
                return;
            }
            starts.push_back(start);
        }
        if (starts.empty()) {
            fail(error("shape.no-start", "a shape grammar needs a start", {}, {"such as start design = circle(100)"}));
            return;
        }
        grammar_.start_tag = starts[0]->tag.text;
        const bool is_given = grammar_.tolerance > 0;
        const double share = named_files(document_).empty() ? exact_share : file_share;
        std::vector<Value> values;
        for (const StartStatement* start : starts) {
            Result<Value> value = evaluate(*start->value, evaluation());
            if (!value) return fail(value.diagnostics());
            values.push_back(std::move(*value));
        }
        const auto sum_of = [&](const ValueReading& reading) -> Result<Shape> {
            std::vector<Element> elements;
            for (const Value& value : values) {
                const Result<Shape> shape = shape_of(value, reading);
                if (!shape) return shape.diagnostics();
                elements.insert(elements.end(), shape->elements.begin(), shape->elements.end());
            }
            return maximal(std::move(elements), reading.tolerance, reading.doubts);
        };
        if (!is_given) {
            // How large it is says what is near.
            const Result<Shape> exact = sum_of({document_, files_, least_tolerance});
            if (!exact) return fail(exact.diagnostics());
            grammar_.tolerance = std::max(share * diagonal_of(bounds_of(exact->elements)), least_tolerance);
        }
        Result<Shape> start = sum_of(reading());
        if (!start) return fail(start.diagnostics());
        grammar_.start = std::move(*start);
        tell_doubts(starts[0]->value->span);
        if (grammar_.start.elements.empty() && !is_empty_word(values)) {
            fail(error("shape.empty-start", "nothing of this start is longer than the tolerance",
                       starts[0]->value->span));
        }
    }
    static bool is_empty_word(const std::vector<Value>& values) {
        return values.size() == 1 && std::holds_alternative<Symbol>(values[0].data);
    }

    // --- rules ----------------------------------------------------------------------------------------------------

    // Those of all files that the document names, in its order.
    void read_drawings() {
        for (const Statement& statement : document_.statements) {
            const auto* from = std::get_if<RulesFromStatement>(&statement.node);
            if (from == nullptr) continue;
            const auto placed_here = [&](Diagnostics problems) {
                for (Diagnostic& problem : problems) problem.span = from->file.span;
                return problems;
            };
            const auto picture = files_.drawing(from->file.text);
            fail(placed_here(picture.diagnostics()));
            if (!picture) continue;
            Result<std::vector<DrawnRule>> drawn = drawn_rules(**picture);
            fail(placed_here(drawn.diagnostics()));
            if (!drawn) continue;
            for (DrawnRule& rule : *drawn) {
                drawn_names_.push_back({rule.name, from->file.span});
                drawn_.push_back(std::move(rule));
            }
        }
    }

    void read_rule(const ShapeRules& named, std::size_t index) {
        const NamedShapeRule& one = named.rules[index];
        Rule& rule = grammar_.rules[index];
        using Kind = NamedShapeRule::Kind;
        if (one.kind == Kind::written) {
            read_written(*one.statement, rule);
        } else if (one.kind == Kind::drawn) {
            const auto drawn = std::find_if(drawn_.begin(), drawn_.end(),
                                            [&](const DrawnRule& other) { return other.name == one.name; });
            read_drawn(*drawn, drawn_names_[static_cast<std::size_t>(drawn - drawn_.begin())].file, rule);
        } else {
            rule = grammar_.rules[one.base];
            if (one.kind == Kind::inverse) {
                invert(rule, one.statement->derivation->span);
            } else {
                mirror(rule, one);
            }
        }
        rule.name = one.name;
        if (one.statement != nullptr) rule.span = one.statement->name.span;
    }

    void read_written(const ShapeRule& statement, Rule& rule) {
        rule.name = statement.name.text;
        rule.span = statement.name.span;
        const std::optional<Shape> left = shape_at(*statement.left);
        if (left) rule.left = *left;
        if (left && left->elements.empty()) {
            fail(error("shape.no-left-side", "the left side of '" + rule.name + "' is empty, so it matches everywhere",
                       statement.left->span, {"what a rule adds must stand in relation to something that it finds"}));
        }
        read_right_side(*statement.right, rule);
        MatchWord match = default_match_;
        if (statement.match) {
            if (const auto own = match_at(*statement.match)) match = *own;
        }
        rule.options = match.options;
        rule.by_corners = match.by_corners;
        if (left && rule.options.visual_tolerance > 0.25 * diagonal_of(bounds_of(rule.left.elements))) {
            fail(error("shape.anything-looks-alike",
                       "what may lie off by more than a quarter of the left side's breadth can be anything",
                       statement.match ? statement.match->span : rule.span));
        }
        if (left && rule.by_corners) read_corners(rule, statement.left->span);
        if (statement.weight) {
            const auto weight = number_of(*statement.weight);
            if (weight && *weight < 0) {
                fail(error("shape.negative-weight", "a weight must not be below 0", statement.weight->span));
            } else if (weight) {
                rule.weight = *weight;
            }
        }
        if (statement.priority) rule.priority = number_of(*statement.priority).value_or(0);
        for (const ExpressionPtr& unless : statement.unless) read_unless(*unless, rule);
        rule.condition = statement.condition.get();
        if (rule.condition != nullptr && !rule.by_corners) {
            for (const NameInExpression& name : names_in(*rule.condition)) {
                if (name.text != "area" && name.text != "first_side" && name.text != "second_side") continue;
                fail(error("shape.no-polygon-here", "'" + name.text + "' is known of polygons alone", name.span,
                           {"`match corners` finds polygons"}));
            }
        }
    }

    void read_drawn(const DrawnRule& drawn, SourceSpan file, Rule& rule) {
        rule.span = file;
        rule.left = shape_of_side(drawn.left);
        rule.right = shape_of_side(drawn.right);
        tell_doubts(file);
        for (const DrawnSide& unless : drawn.conditions) rule.forbidden.push_back(shape_of_side(unless));
        for (const Path& border : drawn.regions) {
            if (std::optional<Region> region = region_inside(border)) {
                rule.voids.push_back(std::move(*region));
            } else {
                fail(error("shape.open-region", "a void region of '" + drawn.name + "' does not close to one ring",
                           file));
            }
        }
        rule.options = default_match_.options;
        rule.by_corners = default_match_.by_corners;
        if (rule.by_corners) read_corners(rule, file);
    }
    Shape shape_of_side(const DrawnSide& side) {
        return maximal(elements_of(side, reading()), grammar_.tolerance, &doubts_);
    }

    void read_right_side(const Expression& right, Rule& rule) {
        if (!has_choice(right)) {
            if (const auto shape = shape_at(right)) rule.right = *shape;
            return;
        }
        // What it is in the middle of all its ranges tells whether it can be read at all.
        Evaluation at = evaluation();
        ChoiceMaking middle;
        middle.is_random = false;
        at.choices = &middle;
        Result<Value> value = evaluate(right, at);
        if (!value) return fail(value.diagnostics());
        Result<Shape> shape = shape_of(*value, reading());
        if (!shape) return fail(shape.diagnostics());
        rule.right = std::move(*shape);
        rule.right_side = &right;
    }

    void read_corners(Rule& rule, SourceSpan span) {
        const std::vector<curves::Face> faces = convex_faces(rule.left, grammar_.tolerance);
        const bool is_polygon = faces.size() == 1 && faces[0].corners.size() == rule.left.elements.size();
        if (is_polygon) {
            rule.corners = faces[0].corners;
        } else {
            fail(error("shape.no-polygon",
                       "`match corners` wants one convex polygon of straight lines on the left side", span,
                       {"such as rectangle(1, 1) or polygon(3, 1)"}));
        }
    }

    // A rule that looks for a label which neither the start nor any right side has never applies. What a right side
    // that draws at random may have is not known.
    void check_labels() {
        std::set<std::uint32_t> known;
        std::vector<std::string_view> names;
        const auto take = [&](const Shape& shape) {
            for (const Element& e : shape.elements) {
                if (e.kind == curves::ElementKind::point && known.insert(e.layer).second) {
                    names.push_back(grammar_.labels.at(e.layer));
                }
            }
        };
        take(grammar_.start);
        for (const Rule& rule : grammar_.rules) {
            if (rule.right_side != nullptr) return;
            take(rule.right);
        }
        for (const Rule& rule : grammar_.rules) {
            for (const Element& e : rule.left.elements) {
                if (e.kind != curves::ElementKind::point || known.contains(e.layer)) continue;
                const std::string& name = grammar_.labels.at(e.layer);
                const std::string what = name.empty() ? "a point without a label" : "the label '" + name + "'";
                fail(warning("shape.unknown-label", "nothing has " + what + ", so '" + rule.name + "' never applies",
                             rule.span, did_you_mean(name, names)));
                known.insert(e.layer);
            }
        }
    }

    void read_unless(const Expression& expression, Rule& rule) {
        const std::optional<Value> value = value_of(expression, evaluation());
        if (!value) return;
        if (is_region(*value)) {
            Result<Region> region = region_of(*value, reading());
            if (!region) return fail(region.diagnostics());
            rule.voids.push_back(std::move(*region));
            return;
        }
        Result<Shape> shape = shape_of(*value, reading());
        if (!shape) return fail(shape.diagnostics());
        if (shape->elements.empty()) {
            return fail(error("shape.empty-condition",
                              "an empty shape is part of every design, so the rule never applies", expression.span));
        }
        rule.forbidden.push_back(std::move(*shape));
    }

    void invert(Rule& rule, SourceSpan span) {
        if (rule.right_side != nullptr) {
            fail(error("shape.no-inverse", "the right side draws at random, so the rule has no inverse", span));
        } else if (rule.right.elements.empty()) {
            fail(error("shape.no-inverse", "the right side is empty, so the inverse would match everywhere", span));
        } else if (rule.by_corners) {
            fail(error("shape.no-inverse", "a rule that matches by corners has no inverse", span));
        }
        std::swap(rule.left, rule.right);
        // Conditions ask about matches of the other side.
        rule.forbidden.clear();
        rule.voids.clear();
        rule.condition = nullptr;
    }

    void mirror(Rule& rule, const NamedShapeRule& named) {
        double angle = 0;
        if (named.angle) {
            const std::optional<Value> value = value_of(*named.angle, evaluation());
            if (!value) return;
            const Result<double> degrees = as_angle(*value);
            if (!degrees) return fail(degrees.diagnostics());
            angle = *degrees;
        }
        if (rule.right_side != nullptr) {
            return fail(
                error("shape.no-mirror", "the right side draws at random, so the rule has no mirror image", rule.span));
        }
        const Transform turned = rotation_degrees(2 * angle);
        const Transform by = compose(turned, scaling(1, -1));
        for (Shape* side : {&rule.left, &rule.right}) *side = transformed(*side, by);
        for (Shape& shape : rule.forbidden) shape = transformed(shape, by);
        for (Region& region : rule.voids) region = transformed(region, by);
    }

    // --- steps by hand --------------------------------------------------------------------------------------------

    void read_steps(const ShapeRules& named) {
        std::size_t next = 0;
        for (const Statement& statement : document_.statements) {
            if (const auto* match = std::get_if<MatchStatement>(&statement.node)) {
                const auto rule = static_cast<std::uint32_t>(named.applies[next++].rule);
                read_match(*match, rule, statement.span);
            }
            if (const auto* back = std::get_if<BackStatement>(&statement.node)) read_back(*back, statement.span);
        }
    }

    void read_match(const MatchStatement& statement, std::uint32_t rule, SourceSpan span) {
        ApplyAt apply;
        apply.rule = rule;
        apply.span = span;
        apply.is_mirrored = statement.is_mirrored;
        apply.is_orbit = statement.is_orbit;
        if (statement.name) {
            apply.name = statement.name->text;
            if (apply.name == "start" || is_named(apply.name)) {
                fail(error("shape.name-twice", "a state is called '" + apply.name + "' already", statement.name->span));
            }
        }
        if (const std::optional<Value> at = value_of(*statement.at, evaluation())) {
            if (const Vec* place = std::get_if<Vec>(&at->data)) apply.place = *place;
        }
        if (statement.angle) {
            if (const std::optional<Value> value = value_of(*statement.angle, evaluation())) {
                const Result<double> angle = as_angle(*value);
                if (angle) apply.angle = *angle;
            }
        }
        if (statement.scale) apply.scale = number_of(*statement.scale);
        grammar_.by_hand.emplace_back(std::move(apply));
    }
    bool is_named(const std::string& name) const {
        return std::any_of(grammar_.by_hand.begin(), grammar_.by_hand.end(), [&](const auto& one) {
            const auto* apply = std::get_if<ApplyAt>(&one);
            return apply != nullptr && apply->name == name;
        });
    }
    void read_back(const BackStatement& statement, SourceSpan span) {
        const std::string& name = statement.name.text;
        if (name != "start" && !is_named(name)) {
            fail(error("shape.unknown-state", "no step above is called '" + name + "'", statement.name.span,
                       {"name it as in apply " + name + " = slide at (3, 3), or go back to start"}));
            return;
        }
        grammar_.by_hand.emplace_back(BackTo{name, span});
    }

    void refuse(const Statement& statement) {
        const auto say = [&](std::string_view what, std::string_view why) {
            fail(error("document.not-for-shapes",
                       "a shape grammar has no '" + std::string(what) + "': " + std::string(why), statement.span));
        };
        if (std::holds_alternative<SymmetryStatement>(statement.node)) {
            say("symmetry", "embed it in a document that has one, or write `apply ... orbit`");
        }
        if (std::holds_alternative<OperatorStatement>(statement.node)) say("operator", "its rules replace shapes");
        if (std::holds_alternative<GroupRule>(statement.node)) say("rule of tags", "write NAME = left -> right");
    }

    static bool asks_of_the_turn(const Expression& condition) {
        const std::vector<NameInExpression> names = names_in(condition);
        return std::any_of(names.begin(), names.end(),
                           [](const auto& name) { return name.text == "angle" || name.text == "mirrored"; });
    }

    // The symmetries of the left side, without those that change nothing of what the rule puts and asks.
    std::vector<Transform> variants_of(const Rule& rule) const {
        std::vector<Shape> conditions = rule.forbidden;
        for (const Region& region : rule.voids) {
            std::vector<Element> border;
            for (std::size_t i = 0; i < region.corners.size(); ++i) {
                border.push_back(
                    curves::line_element(region.corners[i], region.corners[(i + 1) % region.corners.size()]));
            }
            conditions.push_back(maximal(std::move(border), grammar_.tolerance));
        }
        const std::vector<curves::Symmetry> group = rule.options.group == curves::MatchGroup::affine
                                                        ? affine_symmetries(rule.left, rule.options)
                                                        : symmetries(rule.left, rule.options);
        std::vector<Transform> by;
        if (rule.condition != nullptr && asks_of_the_turn(*rule.condition)) {
            for (const curves::Symmetry& g : group) by.push_back(g.by);
            return by;
        }
        for (const curves::Symmetry& g : curves::variants(group, rule.right, conditions, 4 * grammar_.tolerance)) {
            by.push_back(g.by);
        }
        return by;
    }

    const Settings& settings_;
    const Document& document_;
    const ShapeSource& files_;
    curves::Ambiguities doubts_;
    Grammar grammar_;
    std::vector<DrawnRule> drawn_;
    std::vector<filigree::DrawnRule> drawn_names_;  // of the same
    MatchWord default_match_;
    Diagnostics problems_;
};

}  // namespace

Result<Grammar> read_grammar(const Settings& settings, const Document& document, const ShapeSource& files) {
    return Reader(settings, document, files).run();
}

}  // namespace filigree::shape
