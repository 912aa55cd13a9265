// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/log_inspection.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace gmapping_spa::apps {
namespace {

using sensor::Beam;
using sensor::BeamStatus;
using sensor::LaserScan;
using sensor::OdometryFault;

constexpr std::size_t kMostSamples = 64;

// Whether the robot moved between two scans: many beams end elsewhere, by more than noise and
// people walking by explain.
bool Differ(const LaserScan& a, const LaserScan& b) {
  constexpr double kNoiseM = 0.1, kMovedShare = 0.15;
  if (a.beams.size() != b.beams.size()) return true;
  int compared = 0, moved = 0;
  for (std::size_t i = 0; i < a.beams.size(); ++i) {
    const Beam &p = a.beams[i], &q = b.beams[i];
    if (p.status != BeamStatus::kHit || q.status != BeamStatus::kHit) continue;
    ++compared;
    if (std::abs(p.range_m - q.range_m) > kNoiseM) ++moved;
  }
  return moved > kMovedShare * compared;
}

void Count(OdometryFault fault, double stamp_s, std::map<std::string, frontend::Finding>* all) {
  const frontend::Finding first{OdometryFaultMessage(fault), stamp_s, stamp_s, 0};
  frontend::Finding& finding = all->try_emplace(OdometryFaultName(fault), first).first->second;
  ++finding.count;
  finding.last_stamp_s = stamp_s;
}

}  // namespace

void LogInspector::Add(const LaserScan& scan) {
  LogSummary& s = summary_;
  if (s.scans == 0) {
    s.first_stamp_s = s.last_stamp_s = scan.stamp_s;
    s.first_beam_rad = scan.beams.front().angle_rad;
    s.last_beam_rad = scan.beams.back().angle_rad;
    s.robot_T_laser = scan.robot_T_laser;
  }
  if (previous_) s.periods_s.push_back(scan.stamp_s - previous_->stamp_s);
  s.first_stamp_s = std::min(s.first_stamp_s, scan.stamp_s);
  s.last_stamp_s = std::max(s.last_stamp_s, scan.stamp_s);
  AddBeams(scan);
  AddOdometry(scan);
  AddSample(scan);
  ++s.scans;
  previous_ = scan;
}

void LogInspector::AddBeams(const LaserScan& scan) {
  ++summary_.scans_by_beams[scan.beams.size()];
  for (const Beam& beam : scan.beams) {
    if (beam.status != BeamStatus::kHit) continue;
    if (summary_.hits_by_meter.empty()) summary_.shortest_hit_m = beam.range_m;
    const auto meter = static_cast<std::size_t>(beam.range_m);
    if (meter >= summary_.hits_by_meter.size()) summary_.hits_by_meter.resize(meter + 1);
    ++summary_.hits_by_meter[meter];
    summary_.shortest_hit_m = std::min(summary_.shortest_hit_m, beam.range_m);
    summary_.longest_hit_m = std::max(summary_.longest_hit_m, beam.range_m);
  }
}

void LogInspector::AddOdometry(const LaserScan& scan) {
  const OdometryFault fault = check_.Check(scan).fault;
  if (scan.has_odometry) {
    ++summary_.scans_with_odometry;
    summary_.odom_T_robot.push_back(scan.odom_T_robot);
  }
  if (previous_ && previous_->has_odometry && scan.has_odometry) {
    const backend::SE2 motion = backend::Between(previous_->odom_T_robot, scan.odom_T_robot);
    summary_.steps.push_back({scan.stamp_s, scan.stamp_s - previous_->stamp_s,
                              motion.translation().norm(), std::abs(motion.theta), fault});
  }
  if (fault == OdometryFault::kUnchanged) {
    if (Differ(*last_moved_, scan)) {
      silence_.Mark("silent", scan.stamp_s);
      summary_.silent.clear();
      // Wheels that are one scan late are not silent.
      std::ranges::copy_if(silence_.stretches().at("silent"), std::back_inserter(summary_.silent),
                           [](const auto& stretch) { return stretch.end_s > stretch.begin_s; });
    }
    return;
  }
  last_moved_ = scan;
  if (fault != OdometryFault::kNone && fault != OdometryFault::kFirst) {
    Count(fault, scan.stamp_s, &summary_.findings);
  }
}

void LogInspector::AddSample(const LaserScan& scan) {
  std::vector<LaserScan>& samples = summary_.samples;
  if (summary_.scans % sample_stride_ != 0) return;
  if (samples.size() == kMostSamples) {  // keep every other one
    for (std::size_t i = 0; i < kMostSamples / 2; ++i) samples[i] = std::move(samples[2 * i]);
    samples.resize(kMostSamples / 2);
    sample_stride_ *= 2;
    if (summary_.scans % sample_stride_ != 0) return;
  }
  samples.push_back(scan);
}

}  // namespace gmapping_spa::apps
