#include "engines/rewriting/read_lookup.h"

#include <algorithm>
#include <utility>

#include "engines/rewriting/pattern.h"
#include "engines/rewriting/setting_values.h"
#include "formats/image_read.h"
#include "language/word_settings.h"

namespace filigree::rewriting {
namespace {

constexpr double largest_place = 0x1p30, smallest_side = 1e-6;  // px

// Told where the file is named.
Diagnostics in_file(Diagnostics problems, const std::string& file, SourceSpan span) {
    for (Diagnostic& problem : problems) {
        problem.message = "in '" + file + "': " + problem.message;
        problem.span = span;
    }
    return problems;
}

class MapReader {
public:
    MapReader(const Settings& settings, const Document& document, const Inputs& inputs)
        : values_(settings, document), inputs_(inputs) {}

    std::vector<Map> maps;
    Diagnostics problems() { return std::move(values_.diagnostics); }

    void read_all(const std::vector<Statement>& statements, bool is_outermost) {
        for (const Statement& statement : statements) {
            if (const auto* system = std::get_if<SystemStatement>(&statement.node)) read_all(system->statements, false);
            const auto* setting = std::get_if<SettingStatement>(&statement.node);
            if (setting == nullptr || !find_word_setting(setting->name.text)->is_map) continue;
            if (is_outermost) {
                read(*setting);
            } else {
                values_.report(error("rewriting.misplaced-setting",
                                     "'" + setting->name.text + "' is said of the whole document, outside its systems",
                                     setting->name.span));
            }
        }
    }

private:
    // wall "photo.png" over x, y, width, height [outside word]
    void read(const SettingStatement& setting) {
        const std::vector<ExpressionPtr>& said = setting.values;
        const auto is_word = [&](std::size_t at, std::string_view word) {
            const std::string* found = SettingValues::word_of(said[at]);
            return found != nullptr && *found == word;
        };
        const bool is_whole = (said.size() == 7 || (said.size() == 9 && is_word(7, "outside"))) && is_word(2, "over");
        const std::string* name = is_whole ? SettingValues::word_of(said[0]) : nullptr;
        const std::string* file = is_whole ? SettingValues::text_of(said[1]) : nullptr;
        if (name == nullptr || file == nullptr) return values_.fail_usage(setting);
        if (find_named(maps, *name) != nullptr) {
            return values_.report(
                error("rewriting.doubled-name", "there is already a map '" + *name + "'", said[0]->span));
        }
        Map map;
        map.name = *name;
        map.x = place(said[3], -largest_place);
        map.y = place(said[4], -largest_place);
        map.width = place(said[5], smallest_side);
        map.height = place(said[6], smallest_side);
        if (said.size() == 9) {
            map.outside = static_cast<Outside>(values_.one_of(said[8], {"clamp", "wrap", "none"}));
        }
        if (setting.name.text == "image") {
            map.cells = cells_of<ColourImage>(*file, said[1]->span, read_colour_image);
        } else {
            map.cells = cells_of<NumberTable>(*file, said[1]->span, read_numbers_csv);
        }
        maps.push_back(std::move(map));
    }

    double place(const ExpressionPtr& said, double least) {
        const std::optional<double> length = values_.length_of(said);
        if (!length) return 1;
        if (*length >= least && *length <= largest_place) return *length;
        const bool is_side = least > 0;
        if (is_side && *length < least) {
            values_.report(error("rewriting.empty-map", "this rectangle is empty", said->span,
                                 {"behind 'over' stand x, y, width and height"}));
        } else {
            values_.report(error("rewriting.out-of-range", "this length is too large", said->span));
        }
        return 1;
    }

    template <class Cells, class Read>
    Cells cells_of(const std::string& file, SourceSpan span, Read read_cells) {
        const Input* input = find_input(inputs_, file);
        if (input == nullptr) return {};
        Result<Cells> cells = read_cells(input->bytes);
        append(values_.diagnostics, in_file(cells.diagnostics(), file, span));
        return cells ? std::move(*cells) : Cells{};
    }

    SettingValues values_;
    const Inputs& inputs_;
};

Diagnostic unknown_map(const WordLookup& said, std::span<const Map> maps) {
    const std::string kind = said.is_image ? "image" : "data";
    std::vector<std::string_view> names;
    for (const Map& map : maps) {
        if (std::holds_alternative<ColourImage>(map.cells) == said.is_image) names.push_back(map.name);
    }
    std::vector<std::string> hints = did_you_mean(said.map.text, names);
    if (hints.empty()) {
        hints.push_back("declare it as in '" + std::string(find_word_setting(kind)->example) + "'");
    }
    return error("rewriting.unknown-map", "there is no '" + kind + " " + said.map.text + "'", said.map.span, hints);
}

}  // namespace

std::vector<Map> read_maps(const Settings& settings, const Document& document, const Inputs& inputs,
                           Diagnostics& problems) {
    MapReader reader(settings, document, inputs);
    reader.read_all(document.statements, true);
    append(problems, reader.problems());
    return std::move(reader.maps);
}

Result<Lookup> read_lookup(const WordLookup& said, std::span<const Map> maps, const Settings& settings,
                           const Document& document, bool frees_braces) {
    SettingValues values(settings, document);
    Lookup lookup;
    lookup.map = said.map.text;
    const Map* map = find_named(maps, said.map.text);
    if (map == nullptr) {
        values.report(unknown_map(said, maps));
    } else if (std::holds_alternative<ColourImage>(map->cells) != said.is_image) {
        const std::string kind = said.is_image ? "data" : "image";
        values.report(error("rewriting.wrong-map", "'" + said.map.text + "' is declared as '" + kind + "'",
                            said.map.span,
                            {"write '" + kind + " " + said.map.text + (said.is_image ? "" : " L") + " { ... }'"}));
    }
    if (said.is_image) {
        const auto channel = std::find(channel_names.begin(), channel_names.end(), said.channel.text);
        if (channel == channel_names.end()) {
            values.report(error("rewriting.unknown-channel", "'" + said.channel.text + "' is no channel",
                                said.channel.span, {"channels are R, G, B, A and L, the brightness"}));
        }
        lookup.channel = static_cast<Channel>(channel - channel_names.begin());
    }
    for (const WordLookupRow& row : said.rows) {
        const auto* range = std::get_if<RangeExpression>(&row.range->node);
        const std::optional<double> low = values.number_of(range != nullptr ? range->low : row.range);
        const std::optional<double> high = range != nullptr ? values.number_of(range->high) : low;
        if (low && high && *high < *low) {
            values.report(error("rewriting.empty-range", "this range is empty", row.range->span));
        }
        Result<Pattern> pattern = read_pattern(row.text.text, row.text.span, frees_braces);
        if (!pattern) append(values.diagnostics, pattern.diagnostics());
        if (low && high && pattern) lookup.rows.push_back({*low, *high, std::move(*pattern), row.text.span});
    }
    if (has_errors(values.diagnostics)) return std::move(values.diagnostics);
    return Result<Lookup>(std::move(lookup), std::move(values.diagnostics));
}

std::vector<std::string_view> names_looked_up(const Rule& rule, std::span<const Map> maps) {
    bool has_colours = false, has_numbers = false;
    for (const Successor& successor : rule.successors) {
        if (successor.kind != Successor::Kind::lookup) continue;
        const Map* map = find_named(maps, successor.lookup.map);
        has_colours = has_colours || map == nullptr || std::holds_alternative<ColourImage>(map->cells);
        has_numbers = has_numbers || map == nullptr || std::holds_alternative<NumberTable>(map->cells);
    }
    std::vector<std::string_view> names;
    if (has_colours) names.assign(channel_names.begin(), channel_names.end());
    if (has_numbers) names.push_back(number_name);
    return names;
}

}  // namespace filigree::rewriting
