// The choices of a run as JSON, one a line, and back as values to replay.
//
//   {"path": "big_poly/outline", "name": "distance", "value": 7.25, "text": "7.25px", "domain": "5px..9px",
//    "source": "drawn", "key": "0123456789abcdef"}
//
// Text is made here, row by row, so that a million choices stream. The key is the machine's address: replaying goes by
// it and the name, so that a renamed tag or an element more elsewhere does not matter.
#pragma once

#include <functional>
#include <string>

#include "base/result.h"
#include "language/choices.h"
#include "session/run.h"

namespace filigree {

// Hands over the listing piece by piece: those of `let`s, starts, steps in their order (with the documents that grow in
// them), styles.
using TextSink = std::function<void(std::string_view piece)>;
void list_choices(const OpenedDocument& opened, const CheckedDocument& checked, const Run& run, const TextSink& sink);

// One choice, as a row of another listing would need it.
struct ListedChoice {
    std::string path;  // of the group, the step, the shape or the name: without the choice's own name
    std::string_view name;
    const Choices* choices = nullptr;
    std::size_t row = 0;
};
void for_each_choice(const OpenedDocument& opened, const CheckedDocument& checked, const Run& run,
                     const std::function<void(const ListedChoice& choice)>& visit);

// What `list_choices` wrote. Errors: no JSON, rows without key, name or value.
Result<Replay> read_choices(std::string_view text);

}  // namespace filigree
