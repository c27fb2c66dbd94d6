#include "engines/shape/enumerate.h"

namespace filigree::shape {

Result<FoundDesigns> enumerate(const Grammar& grammar, const curves::Shape& from, const Surroundings& around,
                               const EnumerateOptions& options, const Job& job) {
    FoundDesigns found;
    found.all.push_back({from, 0, 0, {}, 1});
    curves::DesignSet known(options.up_to, grammar.tolerance);
    known.find_or_add(from, 0);
    for (std::uint32_t d = 0; d < found.all.size(); ++d) {
        const std::uint32_t depth = found.all[d].depth;
        if (depth == options.depth) break;
        report(job, "enumerate", static_cast<double>(d) / static_cast<double>(found.all.size()));
        const curves::Shape design = found.all[d].design;
        SeenDesign seen(grammar, design, depth);
        std::optional<double> priority;  // of the rules that apply here
        for (const std::uint32_t r : automatic_rules(grammar)) {
            if (priority && grammar.rules[r].priority < *priority) break;
            const Result<Applications> here = applications_of(grammar, r, seen, around, job);
            if (!here) return here.diagnostics();
            if (!here->all.empty()) priority = grammar.rules[r].priority;
            for (const Application& at : here->all) {
                if (is_cancelled(job)) return cancelled_diagnostic();
                Derivation one;
                one.design = design;
                one.made_by.assign(design.elements.size(), 0);
                StepChoices middle;
                middle.is_random = false;
                const Result<curves::Shape> put = put_by(grammar, at, 0, {}, around, middle);
                if (!put) return put.diagnostics();
                apply_rule(one, grammar, {at}, {*put});
                const auto number = static_cast<std::uint32_t>(found.all.size());
                if (const auto twin = known.find_or_add(one.design, number)) {
                    ++found.all[*twin].ways;
                    continue;
                }
                if (found.all.size() == options.most) {
                    found.is_complete = false;
                    return found;
                }
                found.all.push_back({std::move(one.design), d, depth + 1, at, 1});
            }
        }
    }
    return found;
}

}  // namespace filigree::shape
