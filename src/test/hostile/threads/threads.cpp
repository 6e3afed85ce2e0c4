// Answers each number by what threads compute; a timer's signal arrives all the time.
#include <csignal>
#include <future>
#include <iostream>
#include <sys/time.h>
#include <vector>

static volatile std::sig_atomic_t ticks;

static long work(long value) {
    for (int k = 0; k < 100000; k++) value = (value * 1103515245 + 12345) % (1L << 31);
    return value;
}

int main() {
    std::signal(SIGALRM, [](int) { ticks = ticks + 1; });
    itimerval every{{0, 3000}, {0, 3000}};
    setitimer(ITIMER_REAL, &every, nullptr);
    for (long seed; std::cin >> seed;) {
        std::vector<std::future<long>> found;
        for (int k = 0; k < 4; k++) found.push_back(std::async(std::launch::async, work, seed + k));
        long sum = 0;
        for (auto &each : found) sum += each.get();
        std::cout << sum << std::endl;
    }
}
