// The command line of Filigree: thin. It turns words into options and calls a command.
#include <CLI/CLI.hpp>
#include <functional>
#include <iostream>

#include "apps/filigree/commands.h"

namespace {

using filigree::OpenOptions;

// Options of every command that opens a document.
struct OpenFlags {
    std::vector<std::string> settings;
    std::vector<std::string> folders;
    std::uint64_t seed = 0;
    CLI::Option* seed_option = nullptr;
};

void add_open_flags(CLI::App& command, OpenFlags& flags) {
    flags.seed_option = command.add_option("--seed", flags.seed, "another seed than the document's");
    command.add_option("--set", flags.settings, "another value for a parameter: NAME=VALUE")
        ->take_all()
        ->expected(1)
        ->allow_extra_args(false);
    command.add_option("--allow", flags.folders, "a folder that the document may read too")
        ->take_all()
        ->expected(1)
        ->allow_extra_args(false);
}

OpenOptions open_options(const OpenFlags& flags) {
    OpenOptions options;
    if (flags.seed_option->count() > 0) options.seed = flags.seed;
    for (const std::string& setting : flags.settings) {
        const std::size_t equals = setting.find('=');
        if (equals == std::string::npos || equals == 0) {
            throw CLI::ValidationError("--set", "'" + setting + "' is not of the form NAME=VALUE");
        }
        options.settings.emplace_back(setting.substr(0, equals), setting.substr(equals + 1));
    }
    options.allowed_folders.assign(flags.folders.begin(), flags.folders.end());
    return options;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Filigree grows ornament from grammars."};
    app.name("filigree");
    app.set_version_flag("--version", "filigree 0.1.0");
    app.require_subcommand(1);
    app.footer(
        "examples:\n"
        "  filigree render examples/tangle/leaf.fil -o leaf.svg -o leaf.png\n"
        "  filigree render leaf.fil -o leaf.svg --set spacing=30 --seed 7\n"
        "  filigree check leaf.fil\n"
        "  filigree describe outline\n");
    std::function<int()> run;

    filigree::RenderCommand render;
    OpenFlags render_flags;
    std::uint64_t render_steps = 0;
    CLI::App* render_app = app.add_subcommand("render", "derive, draw and write a document");
    render_app->add_option("document", render.document, "a .fil file, or an SVG that Filigree wrote")->required();
    render_app
        ->add_option("-o,--output", render.outputs,
                     "what to write; its ending (.svg, .png) is the format; may be repeated")
        ->required()
        ->take_all()
        ->expected(1)
        ->allow_extra_args(false);
    add_open_flags(*render_app, render_flags);
    CLI::Option* render_steps_option = render_app->add_option("--steps", render_steps, "stop after so many steps");
    render_app->add_option("--threads", render.threads, "how many threads work; the result is the same")
        ->check(CLI::Range(1, 1024));
    render_app->add_option("--stats", render.stats, "write figures about the run, as JSON");
    render_app->add_option("--colour-by", render.colour_by, "colour shapes by what they are: tag, group or step")
        ->transform(CLI::CheckedTransformer(
            std::map<std::string, filigree::tangle::ColourBy>{{"tag", filigree::tangle::ColourBy::tag},
                                                              {"group", filigree::tangle::ColourBy::group},
                                                              {"step", filigree::tangle::ColourBy::step}}));
    render_app->add_option("--dpi", render.dpi, "dots per inch of a PNG")
        ->check(CLI::Range(1.0, 9600.0))
        ->capture_default_str();
    render_app->add_flag("--verify", render.verify, "check the result's invariants");
    render_app->add_flag("--lean", render.lean, "a smaller SVG, without what made each shape");
    render_app->add_flag("--watch", render.watch, "render again whenever a file changes");
    render_app->callback([&] {
        render.open = open_options(render_flags);
        if (render_steps_option->count() > 0) render.steps = render_steps;
        run = [&] { return filigree::run_render(render); };
    });

    filigree::CheckCommand check;
    OpenFlags check_flags;
    CLI::App* check_app =
        app.add_subcommand("check", "say what is wrong with a document, and show its grammar's graph");
    check_app->add_option("document", check.document, "a .fil file, or an SVG that Filigree wrote")->required();
    add_open_flags(*check_app, check_flags);
    check_app->add_flag("--json", check.json, "as JSON");
    check_app->callback([&] {
        check.open = open_options(check_flags);
        run = [&] { return filigree::run_check(check); };
    });

    filigree::DeriveCommand derive;
    OpenFlags derive_flags;
    std::uint64_t derive_steps = 0;
    CLI::App* derive_app = app.add_subcommand("derive", "list the steps of a derivation");
    derive_app->add_option("document", derive.document, "a .fil file, or an SVG that Filigree wrote")->required();
    add_open_flags(*derive_app, derive_flags);
    CLI::Option* derive_steps_option = derive_app->add_option("--steps", derive_steps, "stop after so many steps");
    derive_app->add_option("--threads", derive.threads, "how many threads work; the result is the same")
        ->check(CLI::Range(1, 1024));
    std::string format = "text";
    derive_app->add_option("--format", format, "text or json")
        ->check(CLI::IsMember({"text", "json"}))
        ->capture_default_str();
    derive_app->callback([&] {
        derive.open = open_options(derive_flags);
        if (derive_steps_option->count() > 0) derive.steps = derive_steps;
        derive.json = format == "json";
        run = [&] { return filigree::run_derive(derive); };
    });

    CLI::App* list_app = app.add_subcommand("list", "list engines, operators, start shapes and functions");
    list_app->callback([&] { run = filigree::run_list; });

    filigree::DescribeCommand describe;
    CLI::App* describe_app = app.add_subcommand("describe", "one operator's page");
    CLI::Option* name = describe_app->add_option("name", describe.name, "an operator, a start shape or an engine");
    CLI::Option* markdown = describe_app->add_flag("--markdown", describe.markdown, "the whole reference, as Markdown");
    CLI::Option* json = describe_app->add_flag("--json", describe.json, "all descriptions, as JSON");
    describe_app->callback([&] {
        if (name->count() + markdown->count() + json->count() != 1)
            throw CLI::RequiredError("describe: NAME, --markdown or --json");
        run = [&] { return filigree::run_describe(describe); };
    });

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& wrong) {
        return app.exit(wrong) == 0 ? 0 : 2;
    }
    const int status = run();
    std::cout.flush();
    return std::cout.fail() && status == 0 ? 3 : status;
}
