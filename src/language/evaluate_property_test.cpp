// Expressions at random: against an oracle of its own, and trees of any shape that must neither crash nor err
// without a place.
#include <cmath>

#include "base/number_text.h"
#include "base/test_cases.h"
#include "language/bind.h"
#include "language/check.h"
#include "language/names.h"
#include "language/text_evaluation.h"

namespace filigree {
namespace {

// --- text and value side by side --------------------------------------------------------------------------------

struct Known {
    std::string text;
    double value = 0;
};

// Builds expressions of a wanted dimension together with what they come to, in px, by means of the standard
// library; the file's unit is mm.
class KnownBuilder {
public:
    explicit KnownBuilder(std::uint64_t seed) : random_(seed) {}

    Known bare(int depth) {
        if (depth <= 0) return literal("", 1);
        switch (random_.below(9)) {
            case 0:
                return sum(bare(depth - 1), bare(depth - 1));
            case 1:
                return product(bare(depth - 1), bare(depth - 1));
            case 2: {
                const Known a = length(depth - 1), b = length(depth - 1);
                return quotient(a, b);
            }
            case 3: {
                const Known a = angle(depth - 1);
                const double sine = std::sin(std::remainder(a.value, 360) * M_PI / 180);
                // The library misses the zeros, which are exact here.
                return {"sin(" + a.text + ")", std::fabs(sine) < 1e-12 ? 0 : sine};
            }
            case 4: {
                const Known a = bare(depth - 1), b = bare(depth - 1);
                return {"max(" + a.text + ", " + b.text + ")", std::max(a.value, b.value)};
            }
            case 5: {
                const Known a = bare(depth - 1);
                return {"-" + a.text, -a.value};
            }
            case 6: {
                const Known a = length(depth - 1), b = length(depth - 1), c = bare(depth - 1), d = bare(depth - 1);
                if (close(a, b)) return c;
                return {"(" + a.text + " < " + b.text + " ? " + c.text + " : " + d.text + ")",
                        a.value < b.value ? c.value : d.value};
            }
            case 7: {
                const Known a = bare(depth - 1);
                return {"exp(-abs(" + a.text + "))", std::exp(-std::fabs(a.value))};
            }
            default:
                return literal("", 1);
        }
    }
    Known length(int depth) {
        constexpr double mm = 96 / 25.4;
        if (depth <= 0) return random_.below(2) == 0 ? literal("mm", mm) : literal("pt", 96.0 / 72);
        switch (random_.below(8)) {
            case 0:
                return sum(length(depth - 1), length(depth - 1));
            case 1: {
                Known b = bare(depth - 1);
                b.value *= mm;
                return sum(length(depth - 1), b);
            }
            case 2:
                return product(bare(depth - 1), length(depth - 1));
            case 3:
                return quotient(area(depth - 1), length(depth - 1));
            case 4: {
                const Known a = area(depth - 1);
                if (std::fabs(a.value) < 1e-3) return literal("in", 96);  // where rounding would show
                return {"sqrt(abs(" + a.text + "))", std::sqrt(std::fabs(a.value))};
            }
            case 5: {
                const Known a = length(depth - 1), b = length(depth - 1);
                return {"hypot(" + a.text + ", " + b.text + ")", std::hypot(a.value, b.value)};
            }
            case 6: {
                const Known a = length(depth - 1), b = length(depth - 1), t = bare(depth - 1);
                return {"lerp(" + a.text + ", " + b.text + ", " + t.text + ")",
                        a.value + (b.value - a.value) * t.value};
            }
            default:
                return literal("in", 96);
        }
    }
    Known area(int depth) {
        if (random_.below(3) == 0) {
            const Known a = length(depth - 1);
            return {"pow(" + a.text + ", 2)", a.value * a.value};
        }
        return product(length(depth - 1), length(depth - 1));
    }
    Known angle(int depth) {
        if (depth <= 0) return random_.below(2) == 0 ? literal("deg", 1) : literal("turn", 360);
        switch (random_.below(4)) {
            case 0:
                return sum(angle(depth - 1), angle(depth - 1));
            case 1:
                return product(angle(depth - 1), bare(depth - 1));
            case 2: {
                const Known a = length(depth - 1), b = length(depth - 1);
                return {"atan2(abs(" + a.text + "), abs(" + b.text + "))",
                        std::atan2(std::fabs(a.value), std::fabs(b.value)) * 180 / M_PI};
            }
            default:
                return literal("deg", 1);
        }
    }

private:
    CaseRandom random_;

    static bool close(const Known& a, const Known& b) {
        return std::fabs(a.value - b.value) <= 1e-6 * (std::fabs(a.value) + std::fabs(b.value));
    }
    Known literal(const std::string& unit, double factor) {
        const double value = std::round(random_.between(1, 100)) / 8;
        return {to_text(value) + unit, value * factor};
    }
    static Known sum(const Known& a, const Known& b) {
        return {"(" + a.text + " + " + b.text + ")", a.value + b.value};
    }
    static Known product(const Known& a, const Known& b) {
        return {"(" + a.text + " * " + b.text + ")", a.value * b.value};
    }
    static Known quotient(const Known& a, const Known& b) {
        if (std::fabs(b.value) < 1e-3) return {"(" + a.text + " / 1in)", a.value / 96};
        return {"(" + a.text + " / " + b.text + ")", a.value / b.value};
    }
};

TEST(RandomExpressions, ComeToWhatTheStandardLibrarySays) {
    const Document document = document_of("unit mm\n");
    Evaluation at;
    at.document = &document;
    std::uint64_t compared = 0;
    for (std::uint64_t seed = 1; seed <= case_count(1000); ++seed) {
        KnownBuilder builder(seed);
        const Known known = seed % 3 == 0 ? builder.bare(4) : seed % 3 == 1 ? builder.length(4) : builder.angle(4);
        const Result<Value> value = evaluate(*expression_of(known.text), at);
        if (!std::isfinite(known.value) || std::fabs(known.value) > 1e12) continue;
        ASSERT_TRUE(value) << seed << ": " << known.text << "\n" << shown(value);
        const Quantity& quantity = std::get<Quantity>(value->data);
        EXPECT_EQ(quantity.length_power, seed % 3 == 1 ? 1 : 0) << seed << ": " << known.text;
        EXPECT_EQ(quantity.is_angle, seed % 3 == 2) << seed << ": " << known.text;
        // Cancellation may cost digits: as many as the numbers within are larger.
        EXPECT_NEAR(quantity.value, known.value, 1e-6 * (1 + std::fabs(known.value))) << seed << ": " << known.text;
        ++compared;
    }
    EXPECT_GT(compared, 0U);
}

// --- trees of any shape -----------------------------------------------------------------------------------------

class TreeBuilder {
public:
    explicit TreeBuilder(std::uint64_t seed) : random_(seed) {}

    ExpressionPtr tree(int depth) {
        if (depth > 0 && random_.below(60) == 0) return nullptr;
        Expression out;
        out.span = {0, place_, place_ + 1};
        ++place_;
        switch (depth <= 0 ? random_.below(6) : random_.below(17)) {
            case 0:
                out.node = NumberLiteral{number(), static_cast<Unit>(random_.below(14))};
                break;
            case 1:
                out.node = NumberLiteral{static_cast<double>(random_.below(5)), Unit::none};
                break;
            case 2:
                out.node = NameReference{std::string(name())};
                break;
            case 3:
                out.node = TextLiteral{"a"};
                break;
            case 4:
                out.node = BoolLiteral{random_.below(2) == 0};
                break;
            case 5:
                out.node = ColourLiteral{};
                break;
            case 6:
                out.node = ListExpression{several(depth, 3)};
                break;
            case 7:
                out.node = PointExpression{several(depth, 3)};
                break;
            case 8:
                out.node = UnaryExpression{static_cast<UnaryOperator>(random_.below(2)), tree(depth - 1)};
                break;
            case 9:
            case 10: {
                const auto op = static_cast<BinaryOperator>(random_.below(13));
                ExpressionPtr left = tree(depth - 1);
                out.node = BinaryExpression{op, std::move(left), tree(depth - 1)};
                break;
            }
            case 11: {
                ExpressionPtr condition = tree(depth - 1), when_true = tree(depth - 1);
                out.node = ConditionalExpression{condition, when_true, tree(depth - 1)};
                break;
            }
            case 12: {
                ExpressionPtr low = tree(depth - 1);
                out.node = RangeExpression{low, tree(depth - 1)};
                break;
            }
            case 13: {
                ExpressionPtr value = tree(depth - 1);
                out.node = WithinExpression{value, tree(depth - 1)};
                break;
            }
            case 14:
                out.node = MemberExpression{tree(depth - 1), "width"};
                break;
            default: {
                CallExpression call{std::string(call_name()), {0, place_, place_ + 1}, {}};
                for (std::uint32_t i = random_.below(4); i > 0; --i) {
                    ExpressionPtr key = random_.below(4) == 0 ? tree(depth - 1) : nullptr;
                    call.arguments.push_back({key, tree(depth - 1)});
                }
                out.node = std::move(call);
            }
        }
        return std::make_shared<Expression>(std::move(out));
    }

private:
    CaseRandom random_;
    std::uint32_t place_ = 0;

    double number() {
        constexpr double odd[] = {0, -1, 1e308, -1e308, 1e-320, 0.5, 3, 7};
        return odd[random_.below(8)];
    }
    std::string_view name() {
        constexpr std::string_view names[] = {"gap", "page", "index", "line", "ink", "nowhere", "bad", "area", "max"};
        return names[random_.below(9)];
    }
    std::string_view call_name() {
        constexpr std::string_view special[] = {"one_of", "normal", "each", "ink", "turn", "nothing", "gap"};
        const auto functions = function_descriptions();
        const std::uint32_t k = random_.below(27);
        if (k < 7) return special[k];
        const std::string_view signature = functions[k - 7].signature;
        return signature.substr(0, signature.find('('));
    }
    std::vector<ExpressionPtr> several(int depth, std::uint32_t most) {
        std::vector<ExpressionPtr> out;
        for (std::uint32_t i = random_.below(most + 1); i > 0; --i) out.push_back(tree(depth - 1));
        return out;
    }
};

bool all_placed(const Diagnostics& diagnostics) {
    return !diagnostics.empty() && std::all_of(diagnostics.begin(), diagnostics.end(), [](const Diagnostic& one) {
        return one.span.file == 0 && one.severity == Severity::error && !one.message.empty();
    });
}

bool is_finite(const Value& value) {
    if (const Quantity* quantity = std::get_if<Quantity>(&value.data)) return std::isfinite(quantity->value);
    if (const Vec* point = std::get_if<Vec>(&value.data)) return std::isfinite(point->x) && std::isfinite(point->y);
    return true;
}

TEST(RandomTrees, NeverCrashAndErrorsHaveAPlace) {
    const Document document = document_of("unit mm\n");
    Scope globals, shape;
    globals.names["gap"] = number_value(5);
    globals.names["page.width"] = length_value(100);
    globals.names["bad"] = number_value(std::nan(""));
    globals.names["area"] = area_value(50);
    globals.names["ink"] = Value{ValueList{{Value{Colour{}, {}}, number_value(3)}}, {}};
    shape.names["index"] = number_value(2);
    const ParameterDescription parameters[] = {
        {.name = "a", .type = ParameterType::whole, .default_text = "3", .low = 1, .high = 9},
        {.name = "b", .type = ParameterType::lengths, .default_text = "3", .low = 0},
        {.name = "c", .type = ParameterType::direction, .default_text = "0", .words = {"line"}, .calls = {"turn"}},
        {.name = "d", .type = ParameterType::colour, .default_text = "black"},
        {.name = "e", .type = ParameterType::flag, .default_text = "0"},
    };
    const OperatorDescription description{.name = "f", .parameters = {std::begin(parameters), std::end(parameters)}};
    const std::vector<ShapeContext> shapes = {{Key{1}, shape}, {Key{2}, shape}};
    std::uint64_t good = 0;
    for (std::uint64_t seed = 1; seed <= case_count(20000); ++seed) {
        ExpressionPtr tree = TreeBuilder(seed).tree(1 + static_cast<int>(seed % 5));
        if (!tree) continue;
        Evaluation at;
        at.document = &document;
        at.scope = &globals;
        at.site = {seed, Key{9}, "a"};
        at.whole = seed % 2 == 0;
        if (seed % 3 == 0) at.words = {"line"};
        if (seed % 4 == 0) at.calls = {seed % 8 == 0 ? "*" : "turn"};
        if (seed % 5 != 0) {
            at.shape_scope = &shape;
            at.shape_key = Key{seed};
        }
        at.by_shape = seed % 7 == 0;
        const Result<Value> value = evaluate(*tree, at), again = evaluate(*tree, at);
        ASSERT_EQ(shown(value), shown(again)) << seed;
        if (value) {
            ++good;
            ASSERT_TRUE(is_finite(*value)) << seed;
            // What evaluates has nothing that is wrong whatever the values.
            Diagnostics unknown = check_expression(*tree, at);
            std::erase_if(unknown, [](const Diagnostic& one) { return one.code != "language.each-outside"; });
            ASSERT_TRUE(unknown.empty()) << seed;
        } else {
            ASSERT_TRUE(all_placed(value.diagnostics())) << seed;
        }
        for (const bool is_named : {false, true}) {
            CallArgument argument{nullptr, tree};
            if (is_named) argument.key = std::make_shared<Expression>(Expression{{0, 0, 1}, NameReference{"c"}});
            const Result<BoundCall> call = bind(description, {argument}, {0, 0, 5}, document, globals);
            if (!call) {
                ASSERT_TRUE(all_placed(call.diagnostics())) << seed;
                continue;
            }
            const Scope step = example_scope(step_names(), &globals);
            StepChoices choices;
            choices.seed.value = seed;
            const Result<Arguments> arguments = evaluate_arguments(*call, document, step, choices, Key{1}, shapes);
            if (!arguments) {
                ASSERT_TRUE(all_placed(arguments.diagnostics())) << seed;
                continue;
            }
            const double a = arguments->number("a");
            ASSERT_TRUE(a >= 1 && a <= 9 && a == std::floor(a)) << seed;
            for (const double px : arguments->lengths("b")) ASSERT_GT(px, 0) << seed;
        }
    }
    EXPECT_GT(good, case_count(20000) / 20);
}

// --- draws ------------------------------------------------------------------------------------------------------

TEST(RandomDraws, StayInTheirDomainAndInOrder) {
    Evaluation at;
    for (std::uint64_t seed = 1; seed <= case_count(1000); ++seed) {
        CaseRandom random(seed);
        const double low = std::round(random.between(-50, 50)), high = low + std::round(random.between(0, 30));
        const double mean = random.between(-60, 90), deviation = random.between(0, 20);
        const std::string range = "(" + to_text(low) + ")..(" + to_text(high) + ")";
        const std::string normal = "normal(" + to_text(mean) + ", " + to_text(deviation) + ") in " + range;
        at.site = {seed, Key{4}, "x"};
        for (const std::string& text : {range, normal}) {
            for (const bool whole : {false, true}) {
                at.whole = whole;
                const Result<Value> value = evaluate(*expression_of(text), at);
                ASSERT_TRUE(value) << seed << " " << text;
                const double number = std::get<Quantity>(value->data).value;
                ASSERT_TRUE(number >= low && number <= high) << seed << " " << text << " " << number;
                if (whole) {
                    ASSERT_EQ(number, std::round(number)) << seed;
                }
            }
        }
        // Two sites keep their order when both ranges are narrowed alike.
        at.whole = false;
        const auto drawn_at = [&](std::uint64_t key, const std::string& text) {
            at.site.key = Key{key};
            return std::get<Quantity>(evaluate(*expression_of(text), at)->data).value;
        };
        const std::string wide = "normal(0, 2) in -3..3", narrow = "normal(0, 2) in 0.5..1";
        EXPECT_EQ(drawn_at(1, wide) < drawn_at(2, wide), drawn_at(1, narrow) < drawn_at(2, narrow)) << seed;
        EXPECT_EQ(drawn_at(1, "0..9") < drawn_at(2, "0..9"), drawn_at(1, "3..4") < drawn_at(2, "3..4")) << seed;
    }
}

}  // namespace
}  // namespace filigree
