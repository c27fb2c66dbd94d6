#include "engines/tangle/operator.h"

#include <algorithm>

namespace filigree::tangle {
namespace {

constexpr std::size_t batch_size = 64;  // shapes: large enough to amortise allocation, small enough to share out

}  // namespace

Diagnostic too_many_shapes(const OperatorInput& input) {
    return fault(Fault::limit, "limit.elements",
                 "'" + std::string(input.arguments.description->name) + "' makes more shapes than the limit allows (" +
                     std::to_string(input.element_budget) + " more)");
}

bool is_too_dense(const OperatorInput& input, std::string_view spacing) {
    double least = 0;
    for (std::size_t i = 0; i < input.shapes.size(); ++i) {
        const double apart = input.arguments.number(spacing, i);
        least += 0.25 * area(input.tangle.polygon(input.shapes[i])) / (apart * apart);
    }
    return least > static_cast<double>(input.element_budget) + 100;
}

Result<OperatorOutput> for_each_shape(const OperatorInput& input, const ShapeWork& work) {
    const std::size_t port_count = input.arguments.description->ports.size();
    const std::size_t batch_count = (input.shapes.size() + batch_size - 1) / batch_size;
    std::vector<Batch> batches(batch_count);
    input.executor.run(batch_count, [&](std::size_t b) {
        Batch& batch = batches[b];
        batch.ports.resize(port_count);
        const std::size_t end = std::min(input.shapes.size(), (b + 1) * batch_size);
        for (std::size_t i = b * batch_size; i < end && batch.added <= input.element_budget; ++i) {
            const Shape& shape = input.shapes[i];
            work(i, shape, input.tangle.polygon(shape), batch);
            batch.added = 0;
            for (const std::vector<Shape>& port : batch.ports) batch.added += port.size();
        }
    });

    std::uint64_t added = 0;
    for (const Batch& batch : batches) added += batch.added;
    if (added > input.element_budget) return too_many_shapes(input);

    OperatorOutput output;
    for (std::uint32_t port = 0; port < port_count; ++port) output.groups.push_back({port, 0, {}});
    for (std::size_t b = 0; b < batch_count; ++b) {
        const auto offset = static_cast<std::uint32_t>(output.geometry.size());
        if (b == 0) {
            output.geometry = std::move(batches[b].geometry);
        } else {
            output.geometry.add_all(batches[b].geometry);
        }
        for (std::uint32_t port = 0; port < port_count; ++port) {
            for (Shape& shape : batches[b].ports[port]) {
                if (shape.geometry == none) shape.polygon += offset;
                output.groups[port].shapes.push_back(shape);
            }
        }
    }
    return output;
}

}  // namespace filigree::tangle
