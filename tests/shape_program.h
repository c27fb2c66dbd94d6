// For tests: what the program says of the matches of a shape document.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/program.h"

namespace filigree {

using Json = nlohmann::json;

inline Json matches_of(const std::string& text, const std::string& rule, const std::string& options = "") {
    const TestFolder folder;
    const Ran ran = run_program("match " + folder.write("a.fil", text) + " --rule " + rule + " --json " + options);
    EXPECT_EQ(ran.status, 0) << ran.out;
    return ran.status == 0 ? Json::parse(ran.out) : Json();
}
inline std::size_t match_count(const std::string& text, const std::string& rule) {
    return matches_of(text, rule)["rules"][0]["matches"].get<std::size_t>();
}

}  // namespace filigree
