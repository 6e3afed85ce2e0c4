// Many races side by side: stepped, observed and begun anew on some threads. Arrays belong to the caller.
#ifndef STEWARD_BATCH_HPP
#define STEWARD_BATCH_HPP

#include "arithmetic.hpp"
#include "view.hpp"

namespace steward {

/// Reward of player 0: the result at the end (1, 0, -1); the progress of his better pod; the change of his lead.
enum class Reward { result, progress, lead };

/// One of the opponents of which each race draws one: its weight summed with those before, and whether it is racer.
struct Member {
    double sum;
    bool isRacer;
};

struct Settings {
    Rules rules = Rules::live;
    Courses courses;
    std::vector<Member> members;
    bool full = false, discrete = false;
    Reward reward = Reward::result;
    bool autoreset = true;                                     ///< a step begins a race anew that is over
};

/// The state of a race and of what is drawn for it, as arrays in Python show it: see states() there.
struct Snapshot {
    double x[4], y[4], vx[4], vy[4], heading[4];
    std::int32_t shieldTimer[4], boostLeft[4], heavy[4], passed[4], turnsLeft[2], outTurn[2];
    std::int32_t turn, ending, opponent, fresh, over, checkpoints;
    std::uint64_t seed, stream;
    double checkpointX[MOST_CHECKPOINTS], checkpointY[MOST_CHECKPOINTS];
};
static_assert(sizeof(Snapshot) == 160 + 80 + 24 + 16 + 256, "the type in Python has no gaps");

/// Where a step writes: observations, rewards, ends; of races that ended, result and turn.
struct Outputs {
    float* observations;
    double* rewards;
    bool* terminated;
    double* results;
    std::int64_t* turns;
};

class Batch {
public:
    mutable std::atomic<bool> isUsed{false};                   ///< a call is at work: see Call

    Batch(int count, int threads, Settings chosen)
        : settings(std::move(chosen)), view(settings.full, settings.discrete), workers(new Workers(threads)) {
        Arithmetic exact;
        Map any({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}, {6, 0}, {7, 0}}, settings.rules);
        races.reserve(static_cast<std::size_t>(count));
        for (int k = 0; k < count; k++) {
            races.emplace_back(any, settings.rules);
        }
    }

    int count() const { return static_cast<int>(races.size()); }
    int observationSize() const { return view.size(); }
    int actionSize() const { return view.isDiscrete() ? View::DISCRETE : View::CONTINUOUS; }
    int firstOver() const { return find([](const Slot& slot) { return slot.over; }); }
    bool isAutomatic() const { return settings.autoreset; }
    bool needsForeign() const {
        return std::any_of(settings.members.begin(), settings.members.end(),
            [](const Member& member) { return !member.isRacer; });
    }
    int opponent(int k) const { return races[static_cast<std::size_t>(k)].member; }

    /// Takes a race's next start from this seed; those after it from numbers that follow from the seed.
    void seed(int k, std::uint64_t value) {
        Slot& slot = races[static_cast<std::size_t>(k)];
        slot.seed = value;
        slot.fresh = true;
        slot.stream = {value ^ 0x5354455741524421u};
    }

    /// Begins the races of a mask anew and writes their observations.
    void reset(const bool* mask, float* observations) {
        Arithmetic exact;
        workers->share(count(), [&](int from, int to) {
            for (int k = from; k < to; k++) {
                if (mask[k]) {
                    begin(races[static_cast<std::size_t>(k)]);
                    observe(k, 0, observations);
                }
            }
        });
    }

    /// Plays one turn of every race by checked actions. Returns how many ended; -1 after too many impacts.
    template <typename Action> int step(const Action* actions, const Action* foreign, const Outputs& out) {
        Arithmetic exact;
        std::atomic<int> ended{0}, broken{0};
        const std::ptrdiff_t width = actionSize();
        workers->share(count(), [&](int from, int to) {
            int ends = 0;
            for (int k = from; k < to; k++) {
                Slot& slot = races[static_cast<std::size_t>(k)];
                if (slot.over) {
                    begin(slot);
                    out.rewards[k] = 0;
                    out.terminated[k] = false;
                    observe(k, 0, out.observations);
                    continue;
                }
                Commands commands;
                view.order(slot.race, slot.ahead, 0, actions + k * width, commands);
                if (settings.members[static_cast<std::size_t>(slot.member)].isRacer) {
                    racer(slot.race, 1, commands);
                } else {
                    view.order(slot.race, slot.ahead, 1, foreign + k * width, commands);
                }
                if (!slot.race.play(commands)) {
                    broken = 1;
                }
                out.rewards[k] = settle(slot);
                out.terminated[k] = slot.over;
                if (slot.over) {
                    ends++;
                    out.results[k] = result(slot.race);
                    out.turns[k] = slot.race.turn;
                }
                observe(k, 0, out.observations);
            }
            ended += ends;
        });
        return broken != 0 ? -1 : ended.load();
    }

    /// Plays given commands, checked before, in races that are not over; faults put players out. True if all was well.
    bool play(const double* commands, const bool* faults) {
        Arithmetic exact;
        std::atomic<int> broken{0};
        workers->share(count(), [&](int from, int to) {
            for (int k = from; k < to; k++) {
                Slot& slot = races[static_cast<std::size_t>(k)];
                if (slot.race.isOver()) {
                    continue;
                }
                Commands given;
                for (int pod = 0; pod < 4; pod++) {
                    const double* each = commands + 12 * static_cast<std::ptrdiff_t>(k) + 3 * pod;
                    given.target(pod, each[0], each[1], static_cast<int>(each[2]));
                }
                for (int player = 0; player < 2; player++) {
                    if (faults[2 * k + player]) {
                        slot.race.eliminate(player);
                    }
                }
                if (!slot.race.play(given)) {
                    broken = 1;
                }
                settle(slot);
            }
        });
        return broken == 0;
    }

    /// Writes what a player sees of every race.
    void observeAll(int seat, float* out) {
        Arithmetic exact;
        workers->share(count(), [&](int from, int to) {
            for (int k = from; k < to; k++) {
                observe(k, seat, out);
            }
        });
    }

    /// Writes x, y and thrust that racer commands, [races][2][3].
    void racerCommands(int seat, double* out) {
        Arithmetic exact;
        for (const Slot& slot : races) {
            Commands commands;
            racer(slot.race, seat, commands);
            write(commands, seat, out);
            out += 6;
        }
    }

    /// Writes the commands that actions stand for, [races][2][3].
    template <typename Action> void orders(int seat, const Action* actions, double* out) {
        Arithmetic exact;
        for (const Slot& slot : races) {
            Commands commands;
            view.order(slot.race, slot.ahead, seat, actions, commands);
            write(commands, seat, out);
            actions += actionSize();
            out += 6;
        }
    }

    void hashes(std::uint64_t* out) const {
        for (const Slot& slot : races) {
            *out++ = slot.race.hash();
        }
    }

    void ranks(std::int32_t* out) const {
        for (const Slot& slot : races) {
            *out++ = slot.race.rank(0);
            *out++ = slot.race.rank(1);
        }
    }

    void save(Snapshot* out) const {
        for (const Slot& slot : races) {
            const State& state = slot.race.state;
            Snapshot& to = *out++;
            to = {};
            for (int pod = 0; pod < 4; pod++) {
                to.x[pod] = state.x[pod];
                to.y[pod] = state.y[pod];
                to.vx[pod] = state.vx[pod];
                to.vy[pod] = state.vy[pod];
                to.heading[pod] = state.heading[pod];
                to.shieldTimer[pod] = state.timer(pod);
                to.boostLeft[pod] = state.boostLeft(pod);
                to.heavy[pod] = (state.flags[pod] & podrace::HEAVY) != 0;
                to.passed[pod] = state.passed[pod];
            }
            for (int player = 0; player < 2; player++) {
                to.turnsLeft[player] = state.left[player];
                to.outTurn[player] = slot.race.outTurn[player];
            }
            to.turn = slot.race.turn;
            to.ending = static_cast<std::int32_t>(slot.race.ending);
            to.opponent = slot.member;
            to.fresh = slot.fresh;
            to.over = slot.over;
            to.seed = slot.seed;
            to.stream = slot.stream.state;
            to.checkpoints = slot.race.map().checkpoints();
            for (int c = 0; c < to.checkpoints; c++) {
                to.checkpointX[c] = slot.race.map().checkpointX(c);
                to.checkpointY[c] = slot.race.map().checkpointY(c);
            }
        }
    }

    /// The field of a snapshot that cannot be, or null.
    const char* wrong(const Snapshot& from) const {
        auto place = [](double value) {
            double size = std::fabs(value);
            return size == 0 || (size >= 0x1p-100 && size <= 0x1p30);
        };
        if (from.checkpoints < 2 || from.checkpoints > MOST_CHECKPOINTS) {
            return "checkpoints: expected 2..16";
        }
        for (int c = 0; c < from.checkpoints; c++) {
            if (!place(from.checkpointX[c]) || !place(from.checkpointY[c])) {
                return "checkpoint_x, checkpoint_y: expected places up to 2^30 in size";
            }
        }
        for (int pod = 0; pod < 4; pod++) {
            if (!place(from.x[pod]) || !place(from.y[pod]) || !place(from.vx[pod]) || !place(from.vy[pod])) {
                return "x, y, vx, vy: expected numbers up to 2^30 in size";
            }
            double heading = std::fabs(from.heading[pod]);
            if (heading > 1e6 || (heading > 0 && heading < 0x1p-300)) {
                return "heading: expected radians, at most 10^6, or NaN";
            }
            if (from.shieldTimer[pod] < 0 || from.shieldTimer[pod] > 4) {
                return "shield_timer: expected 0..4";
            }
            if ((from.boostLeft[pod] | from.heavy[pod]) & ~1) {
                return "boost_left, heavy: expected 0 or 1";
            }
            if (from.passed[pod] < 0 || from.passed[pod] > 1000000) {
                return "passed: expected 0..1000000";
            }
        }
        for (int player = 0; player < 2; player++) {
            if (from.turnsLeft[player] < -1 || from.turnsLeft[player] > TURNS_WITHOUT_CHECKPOINT) {
                return "turns_left: expected -1..100";
            }
            if (from.outTurn[player] < 0) {
                return "out_turn: expected a turn, or 2147483647 for a player who is in";
            }
        }
        if (from.turn < 0 || from.turn > MOST_TURNS || from.ending < 0 || from.ending > 4) {
            return "turn, ending: expected 0..500 and 0..4";
        }
        if (from.opponent < 0 || from.opponent >= static_cast<int>(settings.members.size())) {
            return "opponent: expected the number of one of this environment's";
        }
        return ((from.fresh | from.over) & ~1) || (from.ending != 0) > from.over
            ? "fresh, over: expected 0 or 1, and 1 of a race with an ending" : nullptr;
    }

    /// Sets the state of a race from a snapshot that is not wrong.
    void load(int k, const Snapshot& from) {
        Slot& slot = races[static_cast<std::size_t>(k)];
        Course course;
        course.count = from.checkpoints;
        std::copy_n(from.checkpointX, from.checkpoints, course.x);
        std::copy_n(from.checkpointY, from.checkpoints, course.y);
        slot.race.place(course);
        State& state = slot.race.state;
        for (int pod = 0; pod < 4; pod++) {
            state.x[pod] = from.x[pod];
            state.y[pod] = from.y[pod];
            state.vx[pod] = from.vx[pod];
            state.vy[pod] = from.vy[pod];
            state.heading[pod] = from.heading[pod];
            state.flags[pod] = from.shieldTimer[pod] | (from.heavy[pod] ? podrace::HEAVY : 0)
                | (from.boostLeft[pod] ? podrace::BOOST_LEFT : 0);
            state.passed[pod] = from.passed[pod];
            state.next[pod] = (from.passed[pod] + 1) % from.checkpoints;
        }
        for (int player = 0; player < 2; player++) {
            state.left[player] = from.turnsLeft[player];
            slot.race.outTurn[player] = from.outTurn[player];
        }
        slot.race.turn = from.turn;
        slot.race.ending = static_cast<Ending>(from.ending);
        slot.member = from.opponent;
        slot.fresh = from.fresh != 0;
        slot.over = from.over != 0;
        slot.seed = from.seed;
        slot.stream = {from.stream};
        Arithmetic exact;
        look(slot);
    }

private:
    struct Slot {
        Race race;
        Ahead ahead = {};
        double worth[2] = {};
        std::uint64_t seed = 0;
        Random stream = {0};
        std::int32_t member = 0;
        bool fresh = true, over = false;

        Slot(const Map& any, Rules rules) : race(any, rules) { }
    };

    Settings settings;
    View view;
    std::vector<Slot> races;
    std::unique_ptr<Workers, Workers::Delete> workers;

    template <typename Test> int find(Test test) const {
        for (int k = 0; k < count(); k++) {
            if (test(races[static_cast<std::size_t>(k)])) {
                return k;
            }
        }
        return -1;
    }

    void begin(Slot& slot) {
        if (!slot.fresh) {
            slot.seed = slot.stream.next();
        }
        slot.fresh = slot.over = false;
        slot.race.start(settings.courses.draw(slot.seed));
        slot.member = 0;
        if (settings.members.size() > 1) {
            double drawn = slot.stream.fraction() * settings.members.back().sum;
            const int last = static_cast<int>(settings.members.size()) - 1;     // the product may round up to the sum
            while (slot.member < last && settings.members[static_cast<std::size_t>(slot.member)].sum <= drawn) {
                slot.member++;
            }
        }
        look(slot);
    }

    void look(Slot& slot) {
        view.ahead(slot.race, slot.ahead);
        if (settings.reward != Reward::result) {
            for (int player = 0; player < 2; player++) {
                int best = slot.race.bestPod(player);
                slot.worth[player] = slot.race.state.passed[best]
                    - slot.race.map().toNext(slot.race.state, best) / 20000;
            }
        }
    }

    /// After a turn: the reward of player 0.
    double settle(Slot& slot) {
        double before = slot.worth[0] - (settings.reward == Reward::lead ? slot.worth[1] : 0);
        slot.over = slot.race.isOver();
        look(slot);
        return settings.reward == Reward::result ? (slot.over ? 2 * result(slot.race) - 1 : 0)
            : slot.worth[0] - (settings.reward == Reward::lead ? slot.worth[1] : 0) - before;
    }

    /// 1 for a victory of player 0, 0.5 for a draw, 0 for a loss.
    static double result(const Race& race) { return 0.5 * (1 + race.rank(1) - race.rank(0)); }

    void observe(int k, int seat, float* out) const {
        const Slot& slot = races[static_cast<std::size_t>(k)];
        view.observe(slot.race, slot.ahead, seat, out + static_cast<std::ptrdiff_t>(k) * view.size());
    }

    static void write(const Commands& commands, int seat, double* out) {
        for (int k = 0; k < 2; k++) {
            out[3 * k] = commands.x[2 * seat + k];
            out[3 * k + 1] = commands.y[2 * seat + k];
            out[3 * k + 2] = commands.thrust[2 * seat + k];
        }
    }
};

} // namespace steward
#endif
