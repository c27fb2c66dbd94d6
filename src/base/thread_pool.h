// An executor over a fixed number of threads. The only file that starts threads.
//
// Several threads may run loops on one pool: the loops take turns. A loop of tiny bodies costs some ten
// nanoseconds a body, and the start of a loop some microseconds; what is shorter runs faster in place.
#pragma once

#include <memory>

#include "base/executor.h"

namespace filigree {

class ThreadPool final : public Executor {
public:
    // `threads` counts the caller, which works too; 1 starts none. At least 1, and no more than 1024 or than the
    // system gives: `width` tells.
    explicit ThreadPool(std::size_t threads);
    ~ThreadPool() override;
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    void run(std::size_t count, const std::function<void(std::size_t)>& body) override;
    std::size_t width() const override;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace filigree
