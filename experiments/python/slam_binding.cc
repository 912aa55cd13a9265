// SPDX-License-Identifier: BSD-3-Clause
// SLAM: scans in; poses, map and pose graph out.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <atomic>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "experiments/python/bindings.h"
#include "experiments/python/conversions.h"
#include "experiments/python/log_messages.h"
#include "experiments/python/python_optimizer.h"
#include "experiments/python/running_calls.h"
#include "frontend/api/slam.h"

namespace gmapping_spa::python {
namespace {

namespace py = pybind11;

// What scan matching takes, in cells from the robot, with room for the motion during a scan.
constexpr double kMostCells = 9000.0;

// A Slam that one call at a time uses, and that is left to itself when a call is interrupted.
class GuardedSlam {
 public:
  GuardedSlam(SlamOptions options, const py::object& back_end)
      : state_(std::make_shared<State>()), farthest_m_(kMostCells * options.resolution_m) {
    CheckSlamOptions(options);
    const std::shared_ptr<backend::Optimizer> optimizer =
        OptimizerFrom(back_end.is_none() ? py::cast(options.backend) : back_end);
    FitLoss(*optimizer, &options.optimizer);
    HandOnLogMessages();
    state_->slam.emplace(options, optimizer);
  }

  // Waits for the back end, which may be one in Python and need the GIL.
  ~GuardedSlam() {
    const py::gil_scoped_release release;
    state_.reset();
  }
  GuardedSlam(const GuardedSlam&) = delete;
  GuardedSlam& operator=(const GuardedSlam&) = delete;

  ScanResult AddScan(const sensor::LaserScan& scan) {
    const Use use(state_);
    if (scan.stamp_s < last_stamp_s_) {
      throw py::value_error("stamp_s: expected scans in the order of time, found " +
                            std::string(py::str(py::float_(scan.stamp_s))) + " after " +
                            std::string(py::str(py::float_(last_stamp_s_))));
    }
    for (const sensor::Beam& beam : scan.beams) {
      if (beam.range_m + scan.robot_T_laser.translation().norm() < farthest_m_) continue;
      throw py::value_error("expected beams within " +
                            std::string(py::str(py::float_(farthest_m_))) +
                            " m of the robot at this resolution of the map, found a range of " +
                            std::string(py::str(py::float_(beam.range_m))) + " m");
    }
    const ScanResult result = [&] {
      const py::gil_scoped_release release;
      return state_->slam->AddScan(scan);
    }();
    last_stamp_s_ = scan.stamp_s;
    HandOnLogMessages();
    return result;
  }

  void Finish() {
    auto use = std::make_shared<Use>(state_);
    try {
      CallInterruptibly([use] { use->state().slam->Finish(); });
    } catch (const py::error_already_set&) {
      state_->interrupted = true;
      throw;
    }
    use.reset();
    HandOnLogMessages();
  }

  // Calls `ask(slam)` without the GIL.
  template <typename Function>
  auto Ask(const Function& ask) const {
    const Use use(state_);
    const py::gil_scoped_release release;
    return ask(std::as_const(*state_->slam));
  }

 private:
  struct State {
    std::optional<Slam> slam;
    std::atomic_flag in_use;
    std::atomic<bool> interrupted = false;
  };

  // Keeps the state while it is used, which no other thread may do then.
  class Use {
   public:
    explicit Use(std::shared_ptr<State> state) : state_(std::move(state)) {
      if (state_->interrupted) throw std::runtime_error("finish() of this Slam was interrupted");
      if (state_->in_use.test_and_set()) {
        throw std::runtime_error("a Slam takes one call at a time, and another thread is in one");
      }
    }
    ~Use() { state_->in_use.clear(); }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;
    State& state() const { return *state_; }

   private:
    std::shared_ptr<State> state_;
  };

  std::shared_ptr<State> state_;
  double farthest_m_;
  double last_stamp_s_ = -std::numeric_limits<double>::infinity();
};

void BindScanResult(py::module_& module) {
  py::class_<ScanResult>(module, "ScanResult", "What came of a scan.")
      .def_property_readonly(
          "world_T_robot", [](const ScanResult& result) { return ToArray(result.world_T_robot); },
          "The likeliest pose [x, y, theta] of the robot at this scan by what is known by now, m "
          "and rad; the world frame is the pose at the first scan.")
      .def_readonly("updated", &ScanResult::updated, "The pose graph has more nodes.")
      .def_readonly("closed_loop", &ScanResult::closed_loop,
                    "Loop closures were accepted, or taken back.")
      .def_readonly("corrected", &ScanResult::corrected,
                    "An optimized graph corrected the particles: poses of before have moved.")
      .def_readonly("ambiguous", &ScanResult::ambiguous, "Several motions fit the scan.")
      .def_readonly("lost", &ScanResult::lost,
                    "The scan fits nothing before: world_T_robot is a guess.")
      .def("__repr__", [](const ScanResult& result) {
        const backend::SE2& pose = result.world_T_robot;
        return py::str("<ScanResult at ({}, {}, {}){}>")
            .format(pose.x, pose.y, pose.theta, result.lost ? ", lost" : "");
      });
}

}  // namespace

void BindSlam(py::module_& module) {
  BindScanResult(module);
  py::class_<GuardedSlam>(
      module, "Slam",
      "Improved GMapping (Tao et al. 2021): a Rao-Blackwellized particle filter whose best "
      "particle's path is a pose graph, which a back end optimizes in a thread of its own.\n\nThe "
      "world frame is the pose of the robot at the first scan; m, rad and s. Results depend on the "
      "scans and the options only, but with graph_thread=\"async\", and are those of the "
      "executable "
      "gmapping_spa. One thread at a time may use an object, others get a RuntimeError; the GIL is "
      "free meanwhile. Warnings go to the logger gmapping_spa.")
      .def(
          py::init<SlamOptions, py::object>(), py::arg_v("options", SlamOptions(), "SlamOptions()"),
          py::arg("backend") = py::none(),
          "backend: in place of options.backend a name, a path, or an object with the method "
          "optimize(nodes, edges), as optimize() takes it; it is called in another thread. What it "
          "raises, or returns that is no result, costs its result and a warning.\n\nRaises "
          "ValueError on options out of range, RuntimeError where there is no such back end or it "
          "cannot do what the options ask for.")
      .def("add_scan", &GuardedSlam::AddScan, py::arg("scan"),
           "Takes the next scan, in the order of time, and returns a ScanResult. Takes "
           "milliseconds, "
           "more where a loop is closed; waits up to options.graph_timeout_s for the back "
           "end.\n\nRaises ValueError on a scan before the last one or one that is too far for "
           "maps, "
           "RuntimeError when the odometry leads out of the area that a map can cover, or after "
           "finish().")
      .def("finish", &GuardedSlam::Finish,
           "After the last scan: closes the loops that are left, optimizes, aligns all scans and "
           "builds the map from all of them. From then on, what is asked is the final result. "
           "Ctrl-C raises KeyboardInterrupt; the object is of no use then.")
      .def_property_readonly(
          "pose",
          [](const GuardedSlam& s) {
            return ToArray(s.Ask([](const Slam& slam) { return slam.CurrentPose(); }));
          },
          "Pose [x, y, theta] of the robot at the latest scan, m and rad. Like the others, raises "
          "RuntimeError before the first scan.")
      .def_property_readonly(
          "map",
          [](const GuardedSlam& s) {
            return s.Ask([](const Slam& slam) { return slam.CurrentMap(); });
          },
          "The map by now, made anew each time: an OccupancyMap.")
      .def_property_readonly(
          "graph",
          [](const GuardedSlam& s) {
            return s.Ask([](const Slam& slam) { return slam.CurrentGraph(); });
          },
          "The pose graph by now, made anew each time: a node an update, and loop closures.")
      .def_property_readonly(
          "trajectory",
          [](const GuardedSlam& s) {
            const backend::Trajectory trajectory =
                s.Ask([](const Slam& slam) { return slam.CurrentTrajectory(); });
            return Copied(trajectory.data(), trajectory.size());
          },
          "Poses of all scans in the order in which they were added: an array of "
          "TRAJECTORY_DTYPE, made anew each time.");
}

}  // namespace gmapping_spa::python
