#include "language/settings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/number_text.h"
#include "language/check.h"
#include "language/colour_words.h"
#include "language/functions.h"
#include "language/names.h"
#include "language/page_sizes.h"
#include "language/param_domain.h"
#include "language/shape_forms.h"
#include "language/walk.h"

namespace filigree {

namespace {

std::string quoted(std::string_view name) { return "'" + std::string(name) + "'"; }

class SettingsReader {
public:
    SettingsReader(const Document& document, const DocumentSite& site) : document_(document), site_(site) {}

    Result<Settings> run() {
        find_seed_and_definitions();
        walk_ = begin_walk(site_, document_, settings_.globals, settings_.seed);
        define_given();
        for (const Statement& statement : document_.statements) {
            std::visit([&](const auto& node) { read(statement, node); }, statement.node);
        }
        if (settings_.engine.empty()) {
            report(error("language.no-grammar", "the document does not say which kind of grammar it is", {0, 0, 0},
                         {"write 'grammar tangle' at its beginning"}));
        }
        if (has_errors(diagnostics_)) return std::move(diagnostics_);
        return {std::move(settings_), std::move(diagnostics_)};
    }

private:
    const Document& document_;
    const DocumentSite& site_;
    PresetWalk walk_;
    Settings settings_;
    Diagnostics diagnostics_;
    std::map<std::string, SourceSpan, std::less<>> defined_;  // where each name is defined first
    std::set<std::string, std::less<>> failed_;               // defined, but without a value: reported already
    std::map<std::string, SourceSpan, std::less<>> said_;     // statements that may stand once
    bool lets_hold_shapes_ = false;                           // below `grammar shape`

    void report(Diagnostic diagnostic) { diagnostics_.push_back(std::move(diagnostic)); }

    std::string line_of(SourceSpan span) const {
        if (span.file >= document_.sources.size()) return "another line";
        const SourceFile& source = document_.sources[span.file];
        std::string out = "line " + to_text(std::uint64_t{line_column(source.text, span.begin).line});
        if (span.file != 0) out += " of " + source.name;
        return out;
    }

    // --- names ---

    void find_seed_and_definitions() {
        for (const Statement& statement : document_.statements) {
            if (const auto* seed = std::get_if<SeedStatement>(&statement.node)) settings_.seed = seed->seed;
            if (const auto* grammar = std::get_if<GrammarStatement>(&statement.node)) {
                lets_hold_shapes_ = lets_hold_shapes_ || grammar->engine.text == "shape";
            }
            if (const auto* param = std::get_if<ParamStatement>(&statement.node)) define(param->name);
            if (const auto* let = std::get_if<LetStatement>(&statement.node)) define(let->name);
            if (const auto* palette = std::get_if<PaletteStatement>(&statement.node)) define(palette->name);
            if (const auto* page = std::get_if<PageStatement>(&statement.node)) {
                if (page->kind == PageStatement::Kind::fit) continue;
                defined_.emplace("page.width", statement.span);
                defined_.emplace("page.height", statement.span);
            }
        }
    }
    void define(const Name& name) { defined_.emplace(name.text, name.span); }

    // What the embedding document gives that is no `param` here: the parameters of a system.
    void define_given() {
        for (const auto& [name, value] : site_.given) {
            if (defined_.find(name) == defined_.end()) settings_.globals.names.emplace(name, value);
        }
    }
    const Value* given(std::string_view name) const {
        for (const auto& [known, value] : site_.given) {
            if (known == name) return &value;
        }
        return nullptr;
    }

    // Whether this is the name's first definition; warns of names that mean something else in rules.
    bool is_first_definition(const Name& name) {
        const SourceSpan first = defined_.find(name.text)->second;
        if (!(first == name.span) || !is_new(name)) {
            report(error("language.doubled-name", quoted(name.text) + " is already defined", name.span,
                         {"it is defined on " + line_of(first)}));
            return false;
        }
        if (lets_hold_shapes_ && name.text == "empty") {
            report(error("language.reserved-name", "'empty' is the shape that has nothing and cannot be a name",
                         name.span));
            return false;
        }
        const auto hides = [&name](std::span<const std::string_view> names) {
            return std::find(names.begin(), names.end(), name.text) != names.end();
        };
        if (hides(step_names()) || hides(shape_names())) {
            report(warning("language.hidden-name",
                           "in rules and styles " + quoted(name.text) + " is what is known of the shapes, not this",
                           name.span, {"give it another name"}));
        }
        return true;
    }
    bool is_new(const Name& name) const {
        return settings_.globals.names.find(name.text) == settings_.globals.names.end() &&
               failed_.find(name.text) == failed_.end();
    }
    void set_value(const Name& name, std::optional<Value> value) {
        if (value) {
            settings_.globals.names.emplace(name.text, std::move(*value));
        } else {
            failed_.insert(name.text);
        }
    }

    // Whether all names of the expression have values by now; reports those that get one later.
    bool names_are_known(const Expression& expression) {
        bool known = true;
        for (const NameInExpression& name : names_in(expression)) {
            if (settings_.globals.find(name.text) != nullptr) continue;
            const auto later = defined_.find(name.text);
            if (later == defined_.end()) continue;  // unknown: evaluating says so
            known = false;
            if (failed_.find(name.text) != failed_.end()) continue;
            report(error("language.used-before-definition", quoted(name.text) + " is used before it is defined",
                         name.span, {"it is defined on " + line_of(later->second)}));
        }
        return known;
    }

    Evaluation plain() const {
        Evaluation at;
        at.document = &document_;
        at.scope = &settings_.globals;
        at.site.seed = settings_.seed;
        return at;
    }
    // Where the choices of a definition are made.
    Evaluation of_definition(const Name& name) const {
        Evaluation at = plain();
        at.site = {settings_.seed, rooted(site_, definition_key(name.text)), name.text};
        return at;
    }
    std::optional<Value> value_of(const Expression& expression, const Evaluation& at) {
        if (!names_are_known(expression)) return std::nullopt;
        Diagnostics problems = check_expression(expression, at);
        if (problems.empty()) {
            Result<Value> value = evaluate(expression, at);
            if (value) return std::move(*value);
            problems = std::move(value).diagnostics();
        }
        append(diagnostics_, std::move(problems));
        return std::nullopt;
    }
    // The value of a definition: what presets say of let/NAME, else its own.
    std::optional<Value> defined_value(const Name& name, const Expression& expression, const Evaluation& at) {
        if (!names_are_known(expression)) return std::nullopt;
        Diagnostics problems = check_expression(expression, at);
        if (problems.empty()) {
            const PresetNode node = definition_node(walk_, name.text);
            const Result<StepChoices> choices = choices_at(walk_, node, settings_.globals, &settings_.definitions);
            Result<Value> value = choices ? evaluate_with(*choices, "", expression, at) : choices.diagnostics();
            if (value) return std::move(*value);
            problems = std::move(value).diagnostics();
        }
        append(diagnostics_, std::move(problems));
        return std::nullopt;
    }
    // A conversion's value, or none and its problems at the expression.
    template <class T>
    std::optional<T> taken(Result<T> result, const Expression& expression) {
        if (result) return std::move(*result);
        for (Diagnostic problem : result.diagnostics()) {
            problem.span = expression.span;
            report(std::move(problem));
        }
        return std::nullopt;
    }
    std::optional<double> length_of(const ExpressionPtr& expression) {
        if (!expression) return std::nullopt;
        const std::optional<Value> value = value_of(*expression, plain());
        if (!value) return std::nullopt;
        return taken(as_length(*value, document_), *expression);
    }

    bool is_first_statement(std::string_view what, SourceSpan span) {
        const auto [first, is_first] = said_.emplace(std::string(what), span);
        if (!is_first) {
            report(error("language.repeated-statement", quoted(what) + " is already given", span,
                         {"it is given on " + line_of(first->second)}));
        }
        return is_first;
    }

    // --- statements ---

    void read(const Statement&, const VersionStatement&) {}
    void read(const Statement&, const SeedStatement&) {}
    void read(const Statement&, const UnitStatement&) {}
    void read(const Statement&, const IncludeStatement&) {}
    void read(const Statement&, const StartStatement&) {}  // derivation/plane_start.h knows the shapes
    void read(const Statement&, const StyleStatement& style) { settings_.styles.push_back(&style); }
    void read(const Statement&, const PresetStatement&) {}  // presets.h
    void read(const Statement&, const KeepStatement&) {}
    void read(const Statement&, const RerollStatement&) {}
    // Read by the engine of words.
    void read(const Statement&, const WordRule&) {}
    void read(const Statement&, const MacroStatement&) {}
    void read(const Statement&, const CellStatement&) {}
    void read(const Statement&, const SettingStatement&) {}
    void read(const Statement&, const RestStatement&) {}
    void read(const Statement&, const LoopStatement&) {}
    void read(const Statement&, const WordEditStatement&) {}
    // Read by the engine of shapes.
    void read(const Statement&, const ShapeRule&) {}
    void read(const Statement&, const RulesFromStatement&) {}
    void read(const Statement&, const MatchStatement&) {}
    void read(const Statement&, const BackStatement&) {}
    void read(const Statement&, const ApplyStatement& apply) { settings_.applies.push_back(&apply); }
    void read(const Statement&, const OperatorStatement& macro) { settings_.operators.push_back(&macro); }
    void read(const Statement&, const SystemStatement& system) { settings_.systems.push_back(&system); }
    void read(const Statement& statement, const GroupRule& rule) {
        settings_.rules.push_back(&rule);
        settings_.rule_spans.push_back(statement.span);
    }
    void read(const Statement& statement, const SymmetryStatement& symmetry) {
        if (is_first_statement("symmetry", statement.span)) settings_.symmetry = symmetry.group;
    }
    void read(const Statement& statement, const GrammarStatement& grammar) {
        if (!is_first_statement("grammar", statement.span)) return;
        settings_.engine = grammar.engine.text;
        settings_.engine_span = grammar.engine.span;
    }

    void read(const Statement& statement, const ResolutionStatement& resolution) {
        // The document's own goes before that of a file that it includes.
        const std::string what = statement.span.file == 0 ? "resolution" : "included resolution";
        const bool counts = is_first_statement(what, statement.span);
        const std::optional<double> px = length_of(resolution.value);
        if (!px) return;
        if (!(*px >= 1e-6 && *px <= 1e6)) {
            report(error("language.out-of-range",
                         "the resolution must be from 0.000001px to 1000000px, but this is " + to_text(*px) + "px",
                         resolution.value->span));
        } else if (counts && (statement.span.file == 0 || said_.find("resolution") == said_.end())) {
            settings_.resolution = *px;
        }
    }

    void read(const Statement&, const LetStatement& let) {
        if (!is_first_definition(let.name)) return;
        const Evaluation at = of_definition(let.name);
        set_value(let.name, defined_value(let.name, *let.value, lets_hold_shapes_ ? with_shapes(at) : at));
    }

    void read(const Statement&, const PaletteStatement& palette) {
        if (!is_first_definition(palette.name)) return;
        set_value(palette.name, palette_of(palette));
    }
    std::optional<Value> palette_of(const PaletteStatement& palette) {
        if (find_function(palette.name.text) != nullptr || is_special_form(palette.name.text)) {
            report(error("language.reserved-name",
                         quoted(palette.name.text) + " is a function and cannot name a palette", palette.name.span));
            return std::nullopt;
        }
        Evaluation at = of_definition(palette.name);
        at.words = colour_words_beside(&settings_.globals);
        std::optional<Value> value = defined_value(palette.name, *palette.colours, at);
        if (!value) return std::nullopt;
        ValueList* list = std::get_if<ValueList>(&value->data);
        if (list == nullptr || list->items.empty()) {
            report(error("language.wrong-kind", "a palette is a list of colours, as in [#000, #a03020]",
                         palette.colours->span));
            return std::nullopt;
        }
        bool complete = true;
        for (Value& item : list->items) {
            const Result<Colour> colour = as_colour(item);
            complete = complete && colour;
            if (colour) {
                item.data = *colour;
            } else {
                append(diagnostics_, colour.diagnostics());
            }
        }
        if (!complete) return std::nullopt;
        return value;
    }

    // --- parameters ---

    void read(const Statement&, const ParamStatement& param) {
        if (!is_first_definition(param.name)) return;
        set_value(param.name, param_value(param));
    }
    std::optional<Value> param_value(const ParamStatement& param) {
        Evaluation at = of_definition(param.name);
        if (param.domain) at.words = words_of(*param.domain);
        std::optional<ParamDomain> domain;
        if (param.domain && !(domain = domain_of(*param.domain, at))) return std::nullopt;
        const std::optional<Quantity> step = step_of(param);
        if (param.step && !step) return std::nullopt;
        at.whole = step && is_bare(*step) && is_whole(step->value) &&
                   (!domain || !domain->range || is_whole(domain->range->first.value));

        // A normal(...) with a domain is kept in it.
        const CallExpression* call = std::get_if<CallExpression>(&param.value->node);
        const Expression kept{param.value->span, WithinExpression{param.value, param.domain}};
        const bool is_kept = call != nullptr && call->name == "normal" && domain && domain->range;

        std::optional<Value> value;
        const Value* known = given(param.name.text);
        if (known != nullptr) {
            value = given_value(param.name, *known, at);
        } else {
            value = defined_value(param.name, is_kept ? kept : *param.value, at);
        }
        if (!value || !domain) return value;
        std::optional<Diagnostic> problem = end_outside(*param.value, at, *domain);
        // A preset's value stands elsewhere.
        const SourceSpan place = known != nullptr ? param.value->span : value->span;
        if (!problem) problem = outside(*domain, *value, document_, place);
        if (!problem) return value;
        report(std::move(*problem));
        return std::nullopt;
    }
    // What the embedding document gives for a parameter, unless a preset says otherwise.
    std::optional<Value> given_value(const Name& name, const Value& given, const Evaluation& at) {
        const PresetNode node = definition_node(walk_, name.text);
        const Result<StepChoices> choices = choices_at(walk_, node, settings_.globals, &settings_.definitions);
        Result<std::optional<Value>> preset =
            choices ? preset_value(*choices, "", at) : Result<std::optional<Value>>(choices.diagnostics());
        if (preset) return preset->value_or(given);
        append(diagnostics_, std::move(preset).diagnostics());
        return std::nullopt;
    }
    static bool is_whole(double value) { return value == std::round(value); }

    // The bare words of a list domain: `param kind = line in [line, wave]`.
    std::vector<std::string_view> words_of(const Expression& domain) const {
        std::vector<std::string_view> words;
        for (const ExpressionPtr& item : items_of_domain(domain)) {
            const auto* name = item ? std::get_if<NameReference>(&item->node) : nullptr;
            if (name != nullptr && defined_.find(name->name) == defined_.end()) words.push_back(name->name);
        }
        return words;
    }

    std::optional<ParamDomain> domain_of(const Expression& expression, const Evaluation& at) {
        if (const auto* range = std::get_if<RangeExpression>(&expression.node)) {
            const std::optional<Value> low = value_of(*range->low, plain());
            const std::optional<Value> high = value_of(*range->high, plain());
            if (!low || !high) return std::nullopt;
            return taken(range_domain(*low, *high, document_, expression.span), expression);
        }
        const std::vector<ExpressionPtr> items = items_of_domain(expression);
        if (items.empty()) {
            report(error("language.wrong-kind", "a domain is a range or a list, as in 10..60 or [1, 2, 5]",
                         expression.span));
            return std::nullopt;
        }
        ParamDomain domain;
        for (const ExpressionPtr& item : items) {
            std::optional<Value> value = value_of(*item, at);
            if (!value) return std::nullopt;
            domain.alternatives.push_back(std::move(*value));
        }
        return domain;
    }

    std::optional<Quantity> step_of(const ParamStatement& param) {
        if (!param.step) return std::nullopt;
        const std::optional<Value> value = value_of(*param.step, plain());
        if (!value) return std::nullopt;
        const Quantity* step = std::get_if<Quantity>(&value->data);
        if (step != nullptr && step->value > 0) return *step;
        report(error("language.wrong-kind", "a step must be a number above zero", param.step->span));
        return std::nullopt;
    }

    // The ends of a choice must lie in the domain too, whatever is drawn with this seed.
    std::optional<Diagnostic> end_outside(const Expression& expression, const Evaluation& at,
                                          const ParamDomain& domain) const {
        for (const Alternative& alternative : alternatives_of(expression)) {
            if (alternative.kind != Alternative::Kind::range_end || has_choice(*alternative.expression)) continue;
            const Result<Value> end = evaluate(*alternative.expression, at);
            if (!end) continue;
            if (auto problem = outside(domain, *end, document_, alternative.expression->span)) return problem;
        }
        return std::nullopt;
    }

    // --- page, limits ---

    void read(const Statement& statement, const PageStatement& page) {
        if (!is_first_statement("page", statement.span)) return;
        std::optional<Page> result = page_of(page);
        if (!result) {
            failed_.insert({"page.width", "page.height"});
            return;
        }
        settings_.page = *result;
        if (page.kind == PageStatement::Kind::fit) return;
        settings_.globals.names.emplace("page.width", Value{Quantity{result->width, 1, false}, statement.span});
        settings_.globals.names.emplace("page.height", Value{Quantity{result->height, 1, false}, statement.span});
    }
    std::optional<Page> page_of(const PageStatement& page) {
        Page out;
        out.kind = page.kind;
        if (page.kind == PageStatement::Kind::named) {
            const PageSize* size = find_page_size(page.name.text);
            if (size == nullptr) {
                const std::vector<std::string_view> names = page_size_names();
                std::vector<std::string> hints = did_you_mean(page.name.text, names);
                if (hints.empty()) hints.push_back("the named pages are " + quoted_alternatives(names));
                report(error("language.unknown-page", "there is no page " + quoted(page.name.text), page.name.span,
                             std::move(hints)));
                return std::nullopt;
            }
            out.width = to_px(size->width_mm, Unit::mm);
            out.height = to_px(size->height_mm, Unit::mm);
            out.in_mm = true;
        } else if (page.kind != PageStatement::Kind::fit) {
            const std::optional<double> width = side_of(page.width), height = side_of(page.height);
            if (!width || !height) return std::nullopt;
            out.width = *width;
            out.height = *height;
            out.in_mm = is_metric(*page.width) && is_metric(*page.height);
        }
        if (!page.margin) return out;
        out.margin = length_of(page.margin);
        if (!out.margin) return std::nullopt;
        const double room = std::min(out.width, out.height);
        const bool too_wide = page.kind != PageStatement::Kind::fit && *out.margin * 2 >= room;
        if (*out.margin >= 0 && *out.margin <= largest_side && !too_wide) return out;
        report(error("language.out-of-range",
                     too_wide ? "the margins leave no room on the page" : "a margin must be from 0px to 1000000px",
                     page.margin->span));
        return std::nullopt;
    }
    static constexpr double largest_side = 1e6;
    std::optional<double> side_of(const ExpressionPtr& expression) {
        const std::optional<double> px = length_of(expression);
        if (!px || (*px > 0 && *px <= largest_side)) return px;
        report(error("language.out-of-range", "a side of the page must be above 0px and at most 1000000px",
                     expression->span));
        return std::nullopt;
    }
    // Whether a length was written in metric units: by its literals, or by the unit of the file.
    bool is_metric(const Expression& root) const {
        const auto metric = [](Unit unit) { return unit == Unit::mm || unit == Unit::cm || unit == Unit::m; };
        std::vector<const Expression*> open{&root};
        bool any_unit = false;
        while (!open.empty()) {
            const Expression& expression = *open.back();
            open.pop_back();
            if (const auto* number = std::get_if<NumberLiteral>(&expression.node)) {
                if (metric(number->unit)) return true;
                any_unit = any_unit || is_length_unit(number->unit);
            }
            for (const PlacedExpression& part : parts_of(expression)) open.push_back(part.expression);
        }
        return !any_unit && metric(bare_unit(&document_, root.span));
    }

    void read(const Statement& statement, const LimitStatement& limit) {
        constexpr std::string_view names[] = {"elements", "memory", "depth"};
        const std::string_view name = limit.name.text;
        if (std::find(std::begin(names), std::end(names), name) == std::end(names)) {
            std::vector<std::string> hints = did_you_mean(name, {std::begin(names), std::end(names)});
            if (hints.empty()) hints.push_back("the limits are " + quoted_alternatives(names));
            report(error("language.unknown-limit", "there is no limit " + quoted(name), limit.name.span,
                         std::move(hints)));
            return;
        }
        const bool is_first = is_first_statement("limit " + std::string(name), statement.span);
        const std::optional<Value> value = value_of(*limit.value, plain());
        if (!value) return;
        const std::optional<double> number = taken(as_number(*value), *limit.value);
        if (!number || !is_first) return;
        const double most = name == "depth" ? 1e5 : name == "elements" ? 1e12 : 1e15;
        if (!(*number >= 1 && *number <= most) || !is_whole(*number)) {
            report(error(
                "language.out-of-range",
                "this limit must be a whole number from 1 to " + to_text(most) + ", but this is " + to_text(*number),
                limit.value->span));
            return;
        }
        if (name == "elements") settings_.limits.elements = static_cast<std::uint64_t>(*number);
        if (name == "memory") settings_.limits.memory_bytes = static_cast<std::uint64_t>(*number);
        if (name == "depth") settings_.limits.depth = static_cast<std::uint32_t>(*number);
    }
};

}  // namespace

Result<Settings> read_settings(const Document& document, const DocumentSite& site) {
    return SettingsReader(document, site).run();
}

Key definition_key(std::string_view name) { return Key{hash_text("let/" + std::string(name))}; }

}  // namespace filigree
