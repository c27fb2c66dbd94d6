// The files that a document reads, loaded before anything is derived: engines never open files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace filigree {

struct Input {
    std::string name;  // as the document names it
    std::string bytes;

    bool operator==(const Input&) const = default;
};
using Inputs = std::vector<Input>;

inline const Input* find_input(const Inputs& inputs, std::string_view name) {
    for (const Input& input : inputs) {
        if (input.name == name) return &input;
    }
    return nullptr;
}

}  // namespace filigree
