// Measures steward_podrace.hpp. The input: n, n times x y of the map; games, turns; per game, turn and pod x y thrust,
// y NaN: by x degrees; all of them 64-bit words, least byte first. The games are played from the start, as often as the
// first argument says. Prints the least and the median time of a turn in ns, and the sum of all places in the end.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include "steward_podrace.hpp"

static std::uint64_t word() {
    std::uint64_t value = 0;
    for (int k = 0; k < 8; k++) {
        value |= static_cast<std::uint64_t>(std::getchar() & 255) << 8 * k;
    }
    return value;
}

static double real() { return steward::podrace::number(word()); }

int main(int, char** arguments) {
    std::vector<std::pair<double, double>> places(word());
    for (auto& place : places) {
        place.first = real();
        place.second = real();
    }
    const steward::Map map(places);
    std::size_t games = word(), turns = word();
    std::vector<steward::Commands> commands(games * turns);
    for (auto& each : commands) {
        for (int pod = 0; pod < 4; pod++) {
            double x = real(), y = real();
            int thrust = static_cast<int>(word());
            if (y == y) {
                each.target(pod, x, y, thrust);
            } else {
                each.turn(pod, x, thrust);
            }
        }
    }
    const steward::State start = map.start();
    std::vector<double> times;
    double sum = 0;
    for (int run = std::atoi(arguments[1]); run > 0; run--) {
        sum = 0;
        auto begin = std::chrono::steady_clock::now();
        for (std::size_t game = 0; game < games; game++) {
            steward::State state = start;
            for (std::size_t turn = 0; turn < turns; turn++) {
                map.play(state, commands[game * turns + turn]);
            }
            for (int pod = 0; pod < 4; pod++) {
                sum += state.x[pod] + state.y[pod];
            }
        }
        std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - begin;
        times.push_back(taken.count() / static_cast<double>(games * turns));
    }
    std::sort(times.begin(), times.end());
    std::printf("%.1f %.1f %.0f\n", times[0], times[times.size() / 2], sum);
}
