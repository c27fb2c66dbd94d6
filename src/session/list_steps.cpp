#include "session/list_steps.h"

#include <nlohmann/json.hpp>

#include "base/number_text.h"
#include "engines/tangle/paths.h"
#include "session/embed.h"

namespace filigree {
namespace {

using Json = nlohmann::ordered_json;
using tangle::Tangle;

// A tangle with what its parts are asked about.
struct Layer {
    const OpenedDocument& opened;
    const tangle::Grammar& grammar;
    const Tangle& tangle;
    std::string prefix;  // of paths
};

// Calls `visit` with a layer for every document that grows in a shape of the step.
template <class Visit>
void for_each_embedded(const Layer& layer, std::uint32_t number, const Visit& visit) {
    const tangle::Step& step = layer.tangle.steps[number];
    for (std::size_t i = 0; i < step.embedded.size(); ++i) {
        if (!step.embedded[i]) continue;
        const EmbeddedTangle* inner = tangle_in(*step.embedded[i]);
        if (inner == nullptr) continue;
        visit(Layer{*inner->opened, *inner->checked->grammar, inner->tangle,
                    layer.prefix + tangle::path_of_embedded(layer.tangle, layer.grammar, number, i) + "/"});
    }
}

void append_steps(std::string& text, const Layer& layer, const std::string& numbers) {
    const Tangle& tangle = layer.tangle;
    for (std::uint32_t s = 0; s < tangle.steps.size(); ++s) {
        const tangle::Step& step = tangle.steps[s];
        const tangle::Rule& rule = layer.grammar.rules[step.rule];
        const std::string number = numbers + std::to_string(s + 1);
        text += number + "  " + layer.prefix + tangle::path_of_step(tangle, layer.grammar, s) + "  (";
        if (!numbers.empty()) text += layer.opened.name + ", ";
        text += "line " + std::to_string(line_of(layer.opened.document, rule.span)) + ")  " +
                std::to_string(tangle.groups[step.group].shapes.size()) + " ->";
        for (std::uint32_t g = step.first_output; g < step.end_output; ++g) {
            const tangle::Group& group = tangle.groups[g];
            const std::string& tag = layer.grammar.tags[group.tag];
            text += " " + std::to_string(group.shapes.size()) + " " + (group.hidden ? "_" : tag.empty() ? "<>" : tag);
            if (g + 1 < step.end_output) text += ",";
        }
        text += "\n";
        for_each_embedded(layer, s, [&](const Layer& inner) { append_steps(text, inner, number + "."); });
    }
}

// Parameters that were not given are left out.
Json arguments_json(const Arguments& arguments) {
    Json json = Json::object();
    for (std::size_t i = 0; i < arguments.values.size(); ++i) {
        const ArgumentValue& argument = arguments.values[i];
        const std::string name(arguments.description->parameters[i].name);
        const std::string common = text_with_unit(argument.common);
        if (!argument.per_shape.empty()) {
            for (const Value& value : argument.per_shape) json[name].push_back(text_with_unit(value));
        } else if (common != tangle::not_given) {
            json[name] = common;
        }
    }
    return json;
}

Json group_json(const Layer& layer, std::uint32_t number) {
    const tangle::Group& group = layer.tangle.groups[number];
    Json json;
    json["number"] = number + 1;
    json["tag"] = layer.grammar.tags[group.tag];
    json["path"] = layer.prefix + tangle::path_of_group(layer.tangle, layer.grammar, number);
    json["key"] = to_hex(group.key.value);
    json["shapes"] = group.shapes.size();
    json["depth"] = group.depth;
    json["leaf"] = group.consumer == tangle::none;
    return json;
}

Json layer_json(const Layer& layer) {
    Json json;
    json["document"] = layer.opened.name;
    json["starts"] = Json::array();
    for (std::uint32_t g = 0; g < layer.tangle.start_groups; ++g) json["starts"].push_back(group_json(layer, g));
    json["steps"] = Json::array();
    for (std::uint32_t s = 0; s < layer.tangle.steps.size(); ++s) {
        const tangle::Step& step = layer.tangle.steps[s];
        const tangle::Rule& rule = layer.grammar.rules[step.rule];
        Json one;
        one["number"] = s + 1;
        one["path"] = layer.prefix + tangle::path_of_step(layer.tangle, layer.grammar, s);
        one["key"] = to_hex(step.key.value);
        one["line"] = line_of(layer.opened.document, rule.span);
        one["operator"] = rule.op->description.name;
        one["arguments"] = arguments_json(step.arguments);
        one["group"] = step.group + 1;
        one["outputs"] = Json::array();
        for (std::uint32_t g = step.first_output; g < step.end_output; ++g) {
            one["outputs"].push_back(group_json(layer, g));
        }
        for_each_embedded(layer, s, [&](const Layer& inner) { one["embedded"].push_back(layer_json(inner)); });
        json["steps"].push_back(std::move(one));
    }
    return json;
}

}  // namespace

std::uint32_t line_of(const Document& document, SourceSpan span) {
    if (span.file >= document.sources.size()) return 0;
    return line_column(document.sources[span.file].text, span.begin).line;
}

std::string steps_text(const OpenedDocument& opened, const CheckedDocument& checked, const Tangle& tangle) {
    std::string text;
    append_steps(text, {opened, *checked.grammar, tangle, ""}, "");
    return text;
}

std::string steps_json(const OpenedDocument& opened, const CheckedDocument& checked, const Tangle& tangle) {
    Json json;
    json["engine"] = checked.settings->engine;
    json["seed"] = checked.settings->seed;
    json.update(layer_json({opened, *checked.grammar, tangle, ""}));
    // Documents may name files in bytes that are no UTF-8; they are shown with replacement characters.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace filigree
