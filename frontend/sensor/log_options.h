// SPDX-License-Identifier: BSD-3-Clause
// How a sensor log is read.
#ifndef GMAPPING_SPA_FRONTEND_SENSOR_LOG_OPTIONS_H_
#define GMAPPING_SPA_FRONTEND_SENSOR_LOG_OPTIONS_H_

#include <optional>
#include <string>

#include "backend/se2.h"

namespace gmapping_spa::sensor {

// What happens to a record that cannot be taken as it stands (see README.md of this folder).
enum class BadRecordPolicy {
  kSkip,  // go on, and count it; only what cannot be read at all is left out
  kFail,  // stop with an error that names the line
};

struct LogOptions {
  double usable_range_m = 40.0;  // a reading this long or longer is no return
  double range_min_m = 0.05;     // a reading shorter than this is invalid

  // Geometry of the laser; each overrides what the log says.
  std::optional<double> fov_rad = std::nullopt;  // angle from the first beam to the last one
  std::optional<double> angle_min_rad =
      std::nullopt;  // angle of the first beam; -fov_rad / 2 if only that is set
  std::optional<backend::SE2> robot_T_laser = std::nullopt;
  bool flipped = false;  // mounted upside down: beam angles change their sign

  double reorder_window_s = 2.0;  // disorder of stamps up to this is mended
  double gap_s = 5.0;             // scans further apart than this have a gap between them
  BadRecordPolicy bad_record = BadRecordPolicy::kSkip;

  // Of bags; each may be left empty. Topics are found by their type, and may be named where several
  // have scans or odometry; a topic of transforms as the one of odometry takes it from tf.
  std::string scan_topic = {}, odometry_topic = {};
  // Frames: of the robot (that of the odometry by default), and of the odometry that tf tells (by
  // default "odom" or one with that in its name).
  std::string base_frame = {}, odom_frame = {};
};

}  // namespace gmapping_spa::sensor

#endif  // GMAPPING_SPA_FRONTEND_SENSOR_LOG_OPTIONS_H_
