// steward_race.hpp - a whole pod race around the turn of steward_podrace.hpp: the map that a seed draws, turns left,
// elimination, the end, ranks, and the bundled bot 'racer'. Seeds, states, hashes, ends and ranks are those of
// Steward's engine for the scene 'mad-pod-racing' by its live rules or those of the contest.
#ifndef STEWARD_RACE_HPP
#define STEWARD_RACE_HPP

#include <algorithm>
#include <array>
#include <limits>

#include "steward_podrace.hpp"

namespace steward {

constexpr int LAPS = 3, TURNS_WITHOUT_CHECKPOINT = 100, MOST_TURNS = 500, MOST_CHECKPOINTS = 16, JITTER = 30;
/// The turn of elimination of a player who is in.
constexpr int IN_RACE = std::numeric_limits<std::int32_t>::max();

/// SplitMix64 (Steele, Lea, Flood 2014) as the engine draws from it.
struct Random {
    std::uint64_t state;

    std::uint64_t next() {
        std::uint64_t z = state += 0x9E3779B97F4A7C15u;
        z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
        z = (z ^ z >> 27) * 0x94D049BB133111EBu;
        return z ^ z >> 31;
    }

    /// Uniform in 0..bound-1.
    int below(int bound) {
        const std::uint64_t most = ~0ull >> 1, limit = most - most % static_cast<std::uint64_t>(bound);
        std::uint64_t drawn = next() >> 1;
        while (drawn >= limit) {
            drawn = next() >> 1;
        }
        return static_cast<int>(drawn % static_cast<std::uint64_t>(bound));
    }

    /// Uniform multiple of 2^-53 in [0, 1).
    double fraction() { return static_cast<double>(next() >> 11) * 0x1p-53; }
};

/// Checkpoints of one race.
struct Course {
    int count = 0;
    double x[MOST_CHECKPOINTS] = {}, y[MOST_CHECKPOINTS] = {};
};

/// The maps of which a seed draws one. The official ones are shifted and jittered, others stay as they are.
class Courses {
public:
    /// The 13 maps of the official race.
    Courses() : official(true) {
        static constexpr int PLACES[13][12] = {
            {12460, 1350, 10540, 5980, 3580, 5180, 13580, 7600},
            {3600, 5280, 13840, 5080, 10680, 2280, 8700, 7460, 7200, 2160},
            {4560, 2180, 7350, 4940, 3320, 7230, 14580, 7700, 10560, 5060, 13100, 2320},
            {5010, 5260, 11480, 6080, 9100, 1840},
            {14660, 1410, 3450, 7220, 9420, 7240, 5970, 4240},
            {3640, 4420, 8000, 7900, 13300, 5540, 9560, 1400},
            {4100, 7420, 13500, 2340, 12940, 7220, 5640, 2580},
            {14520, 7780, 6320, 4290, 7800, 860, 7660, 5970, 3140, 7540, 9520, 4380},
            {10040, 5970, 13920, 1940, 8020, 3260, 2670, 7020},
            {7500, 6940, 6000, 5360, 11300, 2820},
            {4060, 4660, 13040, 1900, 6560, 7840, 7480, 1360, 12700, 7100},
            {3020, 5190, 6280, 7760, 14100, 7760, 13880, 1220, 10240, 4920, 6100, 2200},
            {10323, 3366, 11203, 5425, 7259, 6656, 5425, 2838}};
        for (const auto& row : PLACES) {
            Course course;
            for (; course.count < 6 && row[2 * course.count] != 0; course.count++) {
                course.x[course.count] = row[2 * course.count];
                course.y[course.count] = row[2 * course.count + 1];
            }
            courses.push_back(course);
        }
    }

    explicit Courses(std::vector<Course> own) : courses(std::move(own)), official(false) { }

    /// Draws the map, and of the official ones the first checkpoint, then for each checkpoint x, then y.
    Course draw(std::uint64_t seed) const {
        Random random{seed};
        const Course& map = courses[static_cast<std::size_t>(random.below(static_cast<int>(courses.size())))];
        if (!official) {
            return map;
        }
        Course drawn;
        drawn.count = map.count;
        for (int k = 0, first = random.below(map.count); k < map.count; k++) {
            drawn.x[k] = map.x[(first + k) % map.count] + random.below(2 * JITTER + 1) - JITTER;
            drawn.y[k] = map.y[(first + k) % map.count] + random.below(2 * JITTER + 1) - JITTER;
        }
        return drawn;
    }

private:
    std::vector<Course> courses;
    bool official;
};

enum class Ending : std::int32_t { none, finished, othersOut, allOut, mostTurns };

/// One race between two players of two pods.
class Race {
public:
    State state = {};
    std::int32_t turn = 0, outTurn[2] = {IN_RACE, IN_RACE};
    Ending ending = Ending::none;

    explicit Race(const Map& any, Rules rules) : checkpoints(any), fewestLeft(rules == Rules::live ? 0 : 1) { }

    const Map& map() const { return checkpoints; }
    int toFinish() const { return LAPS * checkpoints.checkpoints(); }
    bool isOver() const { return ending != Ending::none; }
    bool isIn(int player) const { return outTurn[player] == IN_RACE; }

    /// Takes the pods to the start of a course.
    void start(const Course& course) {
        place(course);
        state = checkpoints.start();
        turn = 0;
        outTurn[0] = outTurn[1] = IN_RACE;
        ending = Ending::none;
    }

    /// Changes the checkpoints and nothing else.
    void place(const Course& course) { checkpoints.place(course.x, course.y, course.count); }

    /// Puts a player out as of the next turn, because his answer was faulty. Commands given to his pods still act.
    void eliminate(int player) {
        if (isIn(player)) {
            outTurn[player] = turn + 1;
        }
    }

    /// Plays a turn of a race that is not over. Returns false if it had too many impacts to be the referee's.
    bool play(const Commands& commands) {
        turn++;
        const State before = state;
        bool whole = checkpoints.play(state, commands);
        for (int player = 0; player < 2; player++) {           // the pods of one who is out pass nothing
            if (!isIn(player)) {
                state.left[player] = before.left[player];
                for (int pod = 2 * player; pod < 2 * player + 2; pod++) {
                    state.passed[pod] = before.passed[pod];
                    state.next[pod] = before.next[pod];
                }
            }
        }
        decide();
        return whole;
    }

    /// The pod of a player that has passed more checkpoints, then the one nearer to the next.
    int bestPod(int player) const { return isBetter(2 * player + 1, 2 * player) ? 2 * player + 1 : 2 * player; }

    /// How many are ahead of a player, 0 or 1. Players who are out share the last rank.
    int rank(int player) const {
        int other = 1 - player;
        if (isIn(player) && isIn(other)) {
            return isBetter(bestPod(other), bestPod(player)) ? 1 : 0;
        }
        return !isIn(player) && isIn(other) ? 1 : 0;
    }

    /// The hash of the state, as it stands in a replay.
    std::uint64_t hash() const { return checkpoints.hash(state, turn, outTurn[0], outTurn[1]); }

private:
    Map checkpoints;
    int fewestLeft;

    bool isBetter(int pod, int other) const {
        return state.passed[pod] != state.passed[other] ? state.passed[pod] > state.passed[other]
            : checkpoints.toNext(state, pod) < checkpoints.toNext(state, other);
    }

    bool hasFinished(int player) const {
        return isIn(player) && std::max(state.passed[2 * player], state.passed[2 * player + 1]) >= toFinish();
    }

    void decide() {
        int in = 0, finished = 0;
        for (int player = 0; player < 2; player++) {
            bool done = hasFinished(player);
            finished += done;
            if (isIn(player) && state.left[player] < fewestLeft && !done) {
                outTurn[player] = turn;
            }
            in += isIn(player);
        }
        ending = finished > 0 ? Ending::finished : in == 1 ? Ending::othersOut : in == 0 ? Ending::allOut
            : turn >= MOST_TURNS ? Ending::mostTurns : Ending::none;
    }
};

/* ---- Headings as bots are told them, and sines as the JDK's StrictMath computes them. ---- */

/// Degrees in [0, 360), as in a bot's frame; NaN while unset.
inline double toldDegrees(double heading) {
    double degrees = heading * 180 / podrace::PI;
    if (std::fabs(degrees) >= 360) {
        degrees = std::fmod(degrees, 360);
    }
    degrees = degrees < 0 ? degrees + 360 : degrees;
    return degrees >= 360 ? 0 : degrees;
}

/// Whole degrees 0..360 of four headings, as in a line of the site; 0 while unset. Without a branch that depends on them, but for full turns.
inline void toldWholeDegrees(const double* headings, int* whole) {
    double degrees[4];
    bool turned = false;
    for (int pod = 0; pod < 4; pod++) {
        degrees[pod] = headings[pod] * 180 / podrace::PI;
        turned |= std::fabs(degrees[pod]) >= 360;
    }
    for (int pod = 0; turned && pod < 4; pod++) {
        degrees[pod] = std::fabs(degrees[pod]) >= 360 ? std::fmod(degrees[pod], 360) : degrees[pod];
    }
    for (int pod = 0; pod < 4; pod++) {
        double told = degrees[pod] + (degrees[pod] < 0 ? 360 : 0);
        told = told < 360 ? told : 0;                                  // of NaN too
        int down = static_cast<int>(told);
        whole[pod] = down + (told - down >= 0.5 ? 1 : 0);
    }
}

/// The nearest whole number, halves upward, of one that is less than 2^31 in size.
inline double nearestWhole(double value) {
    return std::floor(value + 0.5);
}

/// Both of radians in [0, 2 pi]: fdlibm's reduction, polynomials and order of operations, as StrictMath has them.
inline void strictTurn(double angle, double& cosine, double& sine) {
    constexpr double FIRST = 0x1.921fb544p0, FIRST_TAIL = 0x1.0b4611a626331p-34, SECOND = 0x1.0b4611a6p-34;
    constexpr double SECOND_TAIL = 0x1.3198a2e037073p-69, THIRD = 0x1.3198a2ep-69, THIRD_TAIL = 0x1.b839a252049c1p-104;
    auto highWord = [](double value) { return static_cast<std::int32_t>(podrace::bits(value) >> 32 & 0x7fffffff); };
    double reduced = angle, tail = 0;
    int quarter = 0, top = highWord(angle);
    if (top > 0x3fe921fb && top < 0x4002d97c) {                        // below 3 pi / 4
        quarter = 1;
        double z = angle - FIRST, low = FIRST_TAIL;
        if (top == 0x3ff921fb) {
            z -= SECOND;
            low = SECOND_TAIL;
        }
        reduced = z - low;
        tail = (z - reduced) - low;
    } else if (top > 0x3fe921fb) {
        quarter = static_cast<int>(angle * 0x1.45f306dc9c883p-1 + 0.5);
        double n = quarter, r = angle - n * FIRST, w = n * FIRST_TAIL;
        reduced = r - w;
        if (top == highWord(n * (podrace::PI / 2)) && (top >> 20) - (highWord(reduced) >> 20) > 16) {
            double t = r;
            w = n * SECOND;
            r = t - w;
            w = n * SECOND_TAIL - ((t - r) - w);
            reduced = r - w;
            if ((top >> 20) - (highWord(reduced) >> 20) > 49) {
                t = r;
                w = n * THIRD;
                r = t - w;
                w = n * THIRD_TAIL - ((t - r) - w);
                reduced = r - w;
            }
        }
        tail = (r - reduced) - w;
    }
    double x = reduced, y = tail, z = x * x, v = z * x;
    double c = 1, s = x;
    if (highWord(x) >= 0x3e400000) {
        double r = 0x1.111111110f8a6p-7 + z * (-0x1.a01a019c161d5p-13 + z * (0x1.71de357b1fe7dp-19
            + z * (-0x1.ae5e68a2b9cebp-26 + z * 0x1.5d93a5acfd57cp-33)));
        s = top <= 0x3fe921fb ? x + v * (-0x1.5555555555549p-3 + z * r)
            : x - ((z * (0.5 * y - v * r) - y) - v * -0x1.5555555555549p-3);
        double q = z * (0x1.555555555554cp-5 + z * (-0x1.6c16c16c15177p-10 + z * (0x1.a01a019cb159p-16
            + z * (-0x1.27e4f809c52adp-22 + z * (0x1.1ee9ebdb4b1c4p-29 + z * -0x1.8fae9be8838d4p-37)))));
        int size = highWord(x);
        if (size < 0x3fd33333) {
            c = 1 - (0.5 * z - (z * q - x * y));
        } else {
            double part = size > 0x3fe90000 ? 0.28125
                : podrace::number(static_cast<std::uint64_t>(size - 0x00200000) << 32);
            double half = 0.5 * z - part;
            c = (1 - part) - (half - (z * q - x * y));
        }
    }
    cosine = (quarter & 3) == 0 ? c : (quarter & 3) == 1 ? -s : (quarter & 3) == 2 ? -c : s;
    sine = (quarter & 3) == 0 ? s : (quarter & 3) == 1 ? c : (quarter & 3) == 2 ? -s : -c;
}

/* ---- The bundled bot 'racer': straight at the next checkpoint, slower the more it turns and the nearer it is. ---- */

/// Thrust of racer for a pod, from the cosine and sine of its heading, both 0 while unset; not yet cut to a whole one.
inline double racerThrust(double dx, double dy, double distance, double cosine, double sine) {
    bool straight = (cosine == 0 && sine == 0) || distance == 0;
    double ahead = straight ? 1 : (cosine * dx + sine * dy) / distance;
    double near = distance / 1200;
    double share = (near < 1 ? near : 1) * (ahead > 0 ? ahead : 0);
    return 200 * (share > 0.1 ? share : 0.1);
}

/// The commands of racer for both pods of a player. The usual sines decide nearly every thrust; where they leave a
/// whole number in doubt, those that the bot itself computes do.
inline void racer(const Race& race, int player, Commands& commands) {
    const State& state = race.state;
    double cosines[4], sines[4];
    podrace::directionsOf(state.heading, cosines, sines);
    for (int pod = 2 * player; pod < 2 * player + 2; pod++) {
        double x = race.map().checkpointX(state.next[pod]), y = race.map().checkpointY(state.next[pod]);
        double dx = x - state.x[pod], dy = y - state.y[pod], distance = std::sqrt(dx * dx + dy * dy);
        bool set = state.heading[pod] == state.heading[pod];
        double thrust = racerThrust(dx, dy, distance, set ? cosines[pod] : 0, set ? sines[pod] : 0);
        if (set && std::fabs(thrust - nearestWhole(thrust)) < 1e-6) {
            strictTurn(toldDegrees(state.heading[pod]) * 0.017453292519943295, cosines[pod], sines[pod]);
            thrust = racerThrust(dx, dy, distance, cosines[pod], sines[pod]);
        }
        commands.target(pod, nearestWhole(x), nearestWhole(y), static_cast<int>(thrust));
    }
}

} // namespace steward
#endif
