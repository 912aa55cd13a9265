// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/drive/recorded_tour.h"

#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "backend/text.h"

namespace gmapping_spa::drive {
namespace {

constexpr const char* kHeader = "linear_m_s,angular_rad_s,odometry_noise,slips_per_m";
constexpr double kMillimetersPerMeter = 1e3;

class Recorder : public simulation::LogSink {
 public:
  void OnOdometry(const simulation::OdometryReading& reading) override {
    odometry.push_back(reading);
  }
  void OnScan(const simulation::OdometryReading& /*odometry*/,
              const simulation::LidarOptions& /*lidar*/,
              const std::vector<double>& ranges_m) override {
    // Which is what they are rounded to.
    for (const double range_m : ranges_m) {
      ranges_mm.push_back(static_cast<std::int32_t>(std::lround(range_m * kMillimetersPerMeter)));
    }
  }

  std::vector<simulation::OdometryReading> odometry;
  std::vector<std::int32_t> ranges_mm;
};

}  // namespace

void RecordedTour::Drive(const DriveCommand& command, DrivenRobot* robot) {
  Recorder recorder;
  const backend::SE2 world_T_robot = robot->world_T_robot();
  robot->Step(command, &recorder);
  const double stamp_s = recorder.odometry.front().stamp_s;
  const std::lock_guard lock(mutex_);
  steps_.push_back({command,
                    std::move(recorder.odometry),
                    std::move(recorder.ranges_mm),
                    {stamp_s, world_T_robot}});
  has_grown_.notify_all();
}

std::size_t RecordedTour::steps() const {
  const std::lock_guard lock(mutex_);
  return steps_.size();
}

bool RecordedTour::WaitForMore(std::size_t steps, std::chrono::milliseconds patience) const {
  std::unique_lock lock(mutex_);
  return has_grown_.wait_for(lock, patience, [&] { return steps_.size() > steps; });
}

void RecordedTour::Play(std::size_t from, std::size_t to, simulation::LogSink* sink) const {
  for (std::size_t i = from; i < to; ++i) {
    const Step* step = nullptr;
    {
      const std::lock_guard lock(mutex_);
      step = &steps_.at(i);
    }
    for (const simulation::OdometryReading& reading : step->odometry) {
      sink->OnOdometry(reading);
      if (&reading != &step->odometry.front() || step->ranges_mm.empty()) continue;
      std::vector<double> ranges_m;
      for (const std::int32_t range_mm : step->ranges_mm) {
        ranges_m.push_back(range_mm / kMillimetersPerMeter);
      }
      sink->OnScan(reading, lidar_, ranges_m);
    }
  }
}

backend::Trajectory RecordedTour::TrueTrajectory(std::size_t from, std::size_t to) const {
  const std::lock_guard lock(mutex_);
  backend::Trajectory trajectory;
  for (std::size_t i = from; i < to; ++i) {
    if (!steps_[i].ranges_mm.empty()) trajectory.push_back(steps_[i].truth);
  }
  return trajectory;
}

void RecordedTour::WriteCommands(std::ostream& out) const {
  const std::lock_guard lock(mutex_);
  out << kHeader << '\n';
  for (const Step& step : steps_) {
    const DriveCommand& command = step.command;
    out << backend::ShortestText(command.velocity.linear_m_s) << ','
        << backend::ShortestText(command.velocity.angular_rad_s) << ','
        << backend::ShortestText(command.odometry_noise) << ','
        << backend::ShortestText(command.slips_per_m) << '\n';
  }
}

std::vector<DriveCommand> ReadCommands(std::istream& in, const std::string& name) {
  std::vector<DriveCommand> commands;
  int line_number = 0;
  const auto fail = [&](const std::string& expected, const std::string& line) {
    throw std::runtime_error(name + ":" + std::to_string(line_number) + ": expected " + expected +
                             ", found '" + line + "'");
  };
  for (std::string line; std::getline(in, line);) {
    ++line_number;
    if (line_number == 1) {
      if (line != kHeader) fail(std::string("the header ") + kHeader, line);
      continue;
    }
    std::array<double, 4> numbers{};
    std::string_view rest = line;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const std::size_t comma = rest.find(',');
      const bool is_last = i + 1 == numbers.size();
      const auto number = backend::ParseFinite<double>(rest.substr(0, comma));
      if (!number || (comma == std::string_view::npos) != is_last) fail("four numbers", line);
      numbers[i] = *number;
      rest.remove_prefix(is_last ? rest.size() : comma + 1);
    }
    if (numbers[2] < 0.0 || numbers[3] < 0.0) fail("noise and slips from 0", line);
    // A number that is cut is another number.
    if (in.eof()) fail("a line that ends, as the last one of a whole file does", line);
    commands.push_back({{numbers[0], numbers[1]}, numbers[2], numbers[3]});
  }
  if (line_number == 0) {
    throw std::runtime_error(name + ": expected commands of a tour, found nothing");
  }
  return commands;
}

}  // namespace gmapping_spa::drive
