// SPDX-License-Identifier: BSD-3-Clause
// Where the laser is mounted, as the laser poses of the scans tell it.
#ifndef GMAPPING_SPA_FRONTEND_SENSOR_LASER_MOUNTING_H_
#define GMAPPING_SPA_FRONTEND_SENSOR_LASER_MOUNTING_H_

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>

#include "frontend/sensor/log_record.h"

namespace gmapping_spa::sensor {

// FLASER and ROBOTLASER1 records have a pose of the laser beside that of the robot. In raw logs the
// one follows from the other by the mounting; in corrected logs, which are common, the laser's
// comes from a map and does not tell it, and some loggers never set it. So the first such
// records are held back and compared: where all agree on one mounting, it is used for all scans
// that have no other, else the laser is taken to be where the robot is.
//
// Held back are the records up to the 100th such scan; more, up to the 1000th, while the robot has
// turned less than 0.3 rad; none where the first laser is at the robot's pose, as in most logs.
class LaserMountingReader : public RecordReader {
 public:
  explicit LaserMountingReader(std::unique_ptr<RecordReader> source);

  std::optional<LogRecord> Next() override;
  // Those of the source, and the scans with the mounting of their laser poses
  // ("laser_pose_used") and with a laser pose that contradicts their mounting
  // ("laser_pose_mismatches").
  LogCounts counts() const override;

 private:
  // Reads on until the mounting is decided.
  void Decide();
  void Finish(ScanRecord* record);

  std::unique_ptr<RecordReader> source_;
  std::deque<LogRecord> held_;
  bool decided_ = false;
  std::optional<backend::SE2> robot_T_laser_;  // what the first laser poses agree on
  std::int64_t num_used_ = 0;
  std::int64_t num_mismatches_ = 0;
};

}  // namespace gmapping_spa::sensor

#endif  // GMAPPING_SPA_FRONTEND_SENSOR_LASER_MOUNTING_H_
