#include "session/describe.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/number_text.h"
#include "derivation/start_shapes.h"
#include "language/evaluate.h"
#include "language/form_value.h"
#include "language/word_settings.h"
#include "session/engines.h"

namespace filigree {
namespace {

using Json = nlohmann::ordered_json;

constexpr double unbounded = 1e299;

std::string joined(const std::vector<std::string_view>& words, std::string_view separator) {
    std::string all;
    for (const std::string_view word : words) {
        if (!all.empty()) all += separator;
        all += word;
    }
    return all;
}

std::string padded(std::string_view text, std::size_t width) {
    std::string all(text);
    if (all.size() < width) all.append(width - all.size(), ' ');
    return all;
}

// "0.01 to 1000000", "at least 1", or nothing.
std::string range_text(const ParameterDescription& parameter) {
    const bool low = parameter.low > -unbounded, high = parameter.high < unbounded;
    const std::string unit =
        parameter.type == ParameterType::length || parameter.type == ParameterType::lengths ? " px" : "";
    if (low && high) return to_text(parameter.low) + " to " + to_text(parameter.high) + unit;
    if (low) return "at least " + to_text(parameter.low) + unit;
    if (high) return "at most " + to_text(parameter.high) + unit;
    return {};
}

// What a parameter takes: its type, words, range and default, in one line.
std::string takes_text(const ParameterDescription& parameter) {
    std::string text(type_name(parameter.type));
    if (parameter.repeats) text += ", or several";
    if (!parameter.words.empty())
        text += (parameter.type == ParameterType::word ? ": " : ", ") + joined(parameter.words, ", ");
    for (const std::string_view call : parameter.calls) text += ", " + std::string(call) + "(...)";
    for (const std::string_view form : form_names(parameter)) text += ", " + std::string(form) + "(...)";
    if (const std::string range = range_text(parameter); !range.empty()) text += "; " + range;
    text += parameter.default_text.empty() ? "; must be given" : "; default " + std::string(parameter.default_text);
    return text;
}

std::string signature(const OperatorDescription& op) {
    std::string text(op.name);
    text += "(";
    for (std::size_t i = 0; i < op.parameters.size(); ++i) {
        const ParameterDescription& parameter = op.parameters[i];
        if (i > 0) text += ", ";
        text += parameter.name;
        if (!parameter.default_text.empty()) text += " = " + std::string(parameter.default_text);
    }
    text += ")";
    for (std::size_t i = 0; i < op.ports.size(); ++i) text += (i == 0 ? " -> " : ", ") + std::string(op.ports[i].name);
    return text;
}

std::string operator_text(const OperatorDescription& op) {
    std::string text = signature(op) + "\n\n  " + std::string(op.help) + "\n  source: " + std::string(op.source) + "\n";
    if (!op.aliases.empty()) text += "  also written: " + joined(op.aliases, ", ") + "\n";
    if (!op.parameters.empty()) text += "\n  parameters\n";
    for (const ParameterDescription& parameter : op.parameters) {
        text += "    " + padded(parameter.name, 12) + " " + std::string(parameter.help) + "\n";
        text += "    " + padded("", 12) + " (" + takes_text(parameter) + ")\n";
        if (!parameter.aliases.empty()) {
            text += "    " + padded("", 12) + " (also named " + joined(parameter.aliases, ", ") + ")\n";
        }
    }
    if (!op.ports.empty()) text += "\n  outputs\n";
    for (const PortDescription& port : op.ports) {
        text += "    " + padded(port.name, 12) + " " + std::string(port.help) + "\n";
    }
    text += "\n  example\n    " + std::string(op.example) + "\n";
    return text;
}

std::string operator_markdown(const OperatorDescription& op) {
    std::string text =
        "### `" + std::string(op.name) + "`\n\n" + std::string(op.help) + ". Source: " + std::string(op.source) + ".";
    if (!op.aliases.empty()) text += " Also written `" + joined(op.aliases, "`, `") + "`.";
    text += "\n\n```\n" + std::string(op.example) + "\n```\n\n";
    if (!op.parameters.empty()) {
        text += "| parameter | takes | what it does |\n|---|---|---|\n";
        for (const ParameterDescription& parameter : op.parameters) {
            text += "| `" + std::string(parameter.name) + "` | " + takes_text(parameter) + " | " +
                    std::string(parameter.help) + " |\n";
        }
        text += "\n";
    }
    if (!op.ports.empty()) {
        text += "| output | what it is |\n|---|---|\n";
        for (const PortDescription& port : op.ports) {
            text += "| `" + std::string(port.name) + "` | " + std::string(port.help) + " |\n";
        }
        text += "\n";
    }
    return text;
}

Json operator_json(const OperatorDescription& op) {
    Json json;
    json["name"] = op.name;
    json["aliases"] = op.aliases;
    json["help"] = op.help;
    json["source"] = op.source;
    json["parameters"] = Json::array();
    for (const ParameterDescription& parameter : op.parameters) {
        Json one;
        one["name"] = parameter.name;
        one["type"] = type_name(parameter.type);
        one["help"] = parameter.help;
        if (!parameter.default_text.empty()) one["default"] = parameter.default_text;
        if (parameter.low > -unbounded) one["low"] = parameter.low;
        if (parameter.high < unbounded) one["high"] = parameter.high;
        if (!parameter.words.empty()) one["words"] = parameter.words;
        if (!parameter.calls.empty()) one["calls"] = parameter.calls;
        if (parameter.forms != nullptr) {
            one["forms"] = Json::array();
            for (const OperatorDescription& form : *parameter.forms) one["forms"].push_back(operator_json(form));
        }
        json["parameters"].push_back(std::move(one));
    }
    json["outputs"] = Json::array();
    for (const PortDescription& port : op.ports) json["outputs"].push_back({{"name", port.name}, {"help", port.help}});
    json["example"] = op.example;
    return json;
}

std::string engine_text(const EngineInfo& engine) {
    std::string text = std::string(engine.name) + ": " + std::string(engine.help) + "\n\n";
    for (const OperatorDescription* op : engine.operators) {
        text += "  " + padded(op->name, 16) + std::string(op->help) + "\n";
    }
    return text;
}

}  // namespace

std::string list_text() {
    std::string text = "engines and their operators (describe NAME shows one)\n\n";
    for (const EngineInfo& engine : engines()) text += engine_text(engine);
    text += "\nstart shapes\n\n";
    for (const OperatorDescription& shape : start_shape_descriptions()) {
        text += "  " + padded(shape.name, 16) + std::string(shape.help) + "\n";
    }
    text += "\nfunctions\n\n";
    for (const FunctionDescription& function : function_descriptions()) {
        text += "  " + padded(function.signature, 28) + std::string(function.help) + "\n";
    }
    text += "\nexamples\n\n";
    for (const ExampleInfo& example : examples()) {
        text += "  " + padded(example.file, 30) + std::string(example.title) + "\n";
    }
    return text;
}

Result<std::string> describe_text(std::string_view name) {
    std::vector<std::string_view> known;
    for (const EngineInfo& engine : engines()) {
        if (engine.name == name) return engine_text(engine);
        known.push_back(engine.name);
        for (const OperatorDescription* op : engine.operators) {
            known.push_back(op->name);
            known.insert(known.end(), op->aliases.begin(), op->aliases.end());
            if (op->name == name || std::find(op->aliases.begin(), op->aliases.end(), name) != op->aliases.end()) {
                return operator_text(*op);
            }
        }
    }
    for (const OperatorDescription& shape : start_shape_descriptions()) {
        if (shape.name == name) return operator_text(shape);
        known.push_back(shape.name);
    }
    Diagnostic unknown =
        error("describe.unknown-name", "there is no engine, operator or start shape '" + std::string(name) + "'", {},
              did_you_mean(name, known));
    unknown.fault = Fault::usage;
    if (unknown.hints.empty()) unknown.hints.push_back("`filigree list` shows all");
    return unknown;
}

std::string reference_markdown() {
    std::string text =
        "# Reference\n\nMade by `filigree describe --markdown` from the descriptions that the program itself uses.\n\n";
    for (const EngineInfo& engine : engines()) {
        if (engine.operators.empty()) continue;
        text += "## " + std::string(engine.operators_are) + " of `" + std::string(engine.name) +
                "`: " + std::string(engine.help) + "\n\n";
        for (const OperatorDescription* op : engine.operators) text += operator_markdown(*op);
    }
    text += "## Settings of `rewriting`\n\n| setting | what it says |\n|---|---|\n";
    for (const WordSetting& setting : word_settings()) {
        text += "| `" + std::string(setting.example) + "` | " + std::string(setting.help) + " |\n";
    }
    text += "\n";
    text += "## Start shapes\n\n";
    for (const OperatorDescription& shape : start_shape_descriptions()) text += operator_markdown(shape);
    text += "## Functions\n\n| function | what it gives |\n|---|---|\n";
    for (const FunctionDescription& function : function_descriptions()) {
        text += "| `" + std::string(function.signature) + "` | " + std::string(function.help) + " |\n";
    }
    return text;
}

std::string descriptions_json() {
    Json json;
    for (const EngineInfo& engine : engines()) {
        Json one;
        one["name"] = engine.name;
        one["help"] = engine.help;
        one["operators"] = Json::array();
        for (const OperatorDescription* op : engine.operators) one["operators"].push_back(operator_json(*op));
        json["engines"].push_back(std::move(one));
    }
    json["start_shapes"] = Json::array();
    for (const OperatorDescription& shape : start_shape_descriptions())
        json["start_shapes"].push_back(operator_json(shape));
    return json.dump(2) + "\n";
}

}  // namespace filigree
