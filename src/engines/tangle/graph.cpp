#include "engines/tangle/graph.h"

#include <algorithm>
#include <map>

#include "engines/tangle/operators/operators.h"

namespace filigree::tangle {
namespace {

// The tags that a rule can produce: of the ports that its operator has; all of them where it is unknown.
std::vector<const OutputTag*> produced(const GroupRule& rule) {
    std::vector<const OutputTag*> outputs;
    for (const OutputTag& output : rule.outputs) {
        if (!output.dropped && !output.tag.empty()) outputs.push_back(&output);
    }
    return outputs;
}

// Strongly connected components by Tarjan's algorithm, numbered so that successors come first.
std::vector<std::uint32_t> components(const std::vector<std::vector<std::uint32_t>>& successors) {
    const std::size_t count = successors.size();
    constexpr std::uint32_t unseen = UINT32_MAX;
    std::vector<std::uint32_t> component(count, unseen), order(count, unseen), low(count, 0);
    std::vector<std::uint32_t> open;  // nodes whose component is not known yet
    struct Frame {
        std::uint32_t node;
        std::size_t next;
    };
    std::vector<Frame> path;
    std::uint32_t visited = 0, found = 0;
    for (std::uint32_t root = 0; root < count; ++root) {
        if (order[root] != unseen) continue;
        path.push_back({root, 0});
        while (!path.empty()) {
            Frame& frame = path.back();
            const std::uint32_t node = frame.node;
            if (frame.next == 0) {
                order[node] = low[node] = visited++;
                open.push_back(node);
            }
            if (frame.next < successors[node].size()) {
                const std::uint32_t to = successors[node][frame.next++];
                if (order[to] == unseen) {
                    path.push_back({to, 0});
                } else if (component[to] == unseen) {
                    low[node] = std::min(low[node], order[to]);
                }
                continue;
            }
            if (low[node] == order[node]) {
                for (std::uint32_t member = unseen; member != node;) {
                    member = open.back();
                    open.pop_back();
                    component[member] = found;
                }
                ++found;
            }
            path.pop_back();
            if (!path.empty()) low[path.back().node] = std::min(low[path.back().node], low[node]);
        }
    }
    return component;
}

std::size_t longest_path(const std::vector<std::vector<std::uint32_t>>& successors) {
    const std::vector<std::uint32_t> component = components(successors);
    const std::uint32_t count = component.empty() ? 0 : 1 + *std::max_element(component.begin(), component.end());
    std::vector<std::size_t> size(count, 0), below(count, 0);
    for (const std::uint32_t c : component) ++size[c];
    // Successors have smaller numbers, so their lengths are known when their predecessors ask.
    std::vector<std::vector<std::uint32_t>> members(count);
    for (std::uint32_t node = 0; node < component.size(); ++node) members[component[node]].push_back(node);
    std::size_t longest = 0;
    std::vector<std::size_t> length(count, 0);
    for (std::uint32_t c = 0; c < count; ++c) {
        for (const std::uint32_t node : members[c]) {
            for (const std::uint32_t to : successors[node]) {
                if (component[to] != c) below[c] = std::max(below[c], length[component[to]]);
            }
        }
        length[c] = size[c] + below[c];
        longest = std::max(longest, length[c]);
    }
    return longest;
}

// Rules that can apply, given the tags of the starts.
std::vector<bool> reachable_rules(std::span<const GroupRule* const> rules, const RuleGraph& graph,
                                  std::span<const std::string> start_tags) {
    std::vector<bool> reached(rules.size(), false);
    std::vector<std::uint32_t> todo;
    const auto reach = [&](std::uint32_t rule) {
        if (reached[rule]) return;
        reached[rule] = true;
        todo.push_back(rule);
    };
    for (std::uint32_t r = 0; r < rules.size(); ++r) {
        if (std::find(start_tags.begin(), start_tags.end(), rules[r]->tag.text) != start_tags.end()) reach(r);
    }
    while (!todo.empty()) {
        const std::uint32_t rule = todo.back();
        todo.pop_back();
        for (const std::uint32_t next : graph.successors[rule]) reach(next);
    }
    return reached;
}

std::string line_of(const SourceSpan& span, const Sources& sources) {
    if (span.file >= sources.size()) return {};
    return std::to_string(line_column(sources[span.file].text, span.begin).line);
}

}  // namespace

RuleGraph rule_graph(std::span<const GroupRule* const> rules) {
    RuleGraph graph;
    std::map<std::string_view, std::vector<std::uint32_t>> by_tag;
    for (std::uint32_t r = 0; r < rules.size(); ++r) by_tag[rules[r]->tag.text].push_back(r);
    for (const GroupRule* rule : rules) {
        std::vector<std::uint32_t> next;
        for (const OutputTag* output : produced(*rule)) {
            const auto matching = by_tag.find(output->tag);
            if (matching != by_tag.end()) next.insert(next.end(), matching->second.begin(), matching->second.end());
        }
        std::sort(next.begin(), next.end());
        next.erase(std::unique(next.begin(), next.end()), next.end());
        graph.edges += next.size();
        graph.successors.push_back(std::move(next));
    }
    graph.longest_path = longest_path(graph.successors);
    return graph;
}

Diagnostics graph_warnings(const RuleGraph& graph, std::span<const GroupRule* const> rules, const Document& document,
                           std::span<const std::string> start_tags) {
    const std::vector<bool> reached = reachable_rules(rules, graph, start_tags);

    std::map<std::string_view, const OutputTag*> producers;  // the first that makes each tag
    for (const GroupRule* rule : rules) {
        for (const OutputTag* output : produced(*rule)) producers.emplace(output->tag, output);
    }
    std::vector<std::string_view> known(start_tags.begin(), start_tags.end());
    for (const auto& [tag, output] : producers) known.push_back(tag);

    Diagnostics warnings;
    for (std::size_t r = 0; r < rules.size(); ++r) {
        if (reached[r]) continue;
        const Name& tag = rules[r]->tag;
        if (producers.count(tag.text) != 0) {
            warnings.push_back(warning(
                "tangle.unreachable-rule",
                "the tag '" + tag.text + "' is produced only by rules that never apply, so neither does this one",
                tag.span));
            continue;
        }
        Diagnostic note = warning("tangle.unreachable-rule",
                                  "nothing produces the tag '" + tag.text + "', so this rule never applies", tag.span);
        const std::string_view near = nearest_name(tag.text, known);
        if (!near.empty()) {
            const auto producer = producers.find(near);
            note.hints.push_back(producer == producers.end() ? "'" + std::string(near) + "' is the tag of a start"
                                                             : "'" + std::string(near) + "' is produced on line " +
                                                                   line_of(producer->second->span, document.sources));
        }
        warnings.push_back(std::move(note));
    }

    // A cycle of steps that leave shapes as large as they are never ends by itself.
    std::vector<std::vector<std::uint32_t>> keeping(rules.size());
    for (std::uint32_t r = 0; r < rules.size(); ++r) {
        const Operator* op = find_operator(rules[r]->operator_name.text);
        if (op != nullptr && !op->description.shrinks) keeping[r] = graph.successors[r];
    }
    const std::vector<std::uint32_t> component = components(keeping);
    for (std::uint32_t r = 0; r < rules.size(); ++r) {
        const bool repeats = std::any_of(keeping[r].begin(), keeping[r].end(),
                                         [&](std::uint32_t next) { return component[next] == component[r]; });
        if (!reached[r] || !repeats) continue;
        warnings.push_back(warning("tangle.endless-rule",
                                   "this rule gives the tag '" + rules[r]->tag.text +
                                       "' back without making shapes smaller, so it can repeat without end",
                                   rules[r]->operator_name.span, {"a condition such as `when depth < 5` ends it"}));
    }
    return warnings;
}

}  // namespace filigree::tangle
