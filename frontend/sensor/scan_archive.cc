// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/scan_archive.h"

#include <algorithm>
#include <numeric>

#include "frontend/sensor/deskew.h"

namespace gmapping_spa::sensor {
namespace {

bool HasAngles(const LaserScan& scan, const std::vector<double>& angles_rad) {
  return std::equal(scan.beams.begin(), scan.beams.end(), angles_rad.begin(), angles_rad.end(),
                    [](const Beam& beam, double angle_rad) { return beam.angle_rad == angle_rad; });
}

}  // namespace

int ScanArchive::Add(const LaserScan& scan, const Eigen::Vector3d& velocity) {
  Entry entry{.index = scan.index,
              .stamp_s = scan.stamp_s,
              .odom_T_robot = scan.odom_T_robot,
              .robot_T_laser = scan.robot_T_laser,
              .angles_rad = nullptr,
              .ranges = PackedRanges(scan.beams),
              .velocity = velocity,
              .sweep_s = scan.sweep_s,
              .has_odometry = scan.has_odometry};

  if (!scans_.empty() && HasAngles(scan, *scans_.back().angles_rad)) {
    entry.angles_rad = scans_.back().angles_rad;
  } else {
    std::vector<double> angles_rad;
    for (const Beam& beam : scan.beams) angles_rad.push_back(beam.angle_rad);
    entry.angles_rad = std::make_shared<const std::vector<double>>(std::move(angles_rad));
  }
  // Half of the sweep comes after the stamp, or all of it.
  if (size() > (sessions_.empty() ? 0 : sessions_.back().end)) {
    Entry& before = scans_.back();
    before.velocity = before.sweep_s > 0.0 ? velocity : 0.5 * (latest_velocity_ + velocity);
  }
  latest_velocity_ = velocity;
  scans_.push_back(std::move(entry));
  return size() - 1;
}

void ScanArchive::BeginSession() {
  sessions_.push_back({size(), sweep_s_});
  sweep_s_ = 0.0;
}

LaserScan ScanArchive::Measured(int position) const {
  const Entry& entry = scans_.at(position);
  LaserScan scan{entry.index, entry.stamp_s, entry.odom_T_robot, entry.robot_T_laser, {}};
  scan.has_odometry = entry.has_odometry;
  scan.sweep_s = entry.sweep_s;
  scan.beams.reserve(entry.ranges.size());
  for (std::size_t k = 0; k < entry.ranges.size(); ++k) {
    scan.beams.push_back(entry.ranges.BeamAt(k, (*entry.angles_rad)[k]));
  }
  return scan;
}

LaserScan ScanArchive::Get(int position) const {
  const auto session = std::find_if(sessions_.begin(), sessions_.end(),
                                    [=](const Session& one) { return position < one.end; });
  const double sweep_s = session == sessions_.end() ? sweep_s_ : session->sweep_s;
  return Deskew(Measured(position), sweep_s * scans_.at(position).velocity);
}

std::vector<std::size_t> ScanArchive::Rows() const {
  std::vector<std::size_t> positions(scans_.size()), rows(scans_.size());
  std::iota(positions.begin(), positions.end(), 0);
  std::sort(positions.begin(), positions.end(),
            [this](std::size_t a, std::size_t b) { return scans_[a].index < scans_[b].index; });
  for (std::size_t row = 0; row < rows.size(); ++row) rows[positions[row]] = row;
  return rows;
}

bool ScanArchive::Holds(int position, const LaserScan& scan) const {
  const Entry& entry = scans_.at(position);
  if (entry.index != scan.index || entry.stamp_s != scan.stamp_s ||
      entry.odom_T_robot != scan.odom_T_robot || entry.robot_T_laser != scan.robot_T_laser ||
      entry.sweep_s != scan.sweep_s || entry.has_odometry != scan.has_odometry ||
      entry.ranges != PackedRanges(scan.beams)) {
    return false;
  }
  return HasAngles(scan, *entry.angles_rad);
}

}  // namespace gmapping_spa::sensor
