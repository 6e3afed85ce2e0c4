// The module for Python: checks arrays, releases the interpreter's lock, calls Batch. Compiled plain and by AVX2.
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <optional>
#include <system_error>

#include "batch.hpp"

namespace nb = nanobind;
using steward::Batch;

namespace steward {
const WholeDegrees View::DEGREES;
}

namespace {

template <typename T> using Array = nb::ndarray<T, nb::c_contig, nb::device::cpu>;

std::string shapeOf(const std::vector<std::size_t>& shape) {
    std::string text = "(";
    for (std::size_t each : shape) {
        text += std::to_string(each) + (shape.size() == 1 ? "," : ", ");
    }
    return text.substr(0, text.size() - (shape.size() > 1 ? 2 : 0)) + ")";
}

/// The numbers of an array that has this shape.
template <typename T> T* data(const Array<T>& array, const std::vector<std::size_t>& expected, const char* name) {
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < array.ndim(); k++) {
        found.push_back(array.shape(k));
    }
    if (found != expected) {
        throw nb::value_error((std::string(name) + ": found the shape " + shapeOf(found) + ", expected "
            + shapeOf(expected)).c_str());
    }
    return array.data();
}

std::size_t count(const Batch& batch) { return static_cast<std::size_t>(batch.count()); }
std::size_t numbers(const Batch& batch) { return static_cast<std::size_t>(batch.observationSize()); }

[[noreturn]] void refuse(const std::string& message) { throw nb::value_error(message.c_str()); }

/// Refuses a second call while another thread's is at work: steps let go of the interpreter's lock.
class Call {
public:
    explicit Call(const Batch& batch) : isUsed(batch.isUsed) {
        if (isUsed.exchange(true)) {
            refuse("found a call while another thread's is at work, expected one thread at a time for an environment");
        }
    }
    ~Call() { isUsed = false; }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

private:
    std::atomic<bool>& isUsed;
};

void check(const Batch& batch, const float* actions, const char* name) {
    const std::ptrdiff_t width = batch.actionSize();
    for (std::ptrdiff_t k = 0; k < batch.count() * width; k++) {
        if (!std::isfinite(actions[k])) {
            refuse(std::string(name) + ": found " + (actions[k] != actions[k] ? "NaN" : "an infinite number")
                + " in race " + std::to_string(k / width) + ", expected finite numbers");
        }
    }
}

void check(const Batch& batch, const std::int64_t* actions, const char* name) {
    for (std::ptrdiff_t k = 0; k < batch.count() * static_cast<std::ptrdiff_t>(steward::View::DISCRETE); k++) {
        std::int64_t most = k % 2 == 0 ? steward::View::TURNS - 1 : steward::View::THRUSTS - 1;
        if (actions[k] < 0 || actions[k] > most) {
            refuse(std::string(name) + ": found " + std::to_string(actions[k]) + " in race "
                + std::to_string(k / steward::View::DISCRETE) + ", expected 0.." + std::to_string(most));
        }
    }
}

template <typename Action>
int step(Batch& batch, const Array<const Action>& actions, const std::optional<Array<const Action>>& foreign,
         const Array<float>& observations, const Array<double>& rewards, const Array<bool>& terminated,
         const Array<double>& results, const Array<std::int64_t>& turns) {
    Call call(batch);
    const std::size_t n = count(batch), width = static_cast<std::size_t>(batch.actionSize());
    const Action* own = data(actions, {n, width}, "actions");
    const Action* others = foreign ? data(*foreign, {n, width}, "the opponent's actions") : nullptr;
    check(batch, own, "actions");
    if (others != nullptr) {
        check(batch, others, "the opponent's actions");
    } else if (batch.needsForeign()) {
        refuse("the opponent's actions: found none, expected an array");
    }
    int over = batch.isAutomatic() ? -1 : batch.firstOver();
    if (over >= 0) {
        refuse("race " + std::to_string(over) + " is over: expected a reset of it first");
    }
    steward::Outputs out = {data(observations, {n, numbers(batch)}, "observations"), data(rewards, {n}, "rewards"),
        data(terminated, {n}, "terminated"), data(results, {n}, "results"), data(turns, {n}, "turns")};
    int ended;
    {
        nb::gil_scoped_release released;
        ended = batch.step(own, others, out);
    }
    if (ended < 0) {
        throw std::runtime_error("a turn had more than 14000 impacts; the state is not the referee's");
    }
    return ended;
}

void play(Batch& batch, const Array<const double>& commands, const Array<const bool>& faults) {
    Call call(batch);
    const double* given = data(commands, {count(batch), 4, 3}, "commands");
    const bool* faulty = data(faults, {count(batch), 2}, "faults");
    for (std::size_t k = 0; k < count(batch) * 12; k++) {
        double size = std::fabs(given[k]);
        bool good = k % 3 == 2 ? given[k] == std::floor(given[k]) && given[k] >= -3 && given[k] <= 200
            : size == 0 || (size >= 0x1p-300 && size <= 0x1p300);
        if (!good) {
            refuse("commands: found " + std::to_string(given[k]) + " in race " + std::to_string(k / 12)
                + (k % 3 == 2 ? ", expected a whole thrust 0..200, -1 none, -2 shield, -3 boost"
                    : ", expected a finite place"));
        }
    }
    bool whole;
    {
        nb::gil_scoped_release released;
        whole = batch.play(given, faulty);
    }
    if (!whole) {
        throw std::runtime_error("a turn had more than 14000 impacts; the state is not the referee's");
    }
}

Batch* create(int races, int threads, bool contest, const std::vector<std::vector<std::pair<double, double>>>& maps,
              const std::vector<std::pair<double, bool>>& members, bool full, bool discrete, int reward,
              bool autoreset) {
    if (races < 1 || threads < 1 || members.empty() || reward < 0 || reward > 2) {
        refuse("settings out of range");
    }
    steward::Settings settings;
    settings.rules = contest ? steward::Rules::contest : steward::Rules::live;
    std::vector<steward::Course> courses;
    for (const auto& map : maps) {
        if (map.size() < 2 || map.size() > steward::MOST_CHECKPOINTS) {
            refuse("a map: found " + std::to_string(map.size()) + " checkpoints, expected 2..16");
        }
        steward::Course course;
        for (const auto& place : map) {
            course.x[course.count] = place.first;
            course.y[course.count++] = place.second;
        }
        courses.push_back(course);
    }
    if (!courses.empty()) {
        settings.courses = steward::Courses(std::move(courses));
    }
    double sum = 0;
    for (const auto& member : members) {
        sum += member.first;
        settings.members.push_back({sum, member.second});
    }
    settings.full = full;
    settings.discrete = discrete;
    settings.reward = static_cast<steward::Reward>(reward);
    settings.autoreset = autoreset;
    try {
        return new Batch(races, threads, std::move(settings));
    } catch (const std::system_error&) {
        refuse("threads: found " + std::to_string(threads) + ", expected no more than the system starts");
    }
}

void load(Batch& batch, const Array<const std::uint8_t>& states) {
    Call call(batch);
    const auto* from = reinterpret_cast<const steward::Snapshot*>(
        data(states, {count(batch), sizeof(steward::Snapshot)}, "states"));
    for (int k = 0; k < batch.count(); k++) {
        if (const char* wrong = batch.wrong(from[k])) {
            refuse("states, race " + std::to_string(k) + ", " + wrong);
        }
    }
    for (int k = 0; k < batch.count(); k++) {
        batch.load(k, from[k]);
    }
}

} // namespace

NB_MODULE(STEWARD_MODULE, m) {
    using nb::arg;
#if defined(__x86_64__) && defined(__GNUC__)
    m.attr("HAS_AVX2") = __builtin_cpu_supports("avx2") != 0;
#else
    m.attr("HAS_AVX2") = false;
#endif
    m.attr("LANES") = steward::podrace::LANES;
    m.attr("STATE_BYTES") = sizeof(steward::Snapshot);
    nb::class_<Batch>(m, "Batch")
        .def(nb::new_(&create), arg("races"), arg("threads"), arg("contest"), arg("maps"), arg("members"), arg("full"),
            arg("discrete"), arg("reward"), arg("autoreset"))
        .def_prop_ro("observation_size", &Batch::observationSize)
        .def("seed", [](Batch& batch, const Array<const std::uint64_t>& seeds, const Array<const bool>& mask) {
            Call call(batch);
            const std::uint64_t* values = data(seeds, {count(batch)}, "seeds");
            const bool* chosen = data(mask, {count(batch)}, "mask");
            for (int k = 0; k < batch.count(); k++) {
                if (chosen[k]) {
                    batch.seed(k, values[k]);
                }
            }
        })
        .def("reset", [](Batch& batch, const Array<const bool>& mask, const Array<float>& observations) {
            Call call(batch);
            const bool* chosen = data(mask, {count(batch)}, "mask");
            float* out = data(observations, {count(batch), numbers(batch)}, "observations");
            nb::gil_scoped_release released;
            batch.reset(chosen, out);
        })
        .def("step", &step<float>, arg("actions").noconvert(), arg("foreign").noconvert().none(), arg("observations"),
            arg("rewards"), arg("terminated"), arg("results"), arg("turns"))
        .def("step_discrete", &step<std::int64_t>, arg("actions").noconvert(), arg("foreign").noconvert().none(),
            arg("observations"), arg("rewards"), arg("terminated"), arg("results"), arg("turns"))
        .def("play", &play)
        .def("observe", [](Batch& batch, int seat, const Array<float>& observations) {
            Call call(batch);
            float* out = data(observations, {count(batch), numbers(batch)}, "observations");
            nb::gil_scoped_release released;
            batch.observeAll(seat & 1, out);
        })
        .def("racer", [](Batch& batch, int seat, const Array<double>& out) {
            Call call(batch);
            batch.racerCommands(seat & 1, data(out, {count(batch), 2, 3}, "out"));
        })
        .def("orders", [](Batch& batch, int seat, const Array<const float>& actions, const Array<double>& out) {
            Call call(batch);
            const float* given = data(actions, {count(batch), steward::View::CONTINUOUS}, "actions");
            check(batch, given, "actions");
            batch.orders(seat & 1, given, data(out, {count(batch), 2, 3}, "out"));
        })
        .def("opponents", [](const Batch& batch, const Array<std::int64_t>& out) {
            Call call(batch);
            std::int64_t* to = data(out, {count(batch)}, "out");
            for (int k = 0; k < batch.count(); k++) {
                to[k] = batch.opponent(k);
            }
        })
        .def("hashes", [](const Batch& batch, const Array<std::uint64_t>& out) {
            Call call(batch);
            batch.hashes(data(out, {count(batch)}, "out"));
        })
        .def("ranks", [](const Batch& batch, const Array<std::int32_t>& out) {
            Call call(batch);
            batch.ranks(data(out, {count(batch), 2}, "out"));
        })
        .def("save", [](const Batch& batch, const Array<std::uint8_t>& out) {
            Call call(batch);
            std::uint8_t* to = data(out, {count(batch), sizeof(steward::Snapshot)}, "out");
            batch.save(reinterpret_cast<steward::Snapshot*>(to));
        })
        .def("load", &load);
    m.def("draw", [](std::uint64_t seed) {
        static const steward::Courses official;
        steward::Course course = official.draw(seed);
        std::vector<std::pair<double, double>> places;
        for (int k = 0; k < course.count; k++) {
            places.emplace_back(course.x[k], course.y[k]);
        }
        return places;
    }, "The official map that a seed draws.");
    m.def("strict_turn", [](double radians) {
        steward::Arithmetic exact;
        std::pair<double, double> both;
        steward::strictTurn(radians, both.first, both.second);
        return both;
    }, "Cosine and sine as the JDK's StrictMath has them, of 0..2 pi.");
}
