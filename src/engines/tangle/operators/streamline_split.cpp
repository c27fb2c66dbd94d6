// streamline_split: cut shapes along complete, evenly spaced lines that follow their form (gTangle, section 4.2).
#include <atomic>

#include "engines/tangle/operators/operators.h"
#include "engines/tangle/split_family.h"
#include "plane/streamline_cut.h"

namespace filigree::tangle {
namespace {

StreamlineKind kind_of(std::string_view word) {
    if (word == "strip") return StreamlineKind::strip;
    return word == "circular" || word == "circ" ? StreamlineKind::circular : StreamlineKind::smooth;
}

Result<OperatorOutput> run(const OperatorInput& input) {
    const Arguments& arguments = input.arguments;
    std::atomic<bool> too_many = false;
    Result<OperatorOutput> output =
        for_each_shape(input, [&](std::size_t index, const Shape& shape, PolygonView polygon, Batch& batch) {
            if (too_many.load(std::memory_order_relaxed)) return;
            StreamlineCutOptions options;
            options.kind = kind_of(arguments.word("kind", index));
            options.by_field = arguments.word("mode", index) == "field";
            options.offsets = arguments.lengths("offset", index);
            options.dual = arguments.flag("dual", index);
            options.smoothing = arguments.number("smoothing", index);
            options.tolerance = input.resolution;
            options.limit = input.element_budget;
            if (options.kind == StreamlineKind::circular) {
                options.centre = centre_of(arguments.value("centre", index), centroid(polygon));
            }
            const StreamlineCut cut = cut_by_streamlines(polygon, options);
            if (cut.is_too_fine) too_many = true;
            for (std::size_t i = 0; i < cut.pieces.size(); ++i) {
                Shape piece = piece_of(shape, input.step, cut.places[i].key, batch.geometry.size());
                piece.column = cut.places[i].column;
                piece.row = cut.places[i].row;
                batch.geometry.add(cut.pieces[i]);
                batch.ports[0].push_back(piece);
            }
        });
    if (too_many) return too_many_shapes(input);
    return output;
}

}  // namespace

Operator streamline_split_operator() {
    return {{.name = "streamline_split",
             .aliases = {"streamlineSplit"},
             .help = "cut along complete, evenly spaced lines that follow the shape",
             .source = "gTangle, section 4.2",
             .parameters = {{.name = "kind",
                             .type = ParameterType::word,
                             .help = "outlines that grow rounder inwards, strips across the shape, or circles",
                             .default_text = "smooth",
                             .words = {"smooth", "strip", "circular", "smooth_outline", "circ"},
                             .aliases = {"type"}},
                            {.name = "offset",
                             .type = ParameterType::lengths,
                             .help = "distance from line to line; a list is used in turn",
                             .low = 0.01,
                             .high = 1e6,
                             .aliases = {"offsets"}},
                            {.name = "dual",
                             .type = ParameterType::flag,
                             .help = "cut once more along lines across the first ones, into fields",
                             .default_text = "false"},
                            {.name = "mode",
                             .type = ParameterType::word,
                             .help = "level lines, which never meet, or lines of a field, which split and merge",
                             .default_text = "iso",
                             .words = {"iso", "field"}},
                            centre_parameter(),
                            {.name = "smoothing",
                             .type = ParameterType::real,
                             .help = "how far outlines round corners off, in offsets; 0 keeps them",
                             .default_text = "3",
                             .low = 0,
                             .high = 100}},
             .ports = {{"pieces", "the strips, or the fields of a dual split"}},
             .example = "streamline_split(smooth, 6.2) : petal -> rings"},
            run};
}

}  // namespace filigree::tangle
