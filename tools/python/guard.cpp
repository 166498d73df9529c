// Guards and motions of a robot.
#include <memory>
#include <mutex>
#include <vector>

#include "cli/json.hpp"
#include "flashbvh/robot/guard.hpp"
#include "flashbvh/robot/robot_float.hpp"
#include "python/bindings.hpp"
#include "python/robot.hpp"
#include "robot/baked/robot_writer.hpp"
#include "robot/replay/replay.hpp"

namespace flashbvh::python {
namespace {

using tool::concat;

Argument row_of(const Robot& robot, const char* name) {
  return {name, {robot.robot().variable_count}};
}

std::uint32_t work_of(std::int64_t work) {
  if (work < 1 || work > tool::kAllWork) {
    throw py::value_error(concat("work: is ", work, "; give 1 to ", tool::kAllWork));
  }
  return static_cast<std::uint32_t>(work);
}

/// A guard with its memory. Threads may share it; a lock admits one at a time.
class GuardOf {
 public:
  /// The robot must outlive the guard.
  explicit GuardOf(const Robot& robot)
      : robot_(robot),
        words_((tool::robot_ram_bytes(fixed(), robot.header().pair_joint_count) + 7) / 8),
        values_(fixed().variable_count),
        floats_(fixed().variable_count),
        guard_(fixed(), words_.data(), words_.size() * sizeof words_[0]) {}

  const Robot& robot() const { return robot_; }

  /// Calls without Python's lock, with the guard's own.
  template <class Call>
  auto alone(const Call& call) {
    const py::gil_scoped_release release;
    const std::lock_guard<std::mutex> lock(mutex_);
    return call();
  }

  void forget() {
    alone([&] { guard_.forget(); });
  }

  GuardAnswer update(const double* values, std::uint32_t work) {
    return alone([&] { return period(values, work); });
  }

  GuardAnswer go_on(std::uint32_t work) {
    return alone([&] { return guard_.go_on(work); });
  }

  /// Replays a trajectory like `flashbvh guard`; calls put(row, answer). The first accepted row
  /// primes the guard.
  template <class Put>
  void check(const Numbers& rows, std::uint32_t work, const Put& put) {
    alone([&] {
      guard_.forget();
      bool is_primed = false;
      for (std::size_t i = 0; i < rows.count; ++i) {
        const GuardAnswer answer =
            period(rows.data + i * values_.size(), is_primed ? work : tool::kAllWork);
        is_primed = is_primed || answer.status == Status::done;
        put(i, answer);
      }
    });
  }

 private:
  const flashbvh::Robot& fixed() const { return robot_.robot(); }

  /// Checks a period with values as firmware gets them, as floats.
  GuardAnswer period(const double* values, std::uint32_t work) {
    for (std::size_t i = 0; i < floats_.size(); ++i) {
      floats_[i] = static_cast<float>(values[i]);
    }
    set_values(fixed(), floats_.data(), values_.data());
    return guard_.update(values_.data(), work);
  }

  const Robot& robot_;
  std::vector<std::uint64_t> words_;
  std::vector<JointCoordinate> values_;
  std::vector<float> floats_;
  std::mutex mutex_;
  Guard guard_;
};

/// Returns (verdict, pair or none, links or none, distance in metres, work, name of the status).
py::tuple tuple_of(const GuardOf& guard, const GuardAnswer& answer) {
  py::object pair = py::none();
  py::object links = py::none();
  if (answer.pair != kNoPair) {
    pair = py::int_(answer.pair);
    links = links_of_pair(guard.robot(), answer.pair);
  }
  return py::make_tuple(static_cast<int>(answer.verdict), pair, links,
                        tool::unit_length(answer.distance, guard.robot().cell()), answer.work,
                        answer.status == Status::done ? "ok" : status_name(answer.status));
}

/// One set of values; `more` ends the message that refuses a batch.
Numbers values_of(const Robot& robot, const py::object& given, const char* name, const char* more) {
  Numbers values = numbers(given, row_of(robot, name));
  if (!values.shape.empty()) {
    throw py::value_error(concat(name, ": is a batch; ", more));
  }
  return values;
}

py::tuple update(GuardOf& guard, const py::object& given, std::int64_t work) {
  const Numbers values =
      values_of(guard.robot(), given, "values", "give the values of one period, or call check()");
  return tuple_of(guard, guard.update(values.data, work_of(work)));
}

/// A guard's answer for a period of a trajectory.
struct PeriodRow {
  std::uint8_t verdict;
  std::int32_t pair;  ///< -1: none
  double distance;
  std::uint32_t work;
};

py::array check(GuardOf& guard, const py::object& given, std::int64_t work) {
  const Numbers values = rows(given, row_of(guard.robot(), "trajectory"));
  const Results<PeriodRow> periods(values.shape);
  guard.check(values, work_of(work), [&](std::size_t i, const GuardAnswer& answer) {
    periods.data[i] = {static_cast<std::uint8_t>(answer.verdict),
                       answer.pair == kNoPair ? -1 : std::int32_t{answer.pair},
                       tool::unit_length(answer.distance, guard.robot().cell()), answer.work};
  });
  return periods.array;
}

std::vector<float> floats_of(const Robot& robot, const py::object& given, const char* name) {
  const Numbers values = values_of(robot, given, name, "give one set of values");
  return {values.data, values.data + values.array.size()};
}

/// Returns (outcome, part of the motion, values there or none, pair or none, links or none,
/// triangles or none, name of the status).
py::tuple certify(const Robot& robot, const py::object& from, const py::object& to) {
  tool::Trajectory ends(robot.robot().variable_count);
  ends.add(0, floats_of(robot, from, "start"));
  ends.add(1, floats_of(robot, to, "end"));
  std::vector<tool::CertifiedMotion> motions;
  {
    const py::gil_scoped_release release;
    motions = tool::certify(robot.robot(), ends);
  }
  const tool::CertifiedMotion& motion = motions.front();
  const MotionAnswer& answer = motion.answer;
  if (answer.status != Status::done) {
    return py::make_tuple("refused", 0.0, py::none(), py::none(), py::none(), py::none(),
                          status_name(answer.status));
  }
  if (answer.outcome == MotionOutcome::free) {
    return py::make_tuple("free", 1.0, py::none(), py::none(), py::none(), py::none(), "ok");
  }
  py::object triangles = py::none();
  if (answer.outcome == MotionOutcome::hit) {
    triangles = py::make_tuple(answer.triangles.a, answer.triangles.b);
  }
  return py::make_tuple(tool::outcome_name(answer.outcome), motion.part, array_of(motion.values),
                        answer.pair, links_of_pair(robot, answer.pair), triangles, "ok");
}

}  // namespace

void add_guards(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(PeriodRow, verdict, pair, distance, work);
  py::class_<GuardOf>(module, "Guard")
      .def(py::init<const Robot&>(), py::keep_alive<1, 2>())
      .def("forget", &GuardOf::forget)
      .def("update", update)
      .def("go_on", [](GuardOf& guard,
                       std::int64_t work) { return tuple_of(guard, guard.go_on(work_of(work))); })
      .def("check", check);
  module.def("certify", certify);
  module.attr("ALL_WORK") = tool::kAllWork;
}

}  // namespace flashbvh::python
