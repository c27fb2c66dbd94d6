#include "engines/shape/match_words.h"

#include "language/form_value.h"

namespace filigree::shape {
namespace {

constexpr double unbounded = 1e300;

ParameterDescription reflections_parameter() {
    return {.name = "reflections",
            .type = ParameterType::flag,
            .help = "whether mirror images match, too",
            .default_text = "true"};
}
ParameterDescription weights_parameter() {
    return {.name = "weights",
            .type = ParameterType::word,
            .help = "how heavy what is found must be, beside the left side",
            .default_text = "at_least",
            .words = {"at_least", "equal"}};
}
ParameterDescription scale_parameter(std::string_view name, std::string_view help, std::string_view default_text) {
    return {.name = name, .type = ParameterType::real, .help = help, .default_text = default_text, .low = 0};
}

OperatorDescription word(std::string_view name, std::string_view help, std::vector<ParameterDescription> parameters,
                         std::string_view source, std::string_view example) {
    return {.name = name, .help = help, .source = source, .parameters = std::move(parameters), .example = example};
}

std::vector<OperatorDescription> make_words() {
    const std::string_view section = "Jowers & Earl, section 2.2";
    std::vector<OperatorDescription> words;
    words.push_back(word("translation", "moved alone", {weights_parameter()}, section,
                         "slide = petal -> translate(2, 2) * petal match translation"));
    words.push_back(word("isometry", "moved, turned and mirrored", {reflections_parameter(), weights_parameter()},
                         section, "slide = petal -> translate(2, 2) * petal match isometry(reflections: false)"));
    std::vector<ParameterDescription> scaled = {
        reflections_parameter(), scale_parameter("min_scale", "no smaller than this", "0"),
        scale_parameter("max_scale", "no larger than this; 0: as large as any", "0"), weights_parameter()};
    words.push_back(word("similarity", "moved, turned, mirrored and scaled", scaled, section,
                         "slide = petal -> translate(2, 2) * petal match similarity(max_scale: 2)"));
    words.push_back(word("affine", "stretched and sheared, too", scaled, "Jowers & Earl, section 5",
                         "cut = triangle -> triangle + line((0, 0), (1, 1)) match affine"));
    words.push_back(word("corners", "every polygon with as many corners, however it is stretched",
                         {{.name = "reflections",
                           .type = ParameterType::flag,
                           .help = "whether its corners are named the other way round, too",
                           .default_text = "true"}},
                         "Stiny, Ice-ray",
                         "cut = rectangle(1, 1) -> rectangle(1, 1) + line((0, -0.5), (0, 0.5)) match corners"));
    std::vector<ParameterDescription> visual = {
        {.name = "tolerance", .type = ParameterType::length, .help = "how far what is found may lie off", .low = 1e-9},
        {.name = "maps",
         .type = ParameterType::word,
         .help = "the maps",
         .default_text = "similarity",
         .words = {"translation", "isometry", "similarity"}}};
    visual.insert(visual.end(), scaled.begin(), scaled.end());
    words.push_back(word("visual", "by looks: curves of other descriptors that lie as near as the tolerance, too",
                         visual, "Jowers & Earl, section 5, figure 23",
                         "slide = petal -> translate(2, 2) * petal match visual(0.2)"));
    return words;
}

curves::MatchGroup group_of(std::string_view name) {
    if (name == "translation") return curves::MatchGroup::translation;
    if (name == "isometry") return curves::MatchGroup::isometry;
    if (name == "affine") return curves::MatchGroup::affine;
    return curves::MatchGroup::similarity;
}

bool has_argument(const SymbolicCall& call, std::string_view name) {
    for (const NamedValue& argument : call.arguments) {
        if (argument.name == name) return true;
    }
    return false;
}

}  // namespace

const std::vector<OperatorDescription>& match_words() {
    static const std::vector<OperatorDescription> words = make_words();
    return words;
}

Result<MatchWord> match_of(const Value& value, const Document& document) {
    ParameterDescription parameter{.name = "match", .type = ParameterType::form};
    parameter.forms = &match_words();
    Value call = value;
    if (const auto* bare = std::get_if<Symbol>(&value.data)) call.data = SymbolicCall{bare->name, {}};
    const auto* named = std::get_if<SymbolicCall>(&call.data);
    std::vector<std::string_view> known;
    for (const OperatorDescription& one : match_words()) known.push_back(one.name);
    if (named == nullptr || find_operator(match_words(), named->name) == nullptr) {
        std::vector<std::string> hints;
        if (named != nullptr) hints = did_you_mean(named->name, known);
        if (hints.empty()) hints.push_back("one of translation, isometry, similarity, affine, corners and visual(0.5)");
        return error("shape.unknown-match",
                     named != nullptr ? "there is no kind of match '" + named->name + "'"
                                      : "expected a kind of match, found " + std::string(kind_of(value)),
                     value.span, hints);
    }
    const Result<Value> bound = to_form(parameter, call, document, value.span);
    if (!bound) return bound.diagnostics();
    const auto& form = std::get<SymbolicCall>(bound->data);
    MatchWord word;
    word.by_corners = form.name == "corners";
    word.options.group = group_of(form.name == "visual" ? word_of(form, "maps") : std::string_view(form.name));
    if (has_argument(form, "reflections")) {
        word.options.with_reflections = std::get<bool>(argument_of(form, "reflections").data);
    }
    if (has_argument(form, "weights")) {
        word.options.weights =
            word_of(form, "weights") == "equal" ? curves::WeightRule::equal : curves::WeightRule::at_least;
    }
    if (has_argument(form, "min_scale")) {
        word.options.min_scale = number_of(form, "min_scale");
        const double most = number_of(form, "max_scale");
        word.options.max_scale = most > 0 ? most : unbounded;
        if (word.options.min_scale > word.options.max_scale) {
            return error("shape.empty-scale",
                         "no scale is at least " + to_text(argument_of(form, "min_scale")) + " and at most " +
                             to_text(argument_of(form, "max_scale")),
                         value.span);
        }
    }
    if (form.name == "visual") word.options.visual_tolerance = number_of(form, "tolerance");
    return word;
}

}  // namespace filigree::shape
