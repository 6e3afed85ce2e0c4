// A bot for the pod race that searches with the official turn: copy it and make it better.
//
// Each turn it varies a plan of commands for its two pods by chance, plays the plan with steward_podrace.hpp, and keeps
// it if it is worth more, until its time is over. The pod that is ahead races; the other one gets into the way of the
// best pod of the other player. For CodinGame put the header's text in place of its #include.
#pragma GCC optimize("O3")
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <random>
#include "steward_podrace.hpp"

const int DEPTH = 7;                        // turns of a plan
const int FULL_THRUST = 200;
const double FULL_TURN = 18;                // degrees
const double ANSWER_MS = 20;                // of the 75 that a bot has
const double CHECKPOINT_WORTH = 20000;      // more than any distance between two checkpoints
const double BLOCK_WORTH = 0.35;            // of a unit nearer to the other player's best pod
const double PI = std::acos(-1.0);

using Clock = std::chrono::steady_clock;
typedef steward::Commands Plan[DEPTH];      // pods 0 and 1 are ours

struct Bot {
    steward::Map map;
    steward::State now;
    int turn = 0;
    int racer = 0, rival = 2;               // the best pods of both players
    Plan best;
    std::minstd_rand random{1};

    explicit Bot(const std::vector<std::pair<double, double>>& places) : map(places), now(map.start()) { }

    double chance() { return random() / static_cast<double>(std::minstd_rand::max()); }

    double progress(const steward::State& state, int pod) const {
        return CHECKPOINT_WORTH * state.passed[pod] - map.toNext(state, pod);
    }

    // What the referee says. Our own headings, timers and boosts are those that our last turn led to.
    bool look() {
        for (int pod = 0; pod < 4; pod++) {
            double x, y, vx, vy;
            int angle, next;
            if (!(std::cin >> x >> y >> vx >> vy >> angle >> next)) {
                return false;
            }
            int count = map.checkpoints(), more = (next - now.next[pod] + count) % count;
            int passed = now.passed[pod] + (2 * more <= count ? more : more - count);    // against what we foresaw
            bool ours = pod < 2 && turn > 0;
            map.set(now, pod, x, y, vx, vy, ours ? now.heading[pod] : steward::radians(angle),
                ours ? now.timer(pod) : 0, now.boostLeft(pod), std::max(0, passed));
        }
        racer = progress(now, 0) >= progress(now, 1) ? 0 : 1;
        rival = progress(now, 2) >= progress(now, 3) ? 2 : 3;
        return true;
    }

    // Towards a place, less some turns of the pod's drift.
    void drive(steward::Commands& commands, const steward::State& state, int pod, double x, double y) const {
        double dx = x - 3 * state.vx[pod] - state.x[pod], dy = y - 3 * state.vy[pod] - state.y[pod];
        double off = std::remainder(std::atan2(dy, dx) - state.heading[pod], 2 * PI) * 180 / PI;
        commands.turn(pod, off, std::abs(off) > 70 ? 0 : FULL_THRUST);
    }

    void driveToNext(steward::Commands& commands, const steward::State& state, int pod) const {
        drive(commands, state, pod, map.checkpointX(state.next[pod]), map.checkpointY(state.next[pod]));
    }

    // The plan of the last turn, one turn on; the other player's pods as we think that they drive.
    void begin() {
        steward::State state = now;
        for (int ahead = 0; ahead < DEPTH; ahead++) {
            if (ahead + 1 < DEPTH && turn > 1) {
                best[ahead] = best[ahead + 1];
            } else {
                driveToNext(best[ahead], state, racer);
                drive(best[ahead], state, 1 - racer, state.x[rival], state.y[rival]);
            }
            driveToNext(best[ahead], state, 2);
            driveToNext(best[ahead], state, 3);
            map.play(state, best[ahead]);
        }
    }

    void vary(steward::Commands& commands, int pod) {
        double side = 2 * chance() - 1, power = 1.5 * chance() - 0.25;
        double degrees = std::abs(side) < 0.2 ? 0 : 2 * FULL_TURN * side;     // often as far as possible
        int thrust = static_cast<int>(FULL_THRUST * std::min(1.0, std::max(0.0, power)));
        commands.turn(pod, degrees, chance() < 0.05 ? static_cast<int>(steward::SHIELD) : thrust);
    }

    double worth(const Plan& plan) const {
        steward::State state = now;
        for (const steward::Commands& commands : plan) {
            map.play(state, commands);
        }
        int block = 1 - racer;
        int ahead = state.next[rival];
        double dx = (state.x[rival] + map.checkpointX(ahead)) / 2 - state.x[block];
        double dy = (state.y[rival] + map.checkpointY(ahead)) / 2 - state.y[block];
        return progress(state, racer) - progress(state, rival) - BLOCK_WORTH * std::sqrt(dx * dx + dy * dy);
    }

    void search(Clock::time_point end) {
        double most = worth(best);
        Plan trial;
        for (int count = 0; count % 16 != 0 || Clock::now() < end; count++) {
            std::copy(best, best + DEPTH, trial);
            for (int changes = 1 + static_cast<int>(3 * chance()); changes > 0; changes--) {
                vary(trial[static_cast<int>(DEPTH * chance()) % DEPTH], chance() < 0.5 ? 0 : 1);
            }
            double found = worth(trial);
            if (found >= most) {
                most = found;
                std::copy(trial, trial + DEPTH, best);
            }
        }
    }

    // Says a command as a place to steer at, and plays what was said, so that all digits of our headings are known.
    void answer(steward::Commands commands) {
        for (int pod = 0; pod < 2; pod++) {
            double x = map.checkpointX(now.next[pod]), y = map.checkpointY(now.next[pod]);
            int thrust = turn == 0 ? static_cast<int>(pod == 0 ? steward::BOOST : FULL_THRUST) : commands.thrust[pod];
            if (turn > 0) {                                  // a turn of 18 degrees is one to a place at 90
                double radians = commands.x[pod];
                double angle = now.heading[pod] + (std::abs(radians) > 0.31415 ? 5 * radians : radians);
                x = std::round(now.x[pod] + 100000 * std::cos(angle));
                y = std::round(now.y[pod] + 100000 * std::sin(angle));
            }
            commands.target(pod, x, y, thrust);
            std::cout << static_cast<int>(x) << ' ' << static_cast<int>(y) << ' '
                << (thrust == steward::SHIELD ? "SHIELD" : thrust == steward::BOOST ? "BOOST" : std::to_string(thrust))
                << '\n';
        }
        std::cout << std::flush;
        map.play(now, commands);
        turn++;
    }
};

int main() {
    int laps = 0, count = 0;
    std::cin >> laps >> count;
    std::vector<std::pair<double, double>> places(count);
    for (auto& place : places) {
        std::cin >> place.first >> place.second;
    }
    if (!std::cin) {
        return 0;                                            // there is no match
    }
    Bot bot(places);
    while (bot.look()) {
        Clock::time_point end = Clock::now() + std::chrono::microseconds(static_cast<int>(1000 * ANSWER_MS));
        if (bot.turn > 0) {
            bot.begin();
            bot.search(end);
        }
        bot.answer(bot.best[0]);
    }
}
