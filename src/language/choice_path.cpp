#include "language/choice_path.h"

#include "base/number_text.h"

namespace filigree {

namespace {

std::string listed(const std::vector<std::uint32_t>& numbers) {
    std::string text;
    for (const std::uint32_t number : numbers) text += (text.empty() ? "" : ",") + to_text(std::uint64_t{number});
    return text;
}

std::string to_text(const PathSegment& segment) {
    switch (segment.kind) {
        case PathSegment::Kind::any:
            return "*";
        case PathSegment::Kind::any_depth:
            return "**";
        case PathSegment::Kind::shapes:
            return listed(segment.ordinals);
        case PathSegment::Kind::name:
            break;
    }
    return segment.ordinals.empty() ? segment.name : segment.name + "[" + listed(segment.ordinals) + "]";
}

}  // namespace

std::string to_text(const ChoicePath& path) {
    std::string text;
    for (const PathSegment& segment : path.segments) text += (text.empty() ? "" : "/") + to_text(segment);
    if (!path.parameter.empty()) text += "." + path.parameter;
    if (path.draw != 0) text += "~" + to_text(std::uint64_t{path.draw});
    return text;
}

bool same_path(const ChoicePath& a, const ChoicePath& b) {
    return a.segments == b.segments && a.parameter == b.parameter && a.draw == b.draw;
}

}  // namespace filigree
