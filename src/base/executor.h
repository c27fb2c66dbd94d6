// Deterministic parallel loops over an executor that the caller passes in.
//
// Guarantee: body(i) is called exactly once for every i in [0, count), in any order and on any thread. A
// loop whose body writes only slot i from item i gives the same result for every executor. Bodies must not
// throw. A loop started from within a body runs in place, on the thread that started it; only a loop of one
// item leaves the threads to the loops inside it.
#pragma once

#include <cstddef>
#include <functional>

namespace filigree {

class Executor {
public:
    virtual ~Executor() = default;
    virtual void run(std::size_t count, const std::function<void(std::size_t)>& body) = 0;
    virtual std::size_t width() const = 0;  // how many bodies may run at a time, at least 1
};

// Runs bodies one after another, in order.
class SerialExecutor final : public Executor {
public:
    void run(std::size_t count, const std::function<void(std::size_t)>& body) override {
        for (std::size_t i = 0; i < count; ++i) body(i);
    }
    std::size_t width() const override { return 1; }
};

}  // namespace filigree
