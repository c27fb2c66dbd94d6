#include "session/list_choices.h"

#include <map>
#include <nlohmann/json.hpp>

#include "base/number_text.h"
#include "engines/shape/paths.h"
#include "engines/tangle/paths.h"
#include "language/style.h"
#include "session/embed.h"

namespace filigree {
namespace {

using tangle::none;
using tangle::Tangle;
using Visit = std::function<void(const ListedChoice&)>;

// Each is drawn under its own name, the k-th as NAME~k.
std::string path_of_definition(const Choices& choices, std::size_t row) {
    const std::string& name = choices.name_table[choices.names[row]];
    return "let/" + name.substr(0, name.find('~'));
}

void list_word(const WordRun& word, const std::string& prefix, const Visit& visit) {
    const Choices& definitions = word.choices;
    for (std::size_t row = 0; row < definitions.size(); ++row) {
        visit({prefix + path_of_definition(definitions, row), definitions.name_table[definitions.names[row]],
               &definitions, row});
    }
    if (!word.derivation.choices) return;
    const rewriting::WordChoices& choices = *word.derivation.choices;
    const Choices& made = choices.made();
    for (std::size_t row = 0; row < made.size(); ++row) {
        visit({prefix + choices.path_of(choices.spots_of_made()[row]), made.name_table[made.names[row]], &made, row});
    }
}

// Walks one tangle and those that grow in it. Its texts are kept from row to row.
class ChoiceLister {
public:
    ChoiceLister(const Tangle& tangle, const tangle::Grammar& grammar, std::string prefix, const Visit& visit)
        : tangle_(tangle), grammar_(grammar), prefix_(std::move(prefix)), visit_(visit) {}

    void list(const tangle::Picture& picture, const OpenedDocument& opened) {
        for (const Statement& statement : opened.document.statements) {
            if (std::holds_alternative<StyleStatement>(statement.node)) ++style_count_;
        }
        list_definitions();
        list_starts(opened);
        std::size_t leaf = 0;
        const auto& leaves = tangle_.leaf_choices;
        for (std::uint32_t s = 0; s < tangle_.steps.size(); ++s) {
            const tangle::Step& step = tangle_.steps[s];
            for (; leaf < leaves.size() && leaves[leaf].group < step.group; ++leaf) list_leaf(leaves[leaf]);
            list_rows(step.group, step.rule, step.first_choice, step.end_choice);
            list_embedded(s);
        }
        for (; leaf < leaves.size(); ++leaf) list_leaf(leaves[leaf]);
        list_styles(picture.choices, picture.styled);
    }

private:
    void hand_over(const Choices& choices, std::size_t row) {
        listed_.name = choices.name_table[choices.names[row]];
        listed_.choices = &choices;
        listed_.row = row;
        visit_(listed_);
    }
    // Where the texts of paths begin: behind what is around this document.
    void set_path(std::string_view path) {
        listed_.path.assign(prefix_);
        listed_.path += path;
    }

    void list_definitions() {
        for (std::size_t row = 0; row < tangle_.end_definition_choice; ++row) {
            set_path(path_of_definition(tangle_.choices, row));
            hand_over(tangle_.choices, row);
        }
    }

    void list_starts(const OpenedDocument& opened) {
        if (tangle_.end_start_choice == tangle_.end_definition_choice) return;
        for (std::size_t row = tangle_.end_definition_choice; row < tangle_.end_start_choice; ++row) {
            set_path(path_of_start(opened, tangle_.choices.keys[row]));
            hand_over(tangle_.choices, row);
        }
    }
    // The start statement whose key this is.
    std::string path_of_start(const OpenedDocument& opened, Key key) const {
        std::uint64_t number = 0;
        std::map<std::string, int> count;
        for (const Statement& statement : opened.document.statements) {
            const auto* start = std::get_if<StartStatement>(&statement.node);
            if (start == nullptr) continue;
            const int of_tag = ++count[start->tag.text];
            const Key own = child(Key{hash_text("start")}, ++number);
            if (own == key || child(root_, own.value) == key) {
                return of_tag == 1 ? start->tag.text : start->tag.text + "#" + std::to_string(of_tag);
            }
        }
        return "start";
    }

    void list_leaf(const tangle::LeafChoices& leaf) { list_rows(leaf.group, none, leaf.first_choice, leaf.end_choice); }

    // The rows of one group: its rule's, the conditions and weights of the rules that may expand it, the step's
    // arguments, and those of single shapes.
    void list_rows(std::uint32_t number, std::uint32_t rule, std::size_t first, std::size_t end) {
        if (first == end) return;
        const tangle::Group& group = tangle_.groups[number];
        group_path_ = tangle::path_of_group(tangle_, grammar_, number);
        const Key step = rule == none ? Key{} : child(group.key, grammar_.rules[rule].key.value);
        std::size_t shape = 0;
        Key last{};
        for (std::size_t row = first; row < end; ++row) {
            const Key key = tangle_.choices.keys[row];
            if (row == first || !(key == last)) {
                set_path(group_path_);
                add_place(group, rule, step, key, shape);
                last = key;
            }
            hand_over(tangle_.choices, row);
        }
    }

    // What stands behind the group's path, by the key that a choice was made at.
    void add_place(const tangle::Group& group, std::uint32_t rule, Key step, Key key, std::size_t& shape) {
        if (key == group.key) return;
        if (rule != none && key == step) {
            listed_.path += "/" + grammar_.rules[rule].segment;
            return;
        }
        for (const std::uint32_t r : grammar_.rules_of_tag[group.tag]) {
            if (key == child(group.key, grammar_.rules[r].key.value)) {
                listed_.path += "/" + grammar_.rules[r].segment;
                return;
            }
        }
        if (rule == none) return;
        // Shapes come in order, for one argument after another: the next one is mostly the one behind the last.
        for (std::size_t tried = 0; tried < group.shapes.size(); ++tried, ++shape) {
            if (shape >= group.shapes.size()) shape = 0;
            if (!(key == Key{fold(step.value, group.shapes[shape].key.value)})) continue;
            listed_.path += "/" + to_text(std::uint64_t{group.number_of(shape)}) + "/" + grammar_.rules[rule].segment;
            return;
        }
    }

    void list_embedded(std::uint32_t number) {
        const tangle::Step& step = tangle_.steps[number];
        for (std::size_t i = 0; i < step.embedded.size(); ++i) {
            if (!step.embedded[i]) continue;
            const std::string prefix = prefix_ + tangle::path_of_embedded(tangle_, grammar_, number, i) + "/";
            if (const EmbeddedWord* inner = word_in(*step.embedded[i])) list_word(inner->word, prefix, visit_);
            const EmbeddedTangle* inner = tangle_in(*step.embedded[i]);
            if (inner == nullptr) continue;
            ChoiceLister lister(inner->tangle, *inner->checked->grammar, prefix, visit_);
            lister.root_ = inner->root;
            lister.list(inner->picture, *inner->opened);
        }
    }

    void list_styles(const Choices& styles, const std::vector<tangle::StyledShape>& styled) {
        for (const tangle::StyledShape& one : styled) {
            const tangle::Group& group = tangle_.groups[one.group];
            const Key shape = tangle::style_key(group, one.shape);
            group_path_ = tangle::path_of_group(tangle_, grammar_, one.group) + "/" +
                          to_text(std::uint64_t{group.number_of(one.shape)});
            for (std::size_t row = one.first_choice; row < one.end_choice; ++row) {
                set_path(group_path_);
                for (std::size_t style = 1; style <= style_count_; ++style) {
                    const std::string segment = style_segment(style);
                    if (styles.keys[row] == child(shape, segment)) listed_.path += "/" + segment;
                }
                hand_over(styles, row);
            }
        }
    }

    const Tangle& tangle_;
    const tangle::Grammar& grammar_;
    const std::string prefix_;
    const Visit& visit_;
    Key root_{};
    std::size_t style_count_ = 0;
    ListedChoice listed_;
    std::string group_path_;
};

void append_json_text(std::string& out, std::string_view text) {
    static constexpr char digits[] = "0123456789abcdef";
    out += '"';
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (byte < 0x20) {
            out += "\\u00";
            out += digits[byte >> 4];
            out += digits[byte & 15];
        } else {
            out += c;
        }
    }
    out += '"';
}

// The domain's text is the same for many rows.
class DomainTexts {
public:
    const std::string& of(const Choices& choices, std::size_t row) {
        if (choices_ != &choices) {
            texts_.clear();
            choices_ = &choices;
        }
        const std::uint32_t domain = choices.domains[row];
        if (texts_.size() <= domain) texts_.resize(choices.domain_table.size());
        std::string& text = texts_[domain];
        if (text.empty()) append_json_text(text, domain_text(choices.domain_table[domain]));
        return text;
    }

private:
    const Choices* choices_ = nullptr;
    std::vector<std::string> texts_;  // as JSON
};

void append_row(std::string& out, const ListedChoice& choice, DomainTexts& domains) {
    const Choices& choices = *choice.choices;
    const ChoiceDomain& domain = choices.domain_table[choices.domains[choice.row]];
    out += "{\"path\": ";
    append_json_text(out, choice.path);
    out += ", \"name\": ";
    append_json_text(out, choice.name);
    out += ", \"value\": ";
    const bool is_number = domain.kind == ChoiceDomain::Kind::range || domain.kind == ChoiceDomain::Kind::normal;
    const Value value = value_of(choices, choice.row);
    if (const auto* quantity = is_number ? std::get_if<Quantity>(&value.data) : nullptr) {
        out += to_text(quantity->value);
    } else {
        append_json_text(out, plain_text(value));
    }
    out += ", \"domain\": ";
    out += domains.of(choices, choice.row);
    out += ", \"source\": \"";
    out += name_of(choices.sources[choice.row]);
    out += "\", \"key\": \"";
    out += to_hex(choices.keys[choice.row].value);
    out += "\"}";
}

}  // namespace

namespace {

// Of a design: those of its definitions, then of its steps, `rule` and `match` at the step and the others below it.
void list_design(const shape::Derivation& derivation, const shape::Grammar& grammar, const Visit& visit) {
    const Choices& choices = derivation.choices;
    const auto hand_over = [&](std::string path, std::size_t row) {
        visit({std::move(path), choices.name_table[choices.names[row]], &choices, row});
    };
    for (std::size_t row = 0; row < derivation.end_definition_choice; ++row) {
        hand_over(path_of_definition(choices, row), row);
    }
    for (std::uint32_t s = 1; s <= derivation.steps.size(); ++s) {
        const shape::Step& step = derivation.steps[s - 1];
        const std::string below = shape::path_of_state(derivation, grammar, s);
        for (std::size_t row = step.first_choice; row < step.end_choice; ++row) {
            const std::string& name = choices.name_table[choices.names[row]];
            const bool is_of_step = name == "rule" || name == "match";
            hand_over(is_of_step ? below.substr(0, below.find('/')) : below, row);
        }
    }
}

}  // namespace

void for_each_choice(const OpenedDocument& opened, const CheckedDocument& checked, const Run& run,
                     const std::function<void(const ListedChoice& choice)>& visit) {
    if (run.design) return list_design(run.design->derivation, *checked.design, visit);
    if (!run.word) return ChoiceLister(run.tangle, *checked.grammar, "", visit).list(run.picture, opened);
    list_word(*run.word, "", visit);
}

void list_choices(const OpenedDocument& opened, const CheckedDocument& checked, const Run& run, const TextSink& sink) {
    constexpr std::size_t piece_size = 1 << 16;
    std::string piece = "[";
    bool is_first = true;
    DomainTexts domains;
    for_each_choice(opened, checked, run, [&](const ListedChoice& choice) {
        piece += is_first ? "\n" : ",\n";
        is_first = false;
        append_row(piece, choice, domains);
        if (piece.size() < piece_size) return;
        sink(piece);
        piece.clear();
    });
    piece += is_first ? "]\n" : "\n]\n";
    sink(piece);
}

namespace {

std::optional<std::uint64_t> from_hex(const std::string& text) {
    if (text.size() != 16) return std::nullopt;
    std::uint64_t value = 0;
    for (const char c : text) {
        const int digit = c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
        if (digit < 0) return std::nullopt;
        value = value << 4 | static_cast<std::uint64_t>(digit);
    }
    return value;
}

}  // namespace

Result<Replay> read_choices(std::string_view text) {
    using Json = nlohmann::json;
    const Json all = Json::parse(text, nullptr, false);
    if (all.is_discarded() || !all.is_array()) {
        return error("choices.not-json", "this is no list of choices", {}, {"`filigree choices DOC` writes one"});
    }
    Replay replay;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Json& row = all[i];
        const auto text_of = [&](const char* name) -> std::optional<std::string> {
            if (!row.is_object() || !row.contains(name) || !row[name].is_string()) return std::nullopt;
            return row[name].get<std::string>();
        };
        const auto name = text_of("name"), hex = text_of("key");
        const auto key = hex ? from_hex(*hex) : std::nullopt;
        const bool has_value =
            row.is_object() && row.contains("value") && (row["value"].is_number() || text_of("value"));
        if (!name || !key || !has_value) {
            return error("choices.bad-row",
                         "choice " + std::to_string(i + 1) + " has no name, no value, or no key of 16 hex digits");
        }
        Value value;
        if (row["value"].is_number()) {
            value.data = Quantity{row["value"].get<double>(), 0, false};
        } else {
            value.data = *text_of("value");
        }
        replay.add(Key{*key}, *name, std::move(value));
    }
    return replay;
}

}  // namespace filigree
