// SPDX-License-Identifier: BSD-3-Clause
// Records as messages of ROS.
#ifndef GMAPPING_SPA_EXPERIMENTS_CONVERSION_BAG_SINK_H_
#define GMAPPING_SPA_EXPERIMENTS_CONVERSION_BAG_SINK_H_

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "experiments/conversion/bag_writer.h"
#include "experiments/conversion/record_sink.h"

namespace gmapping_spa::conversion {

// Writes /scan (sensor_msgs/LaserScan), /odom (nav_msgs/Odometry) and /tf_static, with the frames
// odom, base_link and laser; each further mounting of a laser gets a frame of its own. What is read
// back is the same, but for ranges and angles, which LaserScan has as float32: beams without return
// are infinite, invalid ones nan (REP 117). The time of recording is that of the stamp.
class BagSink : public RecordSink {
 public:
  explicit BagSink(std::unique_ptr<BagWriter> writer);

  void OnScan(const sensor::ScanRecord& record) override;
  void OnOdometry(const sensor::OdometryRecord& record) override;
  void Finish() override { writer_->Finish(); }
  Losses losses() const override;

 private:
  // Its frame, which is told when it is new.
  std::string FrameOf(const backend::SE2& robot_T_laser, std::int64_t stamp_ns);

  std::unique_ptr<BagWriter> writer_;
  int tf_static_, odom_, scan_;
  std::vector<backend::SE2> mountings_;
  std::int64_t num_uneven_ = 0;
};

}  // namespace gmapping_spa::conversion

#endif  // GMAPPING_SPA_EXPERIMENTS_CONVERSION_BAG_SINK_H_
