// Sensor logs as CARMEN text, one record a line
// (http://carmen.sourceforge.net/logger_playback.html).
#ifndef GMAPPING_SPA_EXPERIMENTS_SIMULATION_CARMEN_WRITER_H_
#define GMAPPING_SPA_EXPERIMENTS_SIMULATION_CARMEN_WRITER_H_

#include <ostream>
#include <string>
#include <vector>

#include "backend/se2.h"
#include "experiments/simulation/differential_drive.h"
#include "experiments/simulation/lidar.h"

namespace gmapping_spa::simulation {

// Both time stamps of a record are the time of measurement. Ranges are written to the millimetre.
class CarmenWriter {
 public:
  explicit CarmenWriter(std::ostream& out) : out_(out) {}

  // A line that readers skip.
  void WriteComment(const std::string& text);

  // ODOM x y theta tv rv accel ipc_timestamp ipc_hostname logger_timestamp
  void WriteOdometry(double stamp_s, const backend::SE2& odom_T_robot,
                     const BodyVelocity& velocity);

  // ROBOTLASER1 of a laser at the robot's centre, facing forward.
  void WriteScan(double stamp_s, const backend::SE2& odom_T_robot, const BodyVelocity& velocity,
                 const LidarOptions& lidar, const std::vector<double>& ranges_m);

 private:
  void WriteStamps(double stamp_s);

  std::ostream& out_;
};

}  // namespace gmapping_spa::simulation

#endif  // GMAPPING_SPA_EXPERIMENTS_SIMULATION_CARMEN_WRITER_H_
