// The operator streamline_split, run by itself on shapes with closed-form answers.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "engines/tangle/operators/operators.h"
#include "plane/streamline_test_shapes.h"
#include "plane/verify.h"

namespace filigree::tangle {
namespace {

using namespace test_shapes;

Value lengths(std::vector<double> px) {
    ValueList list;
    for (const double length : px) list.items.push_back({Quantity{length, 1, false}, {}});
    return {std::move(list), {}};
}

struct Split {
    Operator op = streamline_split_operator();
    Inputs inputs;
    ShapeSource forms{inputs, 0.1};
    SerialExecutor executor;
    Tangle tangle;
    std::vector<Shape> shapes;
    std::map<std::string_view, Value> given;  // besides the defaults
    std::uint64_t budget = 1'000'000;

    explicit Split(const Polygons& starts) {
        tangle.geometry.push_back(std::make_shared<const Polygons>(starts));
        for (std::uint32_t i = 0; i < starts.size(); ++i) {
            Shape shape;
            shape.key = Key{100 + i};
            shape.polygon = i;
            shapes.push_back(shape);
        }
        given["kind"] = {Symbol{"smooth"}, {}};
        given["offset"] = lengths({10});
        given["dual"] = {false, {}};
        given["mode"] = {Symbol{"iso"}, {}};
        given["centre"] = {Symbol{"centroid"}, {}};
        given["smoothing"] = {Quantity{3, 0, false}, {}};
    }
    Result<OperatorOutput> run() {
        Arguments arguments{&op.description, {}};
        for (const ParameterDescription& parameter : op.description.parameters) {
            arguments.values.push_back({given.at(parameter.name), {}});
        }
        return op.run({.tangle = tangle,
                       .shapes = shapes,
                       .arguments = arguments,
                       .scatter = 0,
                       .step = Key{7},
                       .resolution = 0.1,
                       .element_budget = budget,
                       .executor = executor,
                       .forms = forms});
    }
};

TEST(StreamlineSplit, IsDescribedByThePapersNames) {
    const OperatorDescription description = streamline_split_operator().description;
    EXPECT_EQ(description.name, "streamline_split");
    EXPECT_EQ(description.aliases, std::vector<std::string_view>{"streamlineSplit"});
    EXPECT_EQ(description.parameters[0].name, "kind");
    EXPECT_EQ(description.parameters[1].name, "offset");
    ASSERT_EQ(description.ports.size(), 1U);
    EXPECT_EQ(description.ports[0].name, "pieces");
}

TEST(StreamlineSplit, PiecesPartitionEveryShapeInEveryKindAndMode) {
    Polygons starts = rectangle(80, 80);
    starts.add(one_polygon({regular_ring({200, 0}, 50, 60), regular_ring({210, 0}, 15, 20)})[0]);
    for (const std::string_view kind : {"smooth", "strip", "circular", "circ", "smooth_outline"}) {
        for (const std::string_view mode : {"iso", "field"}) {
            for (const bool dual : {false, true}) {
                SCOPED_TRACE(std::string(kind) + " " + std::string(mode) + (dual ? " dual" : ""));
                Split split(starts);
                split.given["kind"] = {Symbol{std::string(kind)}, {}};
                split.given["mode"] = {Symbol{std::string(mode)}, {}};
                split.given["dual"] = {dual, {}};
                const Result<OperatorOutput> output = split.run();
                ASSERT_TRUE(output);
                ASSERT_EQ(output->groups.size(), 1U);
                const std::vector<Shape>& pieces = output->groups[0].shapes;
                ASSERT_EQ(pieces.size(), output->geometry.size());
                EXPECT_GE(pieces.size(), 8U);
                std::set<Key> keys;
                for (const Shape& piece : pieces) {
                    keys.insert(piece.key);
                    EXPECT_EQ(find_flaw(output->geometry[piece.polygon]), std::nullopt);
                }
                EXPECT_EQ(keys.size(), pieces.size());
                EXPECT_NEAR(area(output->geometry), area(starts), 1e-9 * area(starts));
                EXPECT_EQ(find_overlap(output->geometry), std::nullopt);
            }
        }
    }
}

TEST(StreamlineSplit, CirclesGoRoundTheGivenPoint) {
    Split split(rectangle(80, 80));
    split.given["kind"] = {Symbol{"circular"}, {}};
    split.given["centre"] = {Vec{-30, 40}, {}};
    const Result<OperatorOutput> output = split.run();
    ASSERT_TRUE(output);
    std::set<std::int32_t> columns;
    for (const Shape& piece : output->groups[0].shapes) {
        columns.insert(piece.column);
        for (const Point& p : output->geometry[piece.polygon].outer()) {
            const double at = length(to_px(p) - Vec{-30, 40});
            EXPECT_GT(at, 10 * piece.column - 2.6);
            EXPECT_LT(at, 10 * piece.column + 12.6);
        }
    }
    EXPECT_EQ(*columns.begin(), 3);
    EXPECT_EQ(columns.size(), 9U);
}

TEST(StreamlineSplit, KeysAreThoseOfTheParentAndStay) {
    Split alone(rectangle(80, 80));
    Polygons two = rectangle(40, 90);
    two.add(rectangle(80, 80)[0]);
    Split beside(two);
    alone.shapes[0].key = beside.shapes[1].key;
    const Result<OperatorOutput> one = alone.run(), other = beside.run();
    ASSERT_TRUE(one);
    ASSERT_TRUE(other);
    std::set<Key> keys;
    for (const Shape& piece : other->groups[0].shapes) keys.insert(piece.key);
    for (const Shape& piece : one->groups[0].shapes) EXPECT_EQ(keys.count(piece.key), 1U);
}

TEST(StreamlineSplit, RefusesMoreShapesThanTheBudget) {
    Split split(rectangle(800, 800));
    split.budget = 20;
    const Result<OperatorOutput> output = split.run();
    ASSERT_FALSE(output);
    EXPECT_EQ(output.diagnostics().front().code, "limit.elements");
}

}  // namespace
}  // namespace filigree::tangle
