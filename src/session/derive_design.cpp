#include "session/derive_design.h"

#include "session/derive_word.h"

namespace filigree {

shape::Surroundings surroundings_of(const OpenedDocument& opened, const CheckedDocument& checked) {
    return {*checked.settings, opened.document, *checked.shapes};
}

Result<shape::Derivation> derive_design(const OpenedDocument& opened, const CheckedDocument& checked,
                                        const DesignOptions& options, const Job& job) {
    shape::DeriveOptions derive{options.steps, options.site, options.by_hand_alone};
    if (derive.site.replay == nullptr) derive.site.replay = checked.replay.get();
    return shape::derive(*checked.design, surroundings_of(opened, checked), derive, job);
}

Result<DrawnDesign> draw_design(const OpenedDocument& opened, const CheckedDocument& checked,
                                const DesignOptions& options, const Job& job) {
    Result<shape::Derivation> derivation = derive_design(opened, checked, options, job);
    if (!derivation) return derivation.diagnostics();
    Diagnostics warnings = derivation.diagnostics();
    const double derived = now_seconds();
    Result<shape::Picture> picture = shape::draw(*derivation, *checked.design, surroundings_of(opened, checked),
                                                 {options.site.root, {job.cancel_flag, {}}});
    if (!picture) return picture.diagnostics();
    append(warnings, picture.diagnostics());
    DrawnDesign drawn{
        {std::move(*derivation), picture->scale, std::move(picture->elements)}, std::move(picture->drawing), derived};
    return {std::move(drawn), std::move(warnings)};
}

}  // namespace filigree
