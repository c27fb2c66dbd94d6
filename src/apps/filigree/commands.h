// The commands of the program. Each takes its options as data and returns the exit status.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engines/tangle/draw.h"
#include "session/edit_document.h"
#include "session/open.h"
#include "session/variations.h"

namespace filigree {

struct RenderCommand {
    std::filesystem::path document;
    std::vector<std::filesystem::path> outputs;
    OpenOptions open;
    std::optional<std::uint64_t> steps;
    std::size_t threads = 0;        // 0: as many as the machine has
    std::filesystem::path stats;    // empty: none
    std::filesystem::path choices;  // likewise
    tangle::ColourBy colour_by = tangle::ColourBy::style;
    double dpi = 192;  // of PNG
    bool verify = false;
    bool strict = false;
    bool lean = false;
    bool watch = false;
};
int run_render(const RenderCommand& command);

struct CheckCommand {
    std::filesystem::path document;
    OpenOptions open;
    bool json = false;
};
int run_check(const CheckCommand& command);

struct DeriveCommand {
    std::filesystem::path document;
    OpenOptions open;
    std::optional<std::uint64_t> steps;
    std::size_t threads = 0;
    bool json = false;
    bool length = false, counts = false;   // of a word, without making it
    std::string slice;                     // FIRST:COUNT, likewise
    std::optional<std::uint64_t> explain;  // the position of a symbol in a word
};
int run_derive(const DeriveCommand& command);

struct ChoicesCommand {
    std::filesystem::path document;
    OpenOptions open;
    std::size_t threads = 0;
    std::filesystem::path output;  // empty: standard output
};
int run_choices(const ChoicesCommand& command);

struct PickCommand {
    std::filesystem::path document;
    OpenOptions open;
    std::string at;  // "X,Y" in the document's unit
    bool json = false;
};
int run_pick(const PickCommand& command);

// set, keep, reroll and apply
struct EditCommand {
    std::filesystem::path document;
    OpenOptions open;
    std::vector<DocumentEdit> edits;
    std::filesystem::path output;  // empty: standard output
    bool json = false;
};
int run_edit(const EditCommand& command);

// edit: one edit of a word
struct WordEditCommand {
    std::filesystem::path document;
    OpenOptions open;
    std::optional<std::uint64_t> steps;
    std::size_t threads = 0;
    std::string edit;                                            // its name
    std::vector<std::pair<std::string, std::string>> arguments;  // parameters, and values as a document writes them
    std::vector<std::string> pairs;                              // "aaa -> b", without quotes
    std::string with;                                            // another document, or the letter of a system
    std::filesystem::path output;                                // empty: the word alone, to standard output
    bool json = false;
};
int run_word_edit(const WordEditCommand& command);

// match: where the rules of a shape grammar apply
struct MatchCommand {
    std::filesystem::path document;
    OpenOptions open;
    std::string rule;                    // empty: all
    std::optional<std::uint64_t> steps;  // in which state of the derivation
    bool by_hand = false;                // behind the steps by hand, before the machine's
    std::string at;                      // to explain: where a match was expected; empty: anywhere
    bool explain = false;
    bool json = false;
    std::filesystem::path output;  // a drawing of the matches; empty: none
    double dpi = 192;
};
int run_match(const MatchCommand& command);

// step: one match of a shape rule, chosen by its number, as an `apply` of the document
struct StepCommand {
    std::filesystem::path document;
    OpenOptions open;
    std::string rule;
    std::uint64_t match = 1;
    bool by_hand = false;  // its number is one of `match --by-hand`
    bool orbit = false;
    std::filesystem::path output;  // empty: standard output
};
int run_step(const StepCommand& command);

// designs: all that a shape grammar makes in so many steps
struct DesignsCommand {
    std::filesystem::path document;
    OpenOptions open;
    std::uint32_t depth = 2;
    std::uint64_t most = 1000;
    std::string up_to = "nothing";
    bool json = false;
    std::filesystem::path output;  // a sheet; empty: none
    double dpi = 192;
};
int run_designs(const DesignsCommand& command);

struct VariationsCommand {
    std::filesystem::path document;
    OpenOptions open;
    VariationOptions options;
    std::filesystem::path output;
    std::uint32_t take = 0;  // the neighbour whose document is written; 0: all on a sheet
    std::size_t threads = 0;
    double dpi = 192;
};
int run_variations(const VariationsCommand& command);

struct DescribeCommand {
    std::string name;  // empty with `markdown` or `json`
    bool markdown = false;
    bool json = false;
};
int run_describe(const DescribeCommand& command);
int run_list();

}  // namespace filigree
