#include "base/thread_pool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <numeric>
#include <thread>
#include <vector>

#include "base/random.h"
#include "base/test_cases.h"

namespace filigree {
namespace {

// How often each item was run.
std::vector<int> runs(Executor& executor, std::size_t count) {
    std::vector<int> times(count, 0);
    executor.run(count, [&](std::size_t i) { ++times[i]; });
    return times;
}

bool each_once(const std::vector<int>& times) {
    return std::all_of(times.begin(), times.end(), [](int n) { return n == 1; });
}

TEST(ThreadPool, RunsEachItemOnce) {
    for (const std::size_t threads : {1U, 2U, 3U, 8U}) {
        ThreadPool pool(threads);
        EXPECT_EQ(pool.width(), threads);
        for (const std::size_t count : {0U, 1U, 2U, 3U, 7U, 8U, 9U, 63U, 1000U, 100'000U}) {
            EXPECT_TRUE(each_once(runs(pool, count))) << threads << " threads, " << count << " items";
        }
    }
}

TEST(ThreadPool, HasAtLeastOneThread) {
    ThreadPool pool(0);
    EXPECT_EQ(pool.width(), 1U);
    EXPECT_TRUE(each_once(runs(pool, 10)));
}

TEST(ThreadPool, OneThreadRunsInOrderOnTheCaller) {
    ThreadPool pool(1);
    std::vector<std::size_t> order;
    const auto caller = std::this_thread::get_id();
    pool.run(100, [&](std::size_t i) {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        order.push_back(i);
    });
    std::vector<std::size_t> wanted(100);
    std::iota(wanted.begin(), wanted.end(), std::size_t{0});
    EXPECT_EQ(order, wanted);
}

TEST(ThreadPool, ManyTinyLoops) {
    ThreadPool pool(4);
    std::vector<std::uint64_t> sums(16, 0);
    const std::uint64_t loops = 5 * case_count();
    for (std::uint64_t i = 0; i < loops; ++i) {
        // Each loop reads what the one before wrote, on whichever thread.
        pool.run(i % 17, [&](std::size_t k) { sums[k] = sums[k] * 3 + i; });
    }
    std::vector<std::uint64_t> wanted(16, 0);
    for (std::uint64_t i = 0; i < loops; ++i) {
        for (std::size_t k = 0; k < i % 17; ++k) wanted[k] = wanted[k] * 3 + i;
    }
    EXPECT_EQ(sums, wanted);
}

TEST(ThreadPool, UnevenItemsGiveTheSerialResult) {
    ThreadPool pool(4);
    SerialExecutor serial;
    for (std::uint64_t seed = 1; seed <= case_count() / 20; ++seed) {
        const auto fill = [&](Executor& executor) {
            std::vector<std::uint64_t> out(300);
            executor.run(out.size(), [&](std::size_t i) {
                std::uint64_t value = fold(seed, i);
                for (std::uint64_t k = mix(value) % (i % 50 == 0 ? 5000 : 20); k > 0; --k) value = mix(value);
                out[i] = value;
            });
            return out;
        };
        ASSERT_EQ(fill(pool), fill(serial)) << "seed " << seed;
    }
}

TEST(ThreadPool, LoopsInsideBodiesRunInPlace) {
    ThreadPool pool(4);
    ThreadPool other(3);
    std::vector<std::vector<int>> times(50, std::vector<int>(40, 0));
    pool.run(times.size(), [&](std::size_t i) {
        const auto thread = std::this_thread::get_id();
        std::size_t last = 0;
        Executor& inner = i % 2 == 0 ? static_cast<Executor&>(pool) : other;
        inner.run(times[i].size(), [&](std::size_t k) {
            EXPECT_EQ(std::this_thread::get_id(), thread);
            EXPECT_GE(k, last);
            last = k;
            ++times[i][k];
        });
    });
    for (const std::vector<int>& row : times) EXPECT_TRUE(each_once(row));
    // The caller is outside again.
    std::atomic<int> count = 0;
    pool.run(1000, [&](std::size_t) { ++count; });
    EXPECT_EQ(count, 1000);
}

TEST(ThreadPool, OneItemLeavesTheThreadsToLoopsInsideIt) {
    ThreadPool pool(3);
    pool.run(1, [&](std::size_t) {
        std::atomic<int> waiting = 0;
        // Ends only where several bodies run at a time.
        pool.run(2, [&](std::size_t) {
            ++waiting;
            while (waiting < 2) std::this_thread::yield();
        });
        EXPECT_EQ(waiting, 2);
    });
}

TEST(ThreadPool, SeveralThreadsMayRunLoopsAtATime) {
    ThreadPool pool(3);
    std::vector<std::thread> callers;
    std::vector<std::vector<int>> times(4, std::vector<int>(100, 0));
    const int loops = static_cast<int>(case_count() / 5);
    for (std::vector<int>& row : times) {
        callers.emplace_back([&pool, &row, loops] {
            for (int i = 0; i < loops; ++i) pool.run(row.size(), [&row](std::size_t k) { ++row[k]; });
        });
    }
    for (std::thread& caller : callers) caller.join();
    for (const std::vector<int>& row : times) EXPECT_EQ(row, std::vector<int>(100, loops));
}

TEST(ThreadPool, ComesAndGoesQuickly) {
    for (std::uint64_t i = 0; i < case_count() / 10; ++i) {
        ThreadPool pool(1 + i % 5);
        if (i % 3 != 0) {
            ASSERT_TRUE(each_once(runs(pool, i % 11))) << i;
        }
    }
}

TEST(SerialExecutor, RunsInOrder) {
    SerialExecutor serial;
    std::vector<std::size_t> order;
    serial.run(5, [&](std::size_t i) { order.push_back(i); });
    EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
    EXPECT_EQ(serial.width(), 1U);
}

}  // namespace
}  // namespace filigree
