// The arithmetic that a race needs: rounding to nearest, nothing flushed to zero; and threads that have it too.
#ifndef STEWARD_ARITHMETIC_HPP
#define STEWARD_ARITHMETIC_HPP

#include <atomic>
#include <cfenv>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>
#ifdef _WIN32
#include <process.h>
#else
#include <unistd.h>
#endif
#if defined(__SSE2__) || defined(_M_X64)
#include <immintrin.h>
#define STEWARD_SSE 1
#endif

namespace steward {

/// Sets rounding and the flushing of tiny numbers as the rules need them, and restores both when it ends.
class Arithmetic {
public:
#ifdef STEWARD_SSE
    Arithmetic() : before(_mm_getcsr()) { _mm_setcsr(0x1f80); }
    ~Arithmetic() { _mm_setcsr(before); }

private:
    unsigned before;
#else
    Arithmetic() {
        std::fegetenv(&before);
        std::fesetenv(FE_DFL_ENV);
    }
    ~Arithmetic() { std::fesetenv(&before); }

private:
    std::fenv_t before;
#endif
public:
    Arithmetic(const Arithmetic&) = delete;
    Arithmetic& operator=(const Arithmetic&) = delete;
};

/// Threads that share out a range of races. The caller is one of them, so that one thread starts none. A process that
/// was forked has none of them: there the caller works alone.
class Workers {
public:
    /// Throws std::system_error if the system starts fewer threads.
    explicit Workers(int threads) {
        try {
            for (int k = 1; k < threads; k++) {
                pool.emplace_back([this, k] { serve(k); });
            }
        } catch (...) {
            end();
            throw;
        }
    }

    ~Workers() { end(); }

    /// Deletes workers. In a forked process they are left as they are: nothing there answers their locks.
    struct Delete {
        void operator()(Workers* workers) const {
            if (!workers->isForked()) {
                delete workers;
            }
        }
    };

    /// Calls work(from, to) for a part of 0..count each. Work may not throw.
    template <typename Work> void share(int count, Work&& work) {
        if (pool.empty() || isForked()) {
            work(0, count);
            return;
        }
        task = std::ref(work);
        total = count;
        left.store(static_cast<int>(pool.size()), std::memory_order_relaxed);
        {
            std::lock_guard<std::mutex> lock(mutex);
            round.fetch_add(1, std::memory_order_release);
        }
        if (sleeping.load() > 0) {
            wake.notify_all();
        }
        run(0);
        for (int spins = 0; left.load(std::memory_order_acquire) > 0; spins++) {
            if (spins > SPINS) {
                std::this_thread::yield();
            }
        }
    }

private:
    /// Looks at a counter, about 20 microseconds, before a thread sleeps or yields.
    static constexpr int SPINS = 20000;

    std::vector<std::thread> pool;
    std::mutex mutex;
    std::condition_variable wake;
    std::atomic<unsigned> round{0};
    std::atomic<int> left{0}, sleeping{0};
    std::function<void(int, int)> task;
    int total = 0;
    bool ending = false;
    const int process = current();

    static int current() {
#ifdef _WIN32
        return _getpid();
#else
        return static_cast<int>(getpid());
#endif
    }

    bool isForked() const { return current() != process; }

    void end() {
        {
            std::lock_guard<std::mutex> lock(mutex);
            ending = true;
            round.fetch_add(1, std::memory_order_release);
        }
        wake.notify_all();
        for (std::thread& each : pool) {
            each.join();
        }
    }

    void run(int part) {
        long long parts = static_cast<long long>(pool.size()) + 1;
        task(static_cast<int>(total * part / parts), static_cast<int>(total * (part + 1LL) / parts));
    }

    void serve(int part) {
        Arithmetic exact;
        for (unsigned seen = 0;; seen++) {
            for (int spins = 0; round.load(std::memory_order_acquire) == seen && spins < SPINS; spins++) { }
            if (round.load(std::memory_order_acquire) == seen) {
                std::unique_lock<std::mutex> lock(mutex);
                sleeping++;
                wake.wait(lock, [&] { return round.load(std::memory_order_acquire) != seen; });
                sleeping--;
            }
            if (ending) {
                return;
            }
            run(part);
            left.fetch_sub(1, std::memory_order_release);
        }
    }
};

} // namespace steward
#endif
