// A race as a player sees it: frames of pods, observations in float32, and actions made into commands.
#ifndef STEWARD_VIEW_HPP
#define STEWARD_VIEW_HPP

#include "../include/steward_race.hpp"

namespace steward {

/// The unit vector ahead of each pod: its heading, or while that is unset the direction to its next checkpoint.
struct Ahead {
    double x[4], y[4];
};

/// Cosines and sines of the whole degrees 0..360, correctly rounded from radians as bots compute them.
struct WholeDegrees {
    double cosine[361], sine[361];

    WholeDegrees() {
        for (int k = 0; k <= 360; k++) {
            podrace::turnSlowly(radians(k), cosine[k], sine[k]);
        }
    }
};

/// How observations and actions are written.
class View {
public:
    static constexpr int CONTINUOUS = 6, DISCRETE = 4, TURNS = 7, THRUSTS = 5;

    View(bool fullView, bool discreteActions) : full(fullView), discrete(discreteActions) { }

    /// Numbers of one observation.
    int size() const { return 2 * (11 + 3 * (full ? 11 : 9)) + 2; }
    bool isDiscrete() const { return discrete; }

    void ahead(const Race& race, Ahead& out) const {
        const State& state = race.state;
        if (full) {
            podrace::directionsOf(state.heading, out.x, out.y);
        }
        int degrees[4];
        if (!full) {
            toldWholeDegrees(state.heading, degrees);
        }
        for (int pod = 0; pod < 4; pod++) {
            if (state.heading[pod] != state.heading[pod]) {
                double dx = race.map().checkpointX(state.next[pod]) - state.x[pod];
                double dy = race.map().checkpointY(state.next[pod]) - state.y[pod];
                double distance = std::sqrt(dx * dx + dy * dy);
                out.x[pod] = distance == 0 ? 1 : dx / distance;
                out.y[pod] = distance == 0 ? 0 : dy / distance;
            } else if (!full) {
                out.x[pod] = DEGREES.cosine[degrees[pod]];
                out.y[pod] = DEGREES.sine[degrees[pod]];
            }
        }
    }

    /// Writes what a player sees.
    void observe(const Race& race, const Ahead& ahead, int seat, float* out) const {
        const State& state = race.state;
        const Map& map = race.map();
        const double share = 1.0 / race.toFinish();
        double nextX[4], nextY[4];
        for (int pod = 0; pod < 4; pod++) {
            nextX[pod] = map.checkpointX(state.next[pod]) - state.x[pod];
            nextY[pod] = map.checkpointY(state.next[pod]) - state.y[pod];
        }
        for (int k = 0; k < 2; k++) {
            const int me = 2 * seat + k, others[] = {me ^ 1, 2 - 2 * seat, 3 - 2 * seat};
            alignas(32) double x[16], y[16], forward[16], right[16];
            const int after = state.next[me] + 1 < map.checkpoints() ? state.next[me] + 1 : 0;
            x[0] = state.vx[me];
            y[0] = state.vy[me];
            const double far[2] = {
                unit(nextX[me], nextY[me], x[1], y[1]),
                unit(map.checkpointX(after) - state.x[me], map.checkpointY(after) - state.y[me], x[2], y[2])};
            for (int j = 0; j < 3; j++) {
                const int other = others[j], at = 3 + 4 * j;
                x[at] = state.x[other] - state.x[me];
                y[at] = state.y[other] - state.y[me];
                x[at + 1] = state.vx[other] - state.vx[me];
                y[at + 1] = state.vy[other] - state.vy[me];
                x[at + 2] = ahead.x[other];
                y[at + 2] = ahead.y[other];
                x[at + 3] = nextX[other];
                y[at + 3] = nextY[other];
            }
            x[15] = y[15] = 0;
            const double c = ahead.x[me], s = ahead.y[me];
            for (int v = 0; v < 16; v++) {
                forward[v] = (c * x[v] + s * y[v]) * SCALES[v];
                right[v] = (c * y[v] - s * x[v]) * SCALES[v];
            }
            for (int v = 0; v < 3; v++) {
                *out++ = static_cast<float>(forward[v]);
                *out++ = static_cast<float>(right[v]);
                if (v > 0) {
                    *out++ = static_cast<float>(far[v - 1] * PLACE);
                }
            }
            *out++ = static_cast<float>(state.passed[me] * share);
            *out++ = static_cast<float>(state.timer(me) * 0.25);
            *out++ = state.boostLeft(me);
            for (int j = 0; j < 3; j++) {
                for (int v = 3 + 4 * j; v < 7 + 4 * j; v++) {
                    *out++ = static_cast<float>(forward[v]);
                    *out++ = static_cast<float>(right[v]);
                }
                *out++ = static_cast<float>(state.passed[others[j]] * share);
                if (full) {
                    *out++ = static_cast<float>(state.timer(others[j]) * 0.25);
                    *out++ = state.boostLeft(others[j]);
                }
            }
        }
        *out++ = static_cast<float>(race.turn / 500.0);
        *out++ = static_cast<float>(state.left[seat] / 100.0);
    }

    /// Commands of a player's pods by an action of numbers.
    void order(const Race& race, const Ahead& ahead, int seat, const float* action, Commands& commands) const {
        for (int k = 0; k < 2; k++, action += CONTINUOUS / 2) {
            double turn = clipped(action[0]), thrust = clipped(action[1]);
            int power = action[2] > 0.5f ? static_cast<int>(SHIELD) : action[2] < -0.5f ? static_cast<int>(BOOST)
                : static_cast<int>((thrust + 1) * 100 + 0.5);
            aim(race, ahead, 2 * seat + k, turn * 18, power, commands);
        }
    }

    /// Commands of a player's pods by an action of choices.
    void order(const Race& race, const Ahead& ahead, int seat, const std::int64_t* action, Commands& commands) const {
        static constexpr int POWERS[THRUSTS] = {0, 100, 200, SHIELD, BOOST};
        for (int k = 0; k < 2; k++, action += DISCRETE / 2) {
            aim(race, ahead, 2 * seat + k, 6.0 * static_cast<double>(action[0] - 3), POWERS[action[1]], commands);
        }
    }

private:
    static constexpr double PLACE = 1e-4, SPEED = 1e-3, FAR = 10000;
    static constexpr double SCALES[16] = {SPEED, 1, 1, PLACE, SPEED, 1, PLACE, PLACE, SPEED, 1, PLACE, PLACE,
        SPEED, 1, PLACE, 0};
    static const WholeDegrees DEGREES;
    bool full, discrete;

    /// The direction of a way, (0, 0) of none. Returns its length.
    static double unit(double dx, double dy, double& x, double& y) {
        double length = std::sqrt(dx * dx + dy * dy), divisor = length == 0 ? 1 : length;
        x = dx / divisor;
        y = dy / divisor;
        return length;
    }

    static double clipped(float value) { return value < -1 ? -1 : value > 1 ? 1 : static_cast<double>(value); }

    /// A target 10,000 u away, in whole units. Both series are cut where an angle of 18 degrees leaves 1e-18.
    static void aim(const Race& race, const Ahead& ahead, int pod, double degrees, int power, Commands& commands) {
        double a = radians(std::fabs(degrees)), z = a * a;
        a = degrees < 0 ? -a : a;
        double sine = a * (1 + z * (-1.0 / 6 + z * (1.0 / 120 + z * (-1.0 / 5040 + z * (1.0 / 362880
            + z * (-1.0 / 39916800 + z * (1.0 / 6227020800)))))));
        double cosine = 1 + z * (-1.0 / 2 + z * (1.0 / 24 + z * (-1.0 / 720 + z * (1.0 / 40320
            + z * (-1.0 / 3628800 + z * (1.0 / 479001600))))));
        double c = ahead.x[pod], s = ahead.y[pod];
        commands.target(pod, nearestWhole(race.state.x[pod] + FAR * (c * cosine - s * sine)),
            nearestWhole(race.state.y[pod] + FAR * (s * cosine + c * sine)), power);
    }
};

} // namespace steward
#endif
