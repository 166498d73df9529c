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
  return {name, {robot.file->robot().variable_count}};
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
  explicit GuardOf(const Robot& robot)
      : robot_(robot),
        words_((tool::robot_ram_bytes(fixed(), robot.file->header().pair_joint_count) + 7) / 8),
        values_(fixed().variable_count),
        floats_(fixed().variable_count),
        guard_(fixed(), words_.data(), words_.size() * sizeof words_[0]) {}

  const Robot& robot() const { return robot_; }
  const flashbvh::Robot& fixed() const { return robot_.file->robot(); }

  void forget() {
    const py::gil_scoped_release release;
    const std::lock_guard<std::mutex> lock(mutex_);
    guard_.forget();
  }

  GuardAnswer update(const double* values, std::uint32_t work) {
    const py::gil_scoped_release release;
    const std::lock_guard<std::mutex> lock(mutex_);
    return period(values, work);
  }

  GuardAnswer go_on(std::uint32_t work) {
    const py::gil_scoped_release release;
    const std::lock_guard<std::mutex> lock(mutex_);
    return guard_.go_on(work);
  }

  /// Replays a trajectory like `flashbvh guard`; calls put(row, answer). The first accepted row
  /// primes the guard.
  template <class Put>
  void check(const double* rows, std::size_t count, std::uint32_t work, const Put& put) {
    const py::gil_scoped_release release;
    const std::lock_guard<std::mutex> lock(mutex_);
    guard_.forget();
    bool is_primed = false;
    for (std::size_t i = 0; i < count; ++i) {
      const GuardAnswer answer =
          period(rows + i * values_.size(), is_primed ? work : tool::kAllWork);
      is_primed = is_primed || answer.status == Status::done;
      put(i, answer);
    }
  }

 private:
  /// Checks a period with values as firmware gets them, as floats.
  GuardAnswer period(const double* values, std::uint32_t work) {
    for (std::size_t i = 0; i < floats_.size(); ++i) {
      floats_[i] = static_cast<float>(values[i]);
    }
    set_values(fixed(), floats_.data(), values_.data());
    return guard_.update(values_.data(), work);
  }

  Robot robot_;
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
  const double cell = guard.robot().file->cell();
  return py::make_tuple(static_cast<int>(answer.verdict), pair, links,
                        tool::unit_length(answer.distance, cell), answer.work,
                        answer.status == Status::done ? "ok" : status_name(answer.status));
}

py::tuple update(GuardOf& guard, const py::object& given, std::int64_t work) {
  const Argument argument = row_of(guard.robot(), "values");
  const Doubles values = numbers(given, argument);
  if (values.ndim() != 1) {
    throw py::value_error("values: is a batch; give the values of one period, or call check()");
  }
  return tuple_of(guard, guard.update(values.data(), work_of(work)));
}

/// Returns verdicts, pairs (-1: none), distances and work of all periods.
py::tuple check(GuardOf& guard, const py::object& given, std::int64_t work) {
  const Doubles values = rows(given, row_of(guard.robot(), "trajectory"));
  const py::ssize_t count = values.shape(0);
  py::array_t<std::uint8_t> verdicts(count);
  py::array_t<std::int32_t> pairs(count);
  py::array_t<double> distances(count);
  py::array_t<std::uint32_t> works(count);
  const double cell = guard.robot().file->cell();
  guard.check(values.data(), static_cast<std::size_t>(count), work_of(work),
              [verdict = verdicts.mutable_data(), pair = pairs.mutable_data(),
               distance = distances.mutable_data(), spent = works.mutable_data(),
               cell](std::size_t i, const GuardAnswer& answer) {
                verdict[i] = static_cast<std::uint8_t>(answer.verdict);
                pair[i] = answer.pair == kNoPair ? -1 : std::int32_t{answer.pair};
                distance[i] = tool::unit_length(answer.distance, cell);
                spent[i] = answer.work;
              });
  return py::make_tuple(verdicts, pairs, distances, works);
}

std::vector<float> floats_of(const Robot& robot, const py::object& given, const char* name) {
  const Doubles values = numbers(given, row_of(robot, name));
  if (values.ndim() != 1) {
    throw py::value_error(concat(name, ": is a batch; give one set of values"));
  }
  return {values.data(), values.data() + values.size()};
}

/// Returns (outcome, part of the motion, values there or none, pair or none, links or none,
/// triangles or none, name of the status).
py::tuple certify(const Robot& robot, const py::object& from, const py::object& to) {
  tool::Trajectory ends(robot.file->robot().variable_count);
  ends.add(0, floats_of(robot, from, "start"));
  ends.add(1, floats_of(robot, to, "end"));
  std::vector<tool::CertifiedMotion> motions;
  {
    const py::gil_scoped_release release;
    motions = tool::certify(robot.file->robot(), ends);
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
  return py::make_tuple(
      tool::outcome_name(answer.outcome), motion.part,
      py::array_t<double>(static_cast<py::ssize_t>(motion.values.size()), motion.values.data()),
      answer.pair, links_of_pair(robot, answer.pair), triangles, "ok");
}

}  // namespace

void add_guards(py::module_& module) {
  py::class_<GuardOf>(module, "Guard")
      .def(py::init<const Robot&>())
      .def("forget", &GuardOf::forget)
      .def("update", update)
      .def("go_on", [](GuardOf& guard,
                       std::int64_t work) { return tuple_of(guard, guard.go_on(work_of(work))); })
      .def("check", check);
  module.def("certify", certify);
  module.attr("ALL_WORK") = tool::kAllWork;
}

}  // namespace flashbvh::python
