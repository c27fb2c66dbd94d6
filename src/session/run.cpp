#include "session/run.h"

#include "derivation/symmetric_drawing.h"
#include "engines/rewriting/verify.h"
#include "engines/shape/verify.h"
#include "engines/tangle/derive.h"
#include "engines/tangle/verify.h"
#include "session/embed.h"

namespace filigree {
namespace {

DocumentSite top_site(const CheckedDocument& checked, const RunOptions& options) {
    DocumentSite site;
    site.replay = options.replay != nullptr ? options.replay : checked.replay.get();
    return site;
}

std::string_view keyword_of(PresetKind kind) {
    switch (kind) {
        case PresetKind::set:
            return "set";
        case PresetKind::fallback:
            return "default";
        case PresetKind::keep:
            return "keep";
        case PresetKind::reroll:
            return "reroll";
        case PresetKind::apply:
            return "apply";
    }
    return "";
}

// Those of `presets` that met nothing; `met` has an entry for each.
std::vector<UnmatchedPreset> unmatched_presets(const Presets& presets, const std::vector<bool>& met) {
    std::vector<UnmatchedPreset> unmatched;
    for (std::size_t i = 0; i < presets.all.size(); ++i) {
        if (met[i]) continue;
        const Preset& preset = presets.all[i];
        unmatched.push_back({std::string(keyword_of(preset.kind)), to_text(*preset.path), preset.path->span});
    }
    return unmatched;
}

// The document's own presets come first in the list: those of embedded documents are checked as possible.
std::vector<UnmatchedPreset> unmatched_in_run(const OpenedDocument& opened, const CheckedDocument& checked,
                                              const Run& run) {
    const PresetWalk walk = begin_walk({}, opened.document, checked.settings->globals, checked.settings->seed);
    std::vector<bool> met(walk.presets.all.size());
    const std::vector<std::uint8_t>& derived = run.design ? run.design->derivation.met : run.tangle.met;
    for (std::size_t i = 0; i < met.size(); ++i) {
        met[i] = derived[i] != 0 || (i < run.picture.met.size() && run.picture.met[i] != 0);
    }
    return unmatched_presets(walk.presets, met);
}

// A name behind `let` is there if it is possible.
std::vector<UnmatchedPreset> unmatched_in_word(const rewriting::WordChoices& choices) {
    const std::vector<std::uint8_t> reached = choices.met();
    std::vector<bool> met(reached.size());
    for (std::size_t i = 0; i < met.size(); ++i) {
        met[i] = reached[i] != 0 || choices.presets().all[i].path->segments.front().name == "let";
    }
    return unmatched_presets(choices.presets(), met);
}

Diagnostics unmatched_warnings(const std::vector<UnmatchedPreset>& unmatched) {
    Diagnostics warnings;
    for (const UnmatchedPreset& preset : unmatched) {
        warnings.push_back(warning(
            "preset.unmatched",
            "'" + preset.path + "' is nowhere in this derivation, so the '" + preset.statement + "' does nothing now",
            preset.span));
    }
    return warnings;
}

}  // namespace

Result<tangle::Tangle> derive_document(const OpenedDocument& opened, const CheckedDocument& checked,
                                       const RunOptions& options, Executor& executor, const Job& job) {
    tangle::DeriveOptions derive;
    derive.steps = options.steps;
    derive.previous = options.previous;
    derive.site = top_site(checked, options);
    derive.embed = embed_function(opened, options.lists_choices, job);
    derive.shapes = checked.shapes.get();
    return tangle::derive(*checked.grammar, *checked.start, *checked.settings, opened.document, derive, executor, job);
}

namespace {

// What is to be said of the choices of a word.
void note_choices(Run& run) {
    const std::shared_ptr<rewriting::WordChoices>& choices = run.word->derivation.choices;
    if (!choices) return;
    run.unmatched = unmatched_in_word(*choices);
    append(run.diagnostics, unmatched_warnings(run.unmatched));
    if (choices->left_out() == 0) return;
    run.diagnostics.push_back(warning("choices.too-many", std::to_string(choices->left_out()) +
                                                              " choices more were made than are listed, which are " +
                                                              std::to_string(choices->made().size())));
}

Result<Run> run_word(const OpenedDocument& opened, const CheckedDocument& checked, const RunOptions& options,
                     Executor& executor, const Job& job) {
    const double begin = now_seconds();
    WordOptions wanted;
    wanted.steps = options.steps;
    wanted.site = top_site(checked, options);
    wanted.records_choices = options.lists_choices;
    if (!options.draws) {
        Result<rewriting::Derivation> derivation = derive_word(opened, checked, wanted, executor, job);
        if (!derivation) return derivation.diagnostics();
        Run run;
        run.diagnostics = derivation.diagnostics();
        run.times.derive = now_seconds() - begin;
        run.word = WordRun{std::move(*derivation), {}};
        note_choices(run);
        return run;
    }
    Result<DrawnWord> drawn = draw_word(opened, checked, wanted, executor, job);
    if (!drawn) return drawn.diagnostics();
    Run run;
    run.diagnostics = drawn.diagnostics();
    run.times.derive = drawn->derived - begin;
    run.times.draw = now_seconds() - drawn->derived;
    run.drawing = std::move(drawn->drawing);
    run.word = std::move(drawn->run);
    note_choices(run);
    if (options.verify) {
        report(job, "verify", -1);
        run.broken = rewriting::broken_invariants(run.word->derivation);
        for (std::string& broken : rewriting::broken_invariants(run.drawing)) run.broken.push_back(std::move(broken));
        run.verified = true;
    }
    return run;
}

Result<Run> run_design(const OpenedDocument& opened, const CheckedDocument& checked, const RunOptions& options,
                       const Job& job) {
    const double begin = now_seconds();
    const DesignOptions wanted{options.steps, top_site(checked, options)};
    Run run;
    if (!options.draws) {
        Result<shape::Derivation> derivation = derive_design(opened, checked, wanted, job);
        if (!derivation) return derivation.diagnostics();
        run.diagnostics = derivation.diagnostics();
        run.times.derive = now_seconds() - begin;
        run.design = DesignRun{std::move(*derivation), 1, {}};
    } else {
        Result<DrawnDesign> drawn = draw_design(opened, checked, wanted, job);
        if (!drawn) return drawn.diagnostics();
        run.diagnostics = drawn.diagnostics();
        run.times.derive = drawn->derived - begin;
        run.times.draw = now_seconds() - drawn->derived;
        run.drawing = std::move(drawn->drawing);
        run.design = std::move(drawn->run);
    }
    run.unmatched = unmatched_in_run(opened, checked, run);
    append(run.diagnostics, unmatched_warnings(run.unmatched));
    if (options.verify) {
        report(job, "verify", -1);
        run.broken = shape::broken_invariants(run.design->derivation, *checked.design);
        run.verified = true;
    }
    return run;
}

}  // namespace

Result<Run> run_document(const OpenedDocument& opened, const CheckedDocument& checked, const RunOptions& options,
                         Executor& executor, const Job& job) {
    if (checked.words) return run_word(opened, checked, options, executor, job);
    if (checked.design) return run_design(opened, checked, options, job);
    Run run;
    const Settings& settings = *checked.settings;
    const double begin = now_seconds();
    Result<tangle::Tangle> tangle = derive_document(opened, checked, options, executor, job);
    if (!tangle) return tangle.diagnostics();
    run.tangle = std::move(*tangle);
    const double derived = now_seconds();
    run.times.derive = derived - begin;

    Result<tangle::Picture> picture =
        tangle::draw(run.tangle, *checked.grammar, settings, opened.document,
                     {options.colour_by, top_site(checked, options), {job.cancel_flag, {}}});
    if (!picture) return picture.diagnostics();
    append(run.diagnostics, picture.diagnostics());
    run.picture = std::move(*picture);
    run.drawing = std::move(run.picture.drawing);
    if (checked.start->symmetry) {
        Result<Drawing> all = repeated_over_page(run.drawing, *checked.start, settings, {job.cancel_flag, {}});
        if (!all) return all.diagnostics();
        append(run.diagnostics, all.diagnostics());
        run.drawing = std::move(*all);
    }
    run.times.draw = now_seconds() - derived;

    run.unmatched = unmatched_in_run(opened, checked, run);
    append(run.diagnostics, unmatched_warnings(run.unmatched));
    if (options.verify) {
        report(job, "verify", -1);
        run.broken = tangle::broken_invariants(run.tangle);
        for_each_embedded(run.tangle, [&](const EmbeddedTangle& inner) {
            for (const std::string& broken : tangle::broken_invariants(inner.tangle)) {
                run.broken.push_back("in '" + inner.opened->name + "': " + broken);
            }
        });
        run.verified = true;
    }
    return run;
}

}  // namespace filigree
