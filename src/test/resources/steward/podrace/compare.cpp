// Plays the turns that the standard input gives by steward_podrace.hpp and counts the numbers that differ from those
// expected, bit by bit. The input is a sequence of records of 64-bit words, least byte first; doubles by their bits:
//   1, rules (1: contest), n, n times x y                                          a map
//   2, 4 times (x y vx vy heading timer boost passed), 2 turns left                a state
//   3, 4 times (x y thrust), y NaN: by x degrees; 4 times (x y vx vy heading timer boost passed next); 2 turns left
//      (-1000: not compared); the turn's number and the hash (number -1: not compared)
#include <cstdio>
#include <cstdlib>
#include "steward_podrace.hpp"

static std::uint64_t word() {
    unsigned char bytes[8];
    if (std::fread(bytes, 1, 8, stdin) != 8) {
        std::exit(3);
    }
    std::uint64_t value = 0;
    for (int k = 7; k >= 0; k--) {
        value = value << 8 | bytes[k];
    }
    return value;
}

static double real() { return steward::podrace::number(word()); }
static int whole() { return static_cast<int>(static_cast<std::int64_t>(word())); }
static bool isNan(std::uint64_t bits) { return (bits & ~0ull >> 1) > 0x7ff0000000000000u; }

static long turns, values, different;

static void compare(const char* what, int pod, std::uint64_t expected, std::uint64_t found) {
    values++;
    if (expected != found && !(isNan(expected) && isNan(found)) && different++ < 5) {
        std::printf("turn %ld, %s of pod %d: expected %016llx, found %016llx\n", turns, what, pod,
            static_cast<unsigned long long>(expected), static_cast<unsigned long long>(found));
    }
}

static void compare(const char* what, int pod, int expected, int found) {
    compare(what, pod, static_cast<std::uint64_t>(expected), static_cast<std::uint64_t>(found));
}

int main() {
    steward::Map* map = nullptr;
    steward::State state = {};
    for (int kind; (kind = std::fgetc(stdin)) != EOF;) {
        for (int k = 1; k < 8; k++) {
            std::fgetc(stdin);
        }
        if (kind == 1) {
            delete map;
            steward::Rules rules = whole() == 1 ? steward::Rules::contest : steward::Rules::live;
            std::vector<std::pair<double, double>> places(static_cast<std::size_t>(whole()));
            for (auto& place : places) {
                place.first = real();
                place.second = real();
            }
            map = new steward::Map(places, rules);
            state = map->start();
        } else if (kind == 2) {
            for (int pod = 0; pod < 4; pod++) {
                double x = real(), y = real(), vx = real(), vy = real(), heading = real();
                int timer = whole();
                bool boost = whole() != 0;
                map->set(state, pod, x, y, vx, vy, heading, timer, boost, whole());
            }
            state.left[0] = whole();
            state.left[1] = whole();
        } else {
            steward::Commands commands;
            for (int pod = 0; pod < 4; pod++) {
                double x = real(), y = real();
                int thrust = whole();
                if (isNan(steward::podrace::bits(y))) {
                    commands.turn(pod, x, thrust);
                } else {
                    commands.target(pod, x, y, thrust);
                }
            }
            steward::State trial = state;
            long before = different;
            if (!map->play(trial, commands)) {
                std::printf("turn %ld was not played to its end\n", turns);
            }
            std::swap(state, trial);
            turns++;
            for (int pod = 0; pod < 4; pod++) {
                compare("x", pod, word(), steward::podrace::bits(state.x[pod]));
                compare("y", pod, word(), steward::podrace::bits(state.y[pod]));
                compare("vx", pod, word(), steward::podrace::bits(state.vx[pod]));
                compare("vy", pod, word(), steward::podrace::bits(state.vy[pod]));
                compare("heading", pod, word(), steward::podrace::bits(state.heading[pod]));
                compare("timer", pod, whole(), state.timer(pod));
                compare("boost", pod, whole(), state.boostLeft(pod));
                compare("passed", pod, whole(), state.passed[pod]);
                compare("next", pod, whole(), state.next[pod]);
            }
            for (int player = 0; player < 2; player++) {
                int left = whole();
                compare("turns left", 2 * player, left, left == -1000 ? left : state.left[player]);
            }
            int number = whole();
            std::uint64_t hash = word();
            compare("hash", 0, hash, number < 0 ? hash : map->hash(state, number));
            for (int pod = 0; before == 0 && different > 0 && pod < 4; pod++) {
                std::printf("from %a %a %a %a heading %a flags %d, command %a %a %d\n", trial.x[pod], trial.y[pod],
                    trial.vx[pod], trial.vy[pod], trial.heading[pod], trial.flags[pod], commands.x[pod],
                    commands.y[pod], commands.thrust[pod]);
            }
        }
    }
    std::printf("%ld turns, %ld values, %ld different\n", turns, values, different);
    return different == 0 ? 0 : 1;
}
