#include "session/derive_word.h"

#include <algorithm>
#include <chrono>

#include "engines/rewriting/edit_step.h"
#include "engines/rewriting/plain.h"

namespace filigree {
namespace {

// The words of the documents that edits name.
rewriting::OtherDocument other_documents(const OpenedDocument& opened, const CheckedDocument& checked,
                                         Executor& executor, const Job& job) {
    return [&](const std::string& name) -> Result<std::u32string> {
        for (std::size_t i = 0; i < opened.embedded.size(); ++i) {
            const EmbeddedDocument& inner = opened.embedded[i];
            if (!inner.info.is_file || inner.info.name != name || !inner.opened) continue;
            const bool is_checked = i < checked.embedded.size() && checked.embedded[i];
            const CheckedDocument own = is_checked ? CheckedDocument() : check_document(*inner.opened);
            const Result<rewriting::Derivation> word =
                derive_word(*inner.opened, is_checked ? *checked.embedded[i] : own, {}, executor, job);
            if (!word) return at_first_source(word.diagnostics(), *inner.opened);
            return rewriting::letters_of(word->word, word->alphabet);
        }
        return error("rewriting.unknown-document", "there is no document '" + name + "'", {},
                     {"the name of another document stands in the edit itself"});
    };
}

std::uint64_t seed_of(const CheckedDocument& checked, const DocumentSite& site) {
    return site.is_embedded ? site.host.seed.value : checked.settings->seed;
}

// Whether it says something of another place than of a name behind `let`.
bool is_of_word(const Preset& preset) { return preset.path->segments.front().name != "let"; }

// Null where everything is drawn and nobody asks what.
std::shared_ptr<rewriting::WordChoices> word_choices(const OpenedDocument& opened, const CheckedDocument& checked,
                                                     const WordOptions& options) {
    DocumentSite site = options.site;
    if (site.replay == nullptr) site.replay = checked.replay.get();
    PresetWalk walk = begin_walk(site, opened.document, checked.settings->globals, checked.settings->seed);
    rewriting::WordChoiceOptions wanted;
    wanted.records = options.records_choices;
    wanted.follows_presets = std::any_of(walk.presets.all.begin(), walk.presets.all.end(), is_of_word);
    if (!wanted.records && !wanted.follows_presets && walk.replay == nullptr) return nullptr;
    return std::make_shared<rewriting::WordChoices>(std::move(walk), wanted);
}

// Where the document says the limit that was reached; else how often it derives.
Diagnostics at_limit(Diagnostics problems, const Document& document) {
    for (Diagnostic& problem : problems) {
        if (problem.span.file != SourceSpan::no_file || !problem.code.starts_with("limit.")) continue;
        for (const Statement& statement : document.statements) {
            const auto* limit = std::get_if<LimitStatement>(&statement.node);
            const auto* setting = std::get_if<SettingStatement>(&statement.node);
            const bool is_limit = limit != nullptr && problem.code == "limit." + limit->name.text;
            const bool is_count = setting != nullptr && setting->name.text == "iterations";
            if (is_limit || (is_count && problem.span.file == SourceSpan::no_file)) problem.span = statement.span;
            if (is_limit) break;
        }
    }
    return problems;
}

}  // namespace

double now_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

rewriting::DeriveOptions word_options(const OpenedDocument& opened, const CheckedDocument& checked,
                                      const WordOptions& options) {
    rewriting::DeriveOptions derive;
    derive.seed = seed_of(checked, options.site);
    derive.root = options.site.root;
    derive.choices = word_choices(opened, checked, options);
    derive.limits = checked.settings->limits;
    derive.limits.elements = std::min(derive.limits.elements, options.most_elements);
    derive.document = &opened.document;
    derive.globals = &checked.settings->globals;
    const std::vector<rewriting::WordEdit>& edits = checked.words->edits;
    const bool edits_ask = std::any_of(edits.begin(), edits.end(),
                                       [](const rewriting::WordEdit& edit) { return rewriting::asks_for_ages(edit); });
    derive.with_ages =
        options.with_ages || edits_ask || rewriting::asks_for_ages(*checked.draw_rules, *checked.settings);
    derive.positions = [&opened, &checked](const rewriting::Derivation& at) -> Result<std::vector<Vec>> {
        Diagnostics problems;
        const rewriting::TurtleSettings turtle =
            rewriting::turtle_settings(*checked.draw_rules, at.iteration, *checked.settings, opened.document, problems);
        Result<std::vector<Vec>> positions =
            rewriting::symbol_positions(at.word, at.alphabet, turtle, checked.settings->limits.elements);
        if (!problems.empty()) return problems;
        return positions;
    };
    return derive;
}

Result<rewriting::Derivation> derive_word(const OpenedDocument& opened, const CheckedDocument& checked,
                                          const WordOptions& wanted, Executor& executor, const Job& job) {
    const rewriting::Grammar& grammar = *checked.words;
    const rewriting::DeriveOptions options = word_options(opened, checked, wanted);
    const auto finished = [&](rewriting::Derivation derivation, Diagnostics warnings = {}) {
        if (options.choices) options.choices->stop_recording();
        return Result<rewriting::Derivation>(std::move(derivation), std::move(warnings));
    };
    const rewriting::OtherDocument others = other_documents(opened, checked, executor, job);
    Diagnostics warnings;
    const auto edit = [&](rewriting::Derivation& derivation, rewriting::EditTime time) {
        append(warnings, rewriting::apply_edits(derivation, grammar, time, options, others, job));
        return !has_errors(warnings);
    };
    Result<rewriting::Derivation> derivation = rewriting::begin(grammar, options);
    if (!derivation) return at_limit(derivation.diagnostics(), opened.document);
    const std::uint64_t count = wanted.steps.value_or(grammar.systems[0].iterations);
    if (const auto plain = rewriting::plain_substitution(*derivation, grammar)) {
        std::optional<Diagnostic> problem =
            rewriting::step_plainly(*derivation, *plain, count, options.limits, executor);
        if (problem) return at_limit({std::move(*problem)}, opened.document);
        return finished(std::move(*derivation));
    }
    for (std::uint64_t i = 0; i < count; ++i) {
        report(job, "derive", static_cast<double>(i) / static_cast<double>(count));
        if (is_cancelled(job)) return cancelled_diagnostic();
        if (std::optional<Diagnostic> problem = rewriting::step(*derivation, grammar, options, job)) {
            return at_limit({std::move(*problem)}, opened.document);
        }
        if (!edit(*derivation, rewriting::EditTime::iteration)) return warnings;
    }
    if (!edit(*derivation, rewriting::EditTime::end)) return warnings;
    return finished(std::move(*derivation), std::move(warnings));
}

Result<DrawnWord> draw_word(const OpenedDocument& opened, const CheckedDocument& checked, const WordOptions& options,
                            Executor& executor, const Job& job) {
    Result<rewriting::Derivation> derivation = derive_word(opened, checked, options, executor, job);
    if (!derivation) return derivation.diagnostics();
    Diagnostics warnings = derivation.diagnostics();
    const double derived = now_seconds();
    const rewriting::DrawOptions draw{options.site.root, checked.shapes.get(), {job.cancel_flag, {}}};
    Result<rewriting::Picture> picture =
        rewriting::draw(*derivation, *checked.draw_rules, *checked.settings, opened.document, draw);
    if (!picture) return at_limit(picture.diagnostics(), opened.document);
    append(warnings, picture.diagnostics());
    ChoiceRecorder recorder;
    recorder.append(checked.settings->definitions);
    WordRun run{std::move(*derivation), std::move(recorder.choices), seed_of(checked, options.site)};
    DrawnWord drawn{std::move(run), std::move(picture->drawing), derived};
    return {std::move(drawn), std::move(warnings)};
}

}  // namespace filigree
