// The command line of Filigree: thin. It turns words into options and calls a command.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <iostream>
#include <map>
#include <memory>

#include "apps/filigree/commands.h"
#include "base/heap.h"
#include "engines/rewriting/edit_operators.h"
#include "language/parse.h"
#include "session/edit_word.h"

namespace {

using filigree::OpenOptions;

constexpr const char* document_help = "a .fil file, or an SVG or PDF that Filigree wrote";

// For options that count: a negative number would be taken for a huge one.
CLI::Range a_count() { return CLI::Range(0, 1000000000); }

// What the chosen command does.
using Run = std::function<int()>;

// Adds a command; `prepare` reads what was given and returns the work. Options live as long as the command.
template <class Options>
void when_chosen(CLI::App& command, Run& run, std::shared_ptr<Options> options,
                 std::function<Run(Options& options)> prepare) {
    command.callback([&run, options, prepare] { run = prepare(*options); });
}

// Options of every command that opens a document.
struct OpenFlags {
    std::vector<std::string> settings;
    std::vector<std::string> folders;
    std::uint64_t seed = 0;
    CLI::Option* seed_option = nullptr;
};

void add_open_flags(CLI::App& command, OpenFlags& flags) {
    flags.seed_option = command.add_option("--seed", flags.seed, "another seed than the document's");
    command.add_option("--set", flags.settings, "another value for a parameter or a choice: PATH=VALUE")
        ->take_all()
        ->expected(1)
        ->allow_extra_args(false);
    command.add_option("--allow", flags.folders, "a folder that the document may read too")
        ->take_all()
        ->expected(1)
        ->allow_extra_args(false);
}

std::pair<std::string, std::string> assignment(const std::string& option, const std::string& text) {
    const filigree::Result<filigree::Assignment> split = filigree::split_assignment(text);
    if (!split) throw CLI::ValidationError(option, split.diagnostics().front().message);
    return {split->path, split->value};
}

OpenOptions open_options(const OpenFlags& flags) {
    OpenOptions options;
    if (flags.seed_option->count() > 0) options.seed = flags.seed;
    for (const std::string& setting : flags.settings) options.settings.push_back(assignment("--set", setting));
    options.allowed_folders.assign(flags.folders.begin(), flags.folders.end());
    return options;
}

void add_threads(CLI::App& command, std::size_t& threads) {
    command.add_option("--threads", threads, "how many threads work; the result is the same")
        ->check(CLI::Range(1, 1024));
}

// --- commands that only look ---------------------------------------------------------------------------------------

void add_render(CLI::App& app, Run& run) {
    struct Options {
        filigree::RenderCommand command;
        OpenFlags flags;
        std::uint64_t steps = 0;
        CLI::Option* steps_option = nullptr;
    };
    const auto options = std::make_shared<Options>();
    filigree::RenderCommand& render = options->command;
    CLI::App& command = *app.add_subcommand("render", "derive, draw and write a document");
    command.add_option("document", render.document, document_help)->required();
    command
        .add_option("-o,--output", render.outputs,
                    "what to write; its ending (.svg, .pdf, .png) is the format; may be repeated")
        ->required()
        ->take_all()
        ->expected(1)
        ->allow_extra_args(false);
    add_open_flags(command, options->flags);
    command.add_option("--choices", render.choices, "take these choices, as `filigree choices` wrote them");
    options->steps_option = command.add_option("--steps", options->steps, "stop after so many steps")->check(a_count());
    add_threads(command, render.threads);
    command.add_option("--stats", render.stats, "write figures about the run, as JSON");
    command.add_option("--colour-by", render.colour_by, "colour shapes by what they are: tag, group or step")
        ->transform(CLI::CheckedTransformer(
            std::map<std::string, filigree::tangle::ColourBy>{{"tag", filigree::tangle::ColourBy::tag},
                                                              {"group", filigree::tangle::ColourBy::group},
                                                              {"step", filigree::tangle::ColourBy::step}}));
    command.add_option("--dpi", render.dpi, "dots per inch of a PNG")
        ->check(CLI::Range(1.0, 9600.0))
        ->capture_default_str();
    command.add_flag("--verify", render.verify, "check the result's invariants");
    command.add_flag("--strict", render.strict, "refuse presets that meet nothing in this derivation");
    command.add_flag("--lean", render.lean, "a smaller SVG, without what made each shape");
    command.add_flag("--watch", render.watch, "render again whenever a file changes");
    when_chosen<Options>(command, run, options, [](Options& given) -> Run {
        given.command.open = open_options(given.flags);
        if (given.steps_option->count() > 0) given.command.steps = given.steps;
        return [&given] { return filigree::run_render(given.command); };
    });
}

void add_check(CLI::App& app, Run& run) {
    struct Options {
        filigree::CheckCommand command;
        OpenFlags flags;
    };
    const auto options = std::make_shared<Options>();
    CLI::App& command = *app.add_subcommand("check", "say what is wrong with a document, and show its grammar's graph");
    command.add_option("document", options->command.document, document_help)->required();
    add_open_flags(command, options->flags);
    command.add_flag("--json", options->command.json, "as JSON");
    when_chosen<Options>(command, run, options, [](Options& given) -> Run {
        given.command.open = open_options(given.flags);
        return [&given] { return filigree::run_check(given.command); };
    });
}

void add_derive(CLI::App& app, Run& run) {
    struct Options {
        filigree::DeriveCommand command;
        OpenFlags flags;
        std::uint64_t steps = 0, position = 0;
        std::string format = "text";
        CLI::Option *steps_option = nullptr, *explain_option = nullptr;
    };
    const auto options = std::make_shared<Options>();
    CLI::App& command = *app.add_subcommand("derive", "list the steps of a derivation, or print its word");
    command.add_option("document", options->command.document, document_help)->required();
    add_open_flags(command, options->flags);
    options->steps_option = command.add_option("--steps", options->steps, "stop after so many steps")->check(a_count());
    add_threads(command, options->command.threads);
    command.add_option("--format", options->format, "text or json")
        ->check(CLI::IsMember({"text", "json"}))
        ->capture_default_str();
    command.add_flag("--length", options->command.length, "of a word: its length, without making it");
    command.add_flag("--counts", options->command.counts, "of a word: how many there are of each symbol, likewise");
    command.add_option("--slice", options->command.slice, "of a word: FIRST:COUNT, symbols from a place on, likewise");
    options->explain_option =
        command.add_option("--explain", options->position,
                           "of a word: why the symbol at this position, from 0 and without '=', is what it is");
    when_chosen<Options>(command, run, options, [](Options& given) -> Run {
        given.command.open = open_options(given.flags);
        if (given.steps_option->count() > 0) given.command.steps = given.steps;
        if (given.explain_option->count() > 0) given.command.explain = given.position;
        given.command.json = given.format == "json";
        return [&given] { return filigree::run_derive(given.command); };
    });
}

void add_choices(CLI::App& app, Run& run) {
    struct Options {
        filigree::ChoicesCommand command;
        OpenFlags flags;
    };
    const auto options = std::make_shared<Options>();
    CLI::App& command = *app.add_subcommand("choices", "list every choice that was made, as JSON");
    command.add_option("document", options->command.document, document_help)->required();
    add_open_flags(command, options->flags);
    add_threads(command, options->command.threads);
    command.add_option("-o,--output", options->command.output, "where to write; else standard output");
    when_chosen<Options>(command, run, options, [](Options& given) -> Run {
        given.command.open = open_options(given.flags);
        return [&given] { return filigree::run_choices(given.command); };
    });
}

void add_pick(CLI::App& app, Run& run) {
    struct Options {
        filigree::PickCommand command;
        OpenFlags flags;
    };
    const auto options = std::make_shared<Options>();
    CLI::App& command = *app.add_subcommand("pick", "the element at a point, and the steps that made it");
    command.add_option("document", options->command.document, document_help)->required();
    command.add_option("--at", options->command.at, "the point: X,Y in the document's unit, y downwards")->required();
    add_open_flags(command, options->flags);
    command.add_flag("--json", options->command.json, "as JSON");
    when_chosen<Options>(command, run, options, [](Options& given) -> Run {
        given.command.open = open_options(given.flags);
        return [&given] { return filigree::run_pick(given.command); };
    });
}

void add_variations(CLI::App& app, Run& run) {
    struct Options {
        filigree::VariationsCommand command;
        OpenFlags flags;
    };
    const auto options = std::make_shared<Options>();
    filigree::VariationsCommand& variations = options->command;
    CLI::App& command = *app.add_subcommand("variations", "neighbours of a document on a contact sheet");
    command.add_option("document", variations.document, document_help)->required();
    command.add_option("-o,--output", variations.output, "the sheet (.svg, .pdf, .png), or with --take the document")
        ->required();
    command.add_option("--count", variations.options.count, "how many")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command.add_option("--distance", variations.options.distance, "the share of the choices that is drawn again, 0..1")
        ->check(CLI::Range(0.0, 1.0))
        ->capture_default_str();
    command.add_option("--first", variations.options.first, "number of the first, for others than those before")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    command.add_option("--take", variations.take, "write the document of this neighbour instead of a sheet")
        ->check(CLI::Range(1, 1'000'000));
    add_threads(command, variations.threads);
    command.add_option("--dpi", variations.dpi, "dots per inch of a PNG")
        ->check(CLI::Range(1.0, 9600.0))
        ->capture_default_str();
    add_open_flags(command, options->flags);
    when_chosen<Options>(command, run, options, [](Options& given) -> Run {
        given.command.open = open_options(given.flags);
        return [&given] { return filigree::run_variations(given.command); };
    });
}

constexpr const char* by_hand_help = "before the machine's steps, where one by hand would come";

void add_match(CLI::App& app, Run& run) {
    struct Options {
        filigree::MatchCommand command;
        OpenFlags flags;
        std::uint64_t steps = 0;
        CLI::Option* steps_option = nullptr;
    };
    const auto options = std::make_shared<Options>();
    filigree::MatchCommand& match = options->command;
    CLI::App& command = *app.add_subcommand("match", "where the rules of a shape grammar apply");
    command.add_option("document", match.document, document_help)->required();
    command.add_option("--rule", match.rule, "of this rule alone");
    options->steps_option =
        command.add_option("--steps", options->steps, "after so many steps; all if left out")->check(a_count());
    command.add_flag("--by-hand", match.by_hand, by_hand_help)->excludes(options->steps_option);
    command.add_flag("--explain", match.explain, "why the rule does not apply where it is expected to");
    command.add_option("--at", match.at, "where: X,Y in the document's unit, y downwards");
    command.add_flag("--json", match.json, "as JSON, with the transforms and the elements that are covered");
    command.add_option("-o,--output", match.output, "a drawing of the matches (.svg, .pdf, .png)");
    command.add_option("--dpi", match.dpi, "dots per inch of a PNG")
        ->check(CLI::Range(1.0, 9600.0))
        ->capture_default_str();
    add_open_flags(command, options->flags);
    when_chosen<Options>(command, run, options, [](Options& given) -> Run {
        given.command.open = open_options(given.flags);
        if (given.steps_option->count() > 0) given.command.steps = given.steps;
        return [&given] { return filigree::run_match(given.command); };
    });
}

void add_designs(CLI::App& app, Run& run) {
    struct Options {
        filigree::DesignsCommand command;
        OpenFlags flags;
    };
    const auto options = std::make_shared<Options>();
    filigree::DesignsCommand& designs = options->command;
    CLI::App& command = *app.add_subcommand("designs", "all designs that a shape grammar makes in so many steps");
    command.add_option("document", designs.document, document_help)->required();
    command.add_option("--depth", designs.depth, "how many steps")->check(CLI::Range(0, 1000))->capture_default_str();
    command.add_option("--most", designs.most, "stop behind so many designs")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    command
        .add_option("--up-to", designs.up_to,
                    "which designs are the same: those that differ by nothing, translation, isometry or similarity")
        ->check(CLI::IsMember({"nothing", "translation", "isometry", "similarity"}))
        ->capture_default_str();
    command.add_flag("--json", designs.json, "as JSON");
    command.add_option("-o,--output", designs.output, "a sheet of all of them (.svg, .pdf, .png)");
    command.add_option("--dpi", designs.dpi, "dots per inch of a PNG")
        ->check(CLI::Range(1.0, 9600.0))
        ->capture_default_str();
    add_open_flags(command, options->flags);
    when_chosen<Options>(command, run, options, [](Options& given) -> Run {
        given.command.open = open_options(given.flags);
        return [&given] { return filigree::run_designs(given.command); };
    });
}

// --- commands that edit --------------------------------------------------------------------------------------------

struct EditFlags {
    filigree::EditCommand command;
    std::vector<std::string> words;  // paths, or PATH=VALUE
    std::vector<std::string> folders;
    std::string call, tags;
    std::uint32_t times = 1;
    bool remove = false;
};

CLI::App& add_edit(CLI::App& app, const char* name, const char* help, EditFlags& flags) {
    CLI::App& command = *app.add_subcommand(name, help);
    command.add_option("document", flags.command.document, document_help)->required();
    command.add_option("-o,--output", flags.command.output, "where to write the new document; else standard output");
    command.add_flag("--json", flags.command.json, "what was done and the new text, as JSON");
    command.add_option("--allow", flags.folders, "a folder that the document may read too")
        ->take_all()
        ->expected(1)
        ->allow_extra_args(false);
    return command;
}

Run edit_run(EditFlags& flags) {
    flags.command.open.allowed_folders.assign(flags.folders.begin(), flags.folders.end());
    return [&flags] { return filigree::run_edit(flags.command); };
}

void add_set(CLI::App& app, Run& run) {
    const auto flags = std::make_shared<EditFlags>();
    CLI::App& command = add_edit(app, "set", "pin or restrict choices and parameters in a document", *flags);
    command.add_option("values", flags->words, "PATH=VALUE")->required();
    command.add_flag("--default", flags->remove, "as `default`: for where is_random is false");
    when_chosen<EditFlags>(command, run, flags, [](EditFlags& given) {
        for (const std::string& word : given.words) {
            const auto [path, value] = assignment("set", word);
            using Kind = filigree::DocumentEdit::Kind;
            given.command.edits.push_back({given.remove ? Kind::set_default : Kind::set, path, value, {}, {}, 1});
        }
        return edit_run(given);
    });
}

void add_keep(CLI::App& app, Run& run) {
    const auto flags = std::make_shared<EditFlags>();
    CLI::App& command =
        add_edit(app, "keep", "lock places of a document: they stay when what lies above is drawn again", *flags);
    command.add_option("paths", flags->words, "what to keep")->required();
    command.add_flag("--remove", flags->remove, "unlock them");
    when_chosen<EditFlags>(command, run, flags, [](EditFlags& given) {
        using Kind = filigree::DocumentEdit::Kind;
        for (const std::string& word : given.words) {
            given.command.edits.push_back({given.remove ? Kind::unkeep : Kind::keep, word, {}, {}, {}, 1});
        }
        return edit_run(given);
    });
}

void add_reroll(CLI::App& app, Run& run) {
    const auto flags = std::make_shared<EditFlags>();
    CLI::App& command = add_edit(app, "reroll", "draw places of a document again, and all below them", *flags);
    command.add_option("paths", flags->words, "what to draw again")->required();
    command.add_option("--times", flags->times, "how many times further")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    when_chosen<EditFlags>(command, run, flags, [](EditFlags& given) {
        for (const std::string& word : given.words) {
            given.command.edits.push_back({filigree::DocumentEdit::Kind::reroll, word, {}, {}, {}, given.times});
        }
        return edit_run(given);
    });
}

void add_apply(CLI::App& app, Run& run) {
    const auto flags = std::make_shared<EditFlags>();
    CLI::App& command = add_edit(app, "apply", "add a step by hand", *flags);
    command.add_option("operator", flags->call, "as in a rule: 'outline(5)', 'rim = outline(5)'")->required();
    command.add_option("--to", flags->words, "the group or shape to apply it to; may be repeated")
        ->required()
        ->take_all()
        ->expected(1)
        ->allow_extra_args(false);
    command.add_option("--as", flags->tags, "tags of what comes out: 'in, ring'");
    when_chosen<EditFlags>(command, run, flags, [](EditFlags& given) {
        given.command.edits.push_back(
            {filigree::DocumentEdit::Kind::apply, {}, given.call, given.words, given.tags, 1});
        return edit_run(given);
    });
}

void add_step(CLI::App& app, Run& run) {
    struct Options {
        filigree::StepCommand command;
        OpenFlags flags;
    };
    const auto options = std::make_shared<Options>();
    filigree::StepCommand& step = options->command;
    CLI::App& command =
        *app.add_subcommand("step", "apply a shape rule at one of its matches: the document with one step more");
    command.add_option("document", step.document, document_help)->required();
    command.add_option("--rule", step.rule, "the rule")->required();
    command.add_option("--match", step.match, "the match's number, as `match` lists them")
        ->required()
        ->check(a_count());
    command.add_flag("--by-hand", step.by_hand, by_hand_help);
    command.add_flag("--orbit", step.orbit, "at all places that the symmetries of the design take it to");
    command.add_option("-o,--output", step.output, "where to write the new document; else standard output");
    add_open_flags(command, options->flags);
    when_chosen<Options>(command, run, options, [](Options& given) -> Run {
        given.command.open = open_options(given.flags);
        return [&given] { return filigree::run_step(given.command); };
    });
}

// One edit of the word of a document, a subcommand each.
struct WordEditFlags {
    filigree::WordEditCommand command;
    OpenFlags flags;
    std::uint64_t steps = 0;
    std::string format = "text";
    CLI::Option* steps_option = nullptr;
    struct Given {
        const filigree::ParameterDescription* parameter = nullptr;
        CLI::Option* option = nullptr;
        std::string value;
    };
    std::map<std::string, std::vector<std::unique_ptr<Given>>> given;  // by the edit's name, one a parameter
};

// "passes, --passes": parameters that must be given may stand without a name.
std::string option_name(const filigree::ParameterDescription& parameter) {
    std::string name(parameter.name);
    std::replace(name.begin(), name.end(), '_', '-');
    return (parameter.default_text.empty() ? name + "," : "") + "--" + name;
}

std::string help_of(const filigree::ParameterDescription& parameter) {
    std::string words;
    for (const std::string_view word : parameter.words) words += (words.empty() ? ": " : ", ") + std::string(word);
    const bool has_default = parameter.type != filigree::ParameterType::text &&
                             parameter.type != filigree::ParameterType::flag && !parameter.default_text.empty();
    return std::string(parameter.help) + words +
           (has_default ? " [" + std::string(parameter.default_text) + "]" : std::string());
}

void add_parameter(CLI::App& command, WordEditFlags& flags, const filigree::ParameterDescription& parameter) {
    const std::string help = help_of(parameter);  // const: else it would be what add_flag fills
    if (parameter.name == "with") {
        command.add_option("--with", flags.command.with, "the other word: the letter of a system, or another document");
        return;
    }
    auto given = std::make_unique<WordEditFlags::Given>();
    given->parameter = &parameter;
    const bool is_switch = parameter.default_text == "false";
    given->option = is_switch ? command.add_flag(option_name(parameter), help)
                              : command.add_option(option_name(parameter), given->value, help);
    if (parameter.default_text.empty()) given->option->required();
    flags.given[command.get_name()].push_back(std::move(given));
}

void take_given(WordEditFlags& flags) {
    for (const auto& given : flags.given[flags.command.edit]) {
        if (given->option->count() == 0) continue;
        const bool is_text = given->parameter->type == filigree::ParameterType::text;
        const bool is_switch = given->parameter->default_text == "false";
        flags.command.arguments.emplace_back(given->parameter->name, is_switch ? "true"
                                                                     : is_text ? filigree::quoted_text(given->value)
                                                                               : given->value);
    }
}

void add_word_edits(CLI::App& app, Run& run) {
    const auto flags = std::make_shared<WordEditFlags>();
    CLI::App& command = *app.add_subcommand("edit", "edit the word that a rewriting document derives");
    command.add_option("document", flags->command.document, document_help)->required();
    flags->steps_option =
        command.add_option("--steps", flags->steps, "how many iterations; the document's own number if left out")
            ->check(a_count());
    command.add_option("-o,--output", flags->command.output, "write the document with the word for its axiom");
    command.add_option("--format", flags->format, "text or json")
        ->check(CLI::IsMember({"text", "json"}))
        ->capture_default_str();
    add_open_flags(command, flags->flags);
    add_threads(command, flags->command.threads);
    command.require_subcommand(1);
    command.footer(
        "Values are written as in documents, texts without quotes. `filigree edit DOC EDIT --help` explains an edit.");
    using Pairs = filigree::rewriting::EditOperator::Pairs;
    for (const filigree::rewriting::EditOperator& op : filigree::rewriting::edit_operators()) {
        CLI::App& edit = *command.add_subcommand(std::string(op.description.name), std::string(op.description.help));
        edit.fallthrough();
        for (const filigree::ParameterDescription& parameter : op.description.parameters) {
            add_parameter(edit, *flags, parameter);
        }
        if (op.pairs == Pairs::chunks) {
            edit.add_option("pairs,--pair", flags->command.pairs, "what is replaced by what: 'aaa -> b'");
        } else if (op.pairs == Pairs::reactions) {
            edit.add_option("pairs,--pair", flags->command.pairs,
                            "reactions: 'ab -> c', or with what stands around the symbols 'l < a > r  b -> c'");
        }
        edit.callback([flags, &op] { flags->command.edit = op.description.name; });
    }
    when_chosen<WordEditFlags>(command, run, flags, [](WordEditFlags& given) -> Run {
        given.command.open = open_options(given.flags);
        if (given.steps_option->count() > 0) given.command.steps = given.steps;
        given.command.json = given.format == "json";
        return [&given] {
            take_given(given);
            return filigree::run_word_edit(given.command);
        };
    });
}

// --- commands about the language -----------------------------------------------------------------------------------

void add_describe(CLI::App& app, Run& run) {
    const auto options = std::make_shared<filigree::DescribeCommand>();
    CLI::App& command = *app.add_subcommand("describe", "one operator's page");
    CLI::Option* name = command.add_option("name", options->name, "an operator, a start shape or an engine");
    CLI::Option* markdown = command.add_flag("--markdown", options->markdown, "the whole reference, as Markdown");
    CLI::Option* json = command.add_flag("--json", options->json, "all descriptions, as JSON");
    when_chosen<filigree::DescribeCommand>(command, run, options,
                                           [name, markdown, json](filigree::DescribeCommand& given) -> Run {
                                               if (name->count() + markdown->count() + json->count() != 1) {
                                                   throw CLI::RequiredError("describe: NAME, --markdown or --json");
                                               }
                                               return [&given] { return filigree::run_describe(given); };
                                           });
}

}  // namespace

int main(int argc, char** argv) {
    filigree::prepare_heap();
    CLI::App app{"Filigree grows ornament from grammars."};
    app.name("filigree");
    app.set_version_flag("--version", "filigree 0.1.0");
    app.require_subcommand(1);
    app.footer(
        "examples:\n"
        "  filigree render examples/tangle/leaf.fil -o leaf.svg -o leaf.png\n"
        "  filigree render leaf.fil -o leaf.svg --set spacing=30 --seed 7\n"
        "  filigree pick leaf.fil --at 120,80\n"
        "  filigree set leaf.fil big_poly/outline.distance=18 -o leaf.fil\n"
        "  filigree variations leaf.fil --count 12 -o sheet.svg\n"
        "  filigree describe outline\n");
    Run run;
    add_render(app, run);
    add_check(app, run);
    add_derive(app, run);
    add_choices(app, run);
    add_pick(app, run);
    add_match(app, run);
    add_designs(app, run);
    add_set(app, run);
    add_keep(app, run);
    add_reroll(app, run);
    add_apply(app, run);
    add_step(app, run);
    add_word_edits(app, run);
    add_variations(app, run);
    app.add_subcommand("list", "list engines, operators, start shapes and functions")->callback([&run] {
        run = filigree::run_list;
    });
    add_describe(app, run);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& wrong) {
        return app.exit(wrong) == 0 ? 0 : 2;
    }
    const int status = run();
    std::cout.flush();
    return std::cout.fail() && status == 0 ? 3 : status;
}
