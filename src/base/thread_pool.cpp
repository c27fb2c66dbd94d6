#include "base/thread_pool.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace filigree {

namespace {

constexpr std::size_t most_threads = 1024;

// True on a thread while it runs a body: loops that the body starts then run in place.
thread_local bool is_inside_body = false;

// One loop, shared by the threads that work on it.
class Loop {
public:
    Loop(std::size_t count, std::size_t width, const std::function<void(std::size_t)>& body)
        : count_(count), width_(width), body_(body) {}

    // Takes chunks until none is left. Chunks shrink towards the end of the loop, so that tiny bodies pay for
    // few atomic operations and the threads still finish together.
    void work() noexcept {
        is_inside_body = true;
        std::size_t begin = next_.load(std::memory_order_relaxed);
        while (begin < count_) {
            const std::size_t end = begin + std::max<std::size_t>(1, (count_ - begin) / (4 * width_));
            if (!next_.compare_exchange_weak(begin, end, std::memory_order_relaxed)) continue;
            for (std::size_t i = begin; i < end; ++i) body_(i);
            begin = next_.load(std::memory_order_relaxed);
        }
        is_inside_body = false;
    }

private:
    std::atomic<std::size_t> next_ = 0;
    const std::size_t count_;
    const std::size_t width_;
    const std::function<void(std::size_t)>& body_;
};

}  // namespace

struct ThreadPool::State {
    std::vector<std::thread> workers;
    std::mutex run_mutex;  // held by the one thread whose loop is running

    std::mutex mutex;  // guards what follows
    std::condition_variable work_came;
    std::condition_variable workers_left;
    Loop* loop = nullptr;      // what to work on; null where nothing is left to join
    std::uint64_t number = 0;  // counts loops, so that a worker joins each at most once
    std::size_t busy = 0;      // workers inside `loop`
    bool is_closing = false;

    void worker_main() {
        std::uint64_t last_number = 0;
        std::unique_lock lock(mutex);
        while (true) {
            work_came.wait(lock, [&] { return is_closing || (loop != nullptr && number != last_number); });
            if (is_closing) return;
            last_number = number;
            Loop& joined = *loop;
            ++busy;
            lock.unlock();
            joined.work();
            lock.lock();
            if (--busy == 0) workers_left.notify_one();
        }
    }
};

ThreadPool::ThreadPool(std::size_t threads) : state_(std::make_unique<State>()) {
    const std::size_t workers = std::clamp<std::size_t>(threads, 1, most_threads) - 1;
    state_->workers.reserve(workers);
    try {
        for (std::size_t i = 0; i < workers; ++i)
            state_->workers.emplace_back([state = state_.get()] { state->worker_main(); });
    } catch (const std::system_error&) {
        // The system has no more threads to give: the pool does with those that it got.
    }
}

ThreadPool::~ThreadPool() {
    {
        const std::lock_guard lock(state_->mutex);
        state_->is_closing = true;
    }
    state_->work_came.notify_all();
    for (std::thread& worker : state_->workers) worker.join();
}

void ThreadPool::run(std::size_t count, const std::function<void(std::size_t)>& body) {
    if (count <= 1 || is_inside_body || state_->workers.empty()) {
        for (std::size_t i = 0; i < count; ++i) body(i);
        return;
    }
    const std::lock_guard turn(state_->run_mutex);
    Loop loop(count, width(), body);
    {
        const std::lock_guard lock(state_->mutex);
        state_->loop = &loop;
        ++state_->number;
    }
    if (count > state_->workers.size()) {
        state_->work_came.notify_all();
    } else {
        for (std::size_t i = 1; i < count; ++i) state_->work_came.notify_one();
    }
    loop.work();
    // Workers that wake up late find no loop; those inside still run bodies and must leave first.
    std::unique_lock lock(state_->mutex);
    state_->loop = nullptr;
    state_->workers_left.wait(lock, [&] { return state_->busy == 0; });
}

std::size_t ThreadPool::width() const { return state_->workers.size() + 1; }

}  // namespace filigree
