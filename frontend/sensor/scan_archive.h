// All scans of a run in little memory.
#ifndef GMAPPING_SPA_FRONTEND_SENSOR_SCAN_ARCHIVE_H_
#define GMAPPING_SPA_FRONTEND_SENSOR_SCAN_ARCHIVE_H_

#include <cstdint>
#include <memory>
#include <vector>

#include "frontend/sensor/laser_scan.h"

namespace gmapping_spa::sensor {

// Keeps scans at 4 bytes a beam: ranges are rounded to float (4 um at 40 m), and the angles of the
// beams are kept once for all scans in succession that share them.
class ScanArchive {
 public:
  // Returns the position at which Get finds the scan: 0, 1, 2, ...
  int Add(const LaserScan& scan);

  LaserScan Get(int position) const;

  double StampOf(int position) const { return scans_.at(position).stamp_s; }
  std::int64_t IndexOf(int position) const { return scans_.at(position).index; }

  int size() const { return static_cast<int>(scans_.size()); }

 private:
  struct Entry {
    std::int64_t index;
    double stamp_s;
    backend::SE2 odom_T_robot;
    backend::SE2 robot_T_laser;
    std::shared_ptr<const std::vector<double>> angles_rad;
    std::vector<float> ranges_m;  // negative: no return up to there; 0: invalid
  };
  std::vector<Entry> scans_;
};

}  // namespace gmapping_spa::sensor

#endif  // GMAPPING_SPA_FRONTEND_SENSOR_SCAN_ARCHIVE_H_
