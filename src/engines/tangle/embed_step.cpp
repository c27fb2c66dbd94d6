#include "engines/tangle/embed_step.h"

namespace filigree::tangle {
namespace {

PresetNode node_of_shape(const EmbedStep& step, std::size_t shape) {
    if (!may_pick_shapes(step.walk.presets, step.group.presets)) return step.node;
    const PresetNode group{step.group.presets, {}, step.group.seed};
    const PresetNode of_shape = node_below(step.walk, group, {{}, 0, step.group.number_of(shape)});
    if (!of_shape.state) return step.node;
    const PresetState below = advance(step.walk.presets, of_shape.state, {step.rule.segment});
    return node_in_state(step.walk, joined(step.node.state, below), of_shape.seed);
}

bool is_given(const Value& value) {
    const auto* symbol = std::get_if<Symbol>(&value.data);
    return symbol == nullptr || symbol->name != not_given;
}

}  // namespace

Result<std::vector<std::shared_ptr<const Embedded>>> embed_step(const EmbedStep& step, const EmbedFunction& embed,
                                                                Executor& executor) {
    const std::size_t count = step.group.shapes.size();
    if (step.depth >= max_embedding_depth) {
        Diagnostic reason =
            fault(Fault::limit, "limit.embedding",
                  "documents lie inside documents more than " + std::to_string(max_embedding_depth) + " deep here",
                  step.rule.span);
        return reason;
    }
    const auto& parameters = step.arguments.description->parameters;
    std::vector<Result<std::shared_ptr<const Embedded>>> results(count, std::shared_ptr<const Embedded>());
    executor.run(count, [&](std::size_t i) {
        const Shape& shape = step.group.shapes[i];
        EmbedRequest request;
        std::string document;
        for (std::size_t p = 0; p < parameters.size(); ++p) {
            const Value& value = step.arguments.values[p].at(i);
            if (parameters[p].name == "document") {
                document = plain_text(value);
                request.is_file = std::holds_alternative<std::string>(value.data);
            } else if (is_given(value)) {
                request.site.given.emplace_back(std::string(parameters[p].name), value);
            }
        }
        request.document = document;
        request.host = step.tangle.polygon(shape);
        request.site.root = Key{fold(step.key.value, shape.key.value)};
        request.site.outer = step.walk.presets;
        request.site.host = node_of_shape(step, i);
        request.site.document_seed = step.walk.document_seed;
        request.site.is_embedded = true;
        request.site.depth = step.depth + 1;
        request.site.replay = step.walk.replay;
        request.element_budget = step.element_budget;
        results[i] = embed(request);
    });
    std::vector<std::shared_ptr<const Embedded>> embedded;
    for (Result<std::shared_ptr<const Embedded>>& result : results) {
        if (!result) return result.diagnostics();
        embedded.push_back(std::move(*result));
    }
    return embedded;
}

}  // namespace filigree::tangle
