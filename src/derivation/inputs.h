// The files that a document reads, loaded before anything is derived: engines never open files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "language/document.h"

namespace filigree {

struct Input {
    std::string name;  // as the document names it
    std::string bytes;

    bool operator==(const Input&) const = default;
};
using Inputs = std::vector<Input>;

// The files that a document's starts, rules, definitions and presets name, by file("leaf.svg"), image("photo.png"),
// text("A", font: "bold.ttf"), `start from`, `array M from` and the settings `image` and `data`: each once, in order,
// with where they are named.
std::vector<Name> named_files(const Document& document);

inline const Input* find_input(const Inputs& inputs, std::string_view name) {
    for (const Input& input : inputs) {
        if (input.name == name) return &input;
    }
    return nullptr;
}

}  // namespace filigree
