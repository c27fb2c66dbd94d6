// What may stand behind `match`: under which maps a left side is found, described like operators.
//
//   match isometry        match similarity(reflections: false, max_scale: 2)        match visual(0.5)
#pragma once

#include <vector>

#include "base/result.h"
#include "curves/detect.h"
#include "language/description.h"
#include "language/document.h"
#include "language/value.h"

namespace filigree::shape {

const std::vector<OperatorDescription>& match_words();

struct MatchWord {
    curves::MatchOptions options;
    bool by_corners = false;
};
// A bare word or a call.
Result<MatchWord> match_of(const Value& value, const Document& document);

}  // namespace filigree::shape
