// Laws of derivation over random grammars and outlines.
#include <gtest/gtest.h>

#include "base/thread_pool.h"
#include "engines/tangle/verify.h"
#include "session/run.h"
#include "tests/random_document.h"

namespace filigree {
namespace {

using tangle::Tangle;

Result<Tangle> derived(const OpenedDocument& opened, const CheckedDocument& checked, Executor& executor,
                       std::optional<std::uint64_t> steps = std::nullopt) {
    RunOptions options;
    options.steps = steps;
    return derive_document(opened, checked, options, executor, {});
}

bool is_limit(const Diagnostics& diagnostics) {
    return !diagnostics.empty() && diagnostics.front().fault == Fault::limit;
}

// Whether one tangle is how another began: same groups, same steps, same geometry.
void expect_prefix(const Tangle& part, const Tangle& whole) {
    ASSERT_LE(part.steps.size(), whole.steps.size());
    ASSERT_LE(part.groups.size(), whole.groups.size());
    for (std::size_t s = 0; s < part.steps.size(); ++s) {
        EXPECT_EQ(part.steps[s].key, whole.steps[s].key);
        EXPECT_EQ(part.steps[s].rule, whole.steps[s].rule);
    }
    for (std::size_t g = 0; g < part.groups.size(); ++g) {
        ASSERT_EQ(part.groups[g].tag, whole.groups[g].tag);
        ASSERT_EQ(part.groups[g].shapes, whole.groups[g].shapes);
    }
    ASSERT_LE(part.geometry.size(), whole.geometry.size());
    for (std::size_t i = 0; i < part.geometry.size(); ++i) ASSERT_EQ(*part.geometry[i], *whole.geometry[i]);
}

TEST(TangleProperty, RandomGrammarsKeepTheInvariants) {
    SerialExecutor serial;
    ThreadPool threads(2);
    std::uint64_t finished = 0, steps = 0, shapes = 0;
    const std::uint64_t first = first_seed(), count = case_count(1000);
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const std::string text = RandomDocument(seed, document_scale()).text();
        const OpenedDocument opened = open_text("random.fil", text, {});
        const CheckedDocument checked = check_document(opened);
        ASSERT_FALSE(has_errors(checked.diagnostics)) << text << to_text(checked.diagnostics, opened.document.sources);
        EXPECT_EQ(opened.document.text(), text);
        const Result<Tangle> whole = derived(opened, checked, serial);
        if (!whole) {
            ASSERT_TRUE(is_limit(whole.diagnostics())) << text << to_text(whole.diagnostics(), opened.document.sources);
            continue;
        }
        ++finished;
        steps += whole->steps.size();
        const std::vector<std::string> broken = tangle::broken_invariants(*whole);
        ASSERT_TRUE(broken.empty()) << text << broken.front();
        for (const tangle::Group& group : whole->groups) shapes += group.shapes.size();

        const Result<Tangle> part = derived(opened, checked, serial, whole->steps.size() / 2);
        ASSERT_TRUE(part);
        EXPECT_EQ(part->steps.size(), whole->steps.size() / 2);
        expect_prefix(*part, *whole);
        const Result<Tangle> again = derived(opened, checked, threads);
        ASSERT_TRUE(again);
        EXPECT_EQ(again->groups.size(), whole->groups.size());
        expect_prefix(*again, *whole);
    }
    EXPECT_GT(finished * 10, count * 9) << "too many random documents reach a limit to tell anything";
    std::cout << finished << " derivations, " << steps << " steps, " << shapes << " shapes\n";
}

TEST(TangleProperty, AnotherSeedChangesThePicture) {
    SerialExecutor serial;
    std::uint64_t changed = 0;
    const std::uint64_t count = 50;
    for (std::uint64_t seed = 0; seed < count; ++seed) {
        const std::string tail = "start a = circle(80)\nplace(5..20, 25) : a -> b, c\nregular_split(9) : c -> d\n";
        const OpenedDocument one = open_text("a.fil", "grammar tangle\nseed " + std::to_string(seed) + "\n" + tail, {});
        const OpenedDocument two =
            open_text("a.fil", "grammar tangle\nseed " + std::to_string(seed + count) + "\n" + tail, {});
        const auto first = derived(one, check_document(one), serial),
                   second = derived(two, check_document(two), serial);
        ASSERT_TRUE(first && second);
        if (*first->geometry.back() != *second->geometry.back()) ++changed;
    }
    EXPECT_EQ(changed, count);
}

TEST(TangleProperty, RenamingATagChangesNoPicture) {
    SerialExecutor serial;
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        std::string text = "grammar tangle\nseed " + std::to_string(seed) +
                           "\nstart a = circle(80)\nplace(10, 25) : a -> blob, rest\nregular_split(9) : rest -> "
                           "d\noutline(2) : rest -> e, f\n";
        const OpenedDocument one = open_text("a.fil", text, {});
        for (std::size_t at; (at = text.find("rest")) != std::string::npos;) text.replace(at, 4, "sea");
        const OpenedDocument two = open_text("a.fil", text, {});
        const auto first = derived(one, check_document(one), serial),
                   second = derived(two, check_document(two), serial);
        ASSERT_TRUE(first && second);
        expect_prefix(*first, *second);
    }
}

TEST(TangleProperty, ARuleThatNeverFiresChangesNothing) {
    SerialExecutor serial;
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        const std::string text =
            "grammar tangle\nseed " + std::to_string(seed) +
            "\nstart a = circle(80)\nplace(10, 25) : a -> blob, rest\nregular_split(9) : rest -> d\n";
        const OpenedDocument one = open_text("a.fil", text, {});
        const OpenedDocument two =
            open_text("a.fil", text + "never = outline(3) : rest when count > 1000 -> x, y\n", {});
        const auto first = derived(one, check_document(one), serial),
                   second = derived(two, check_document(two), serial);
        ASSERT_TRUE(first && second);
        ASSERT_EQ(first->groups.size(), second->groups.size());
        for (std::size_t g = 0; g < first->groups.size(); ++g)
            EXPECT_EQ(first->groups[g].shapes, second->groups[g].shapes);
    }
}

}  // namespace
}  // namespace filigree
