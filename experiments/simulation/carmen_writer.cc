// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/carmen_writer.h"

#include <cmath>
#include <cstdint>
#include <string>

#include "backend/text.h"

namespace gmapping_spa::simulation {
namespace {

// A record, put together in memory: streams are slow, and depend on settings and locale.
class Line {
 public:
  explicit Line(const char* type) : text_(type) {}

  Line& Text(const char* text) {
    text_ += text;
    return *this;
  }

  // With so many digits after the point. The number must fit into 64 bits without the point.
  template <int kDigits>
  Line& Fixed(double value) {
    constexpr std::int64_t kPerUnit = kDigits == 3 ? 1000 : 1000000;
    static_assert(kDigits == 3 || kDigits == 6);
    const std::int64_t all = std::llround(std::abs(value) * kPerUnit);
    text_ += std::signbit(value) ? " -" : " ";
    text_ += std::to_string(all / kPerUnit);
    text_ += '.';
    const std::string fraction = std::to_string(all % kPerUnit);
    text_.append(kDigits - fraction.size(), '0');
    text_ += fraction;
    return *this;
  }

  Line& Fixed6(const backend::SE2& pose) {
    return Fixed<6>(pose.x).Fixed<6>(pose.y).Fixed<6>(pose.theta);
  }

  Line& Fixed6(const BodyVelocity& velocity) {
    return Fixed<6>(velocity.linear_m_s).Fixed<6>(velocity.angular_rad_s);
  }

  // With as many digits as it takes to read the same number again.
  Line& Exact(double value) {
    text_ += ' ';
    text_ += backend::ShortestText(value);
    return *this;
  }

  void Write(double stamp_s, std::ostream& out) {
    Fixed<6>(stamp_s).Text(" simulator").Fixed<6>(stamp_s).Text("\n");
    out.write(text_.data(), static_cast<std::streamsize>(text_.size()));
  }

 private:
  std::string text_;
};

}  // namespace

CarmenWriter::CarmenWriter(std::ostream& out) : out_(out) {
  out_ << "# CARMEN log of a simulated robot\n"
          "# ODOM x y theta tv rv accel ipc_timestamp ipc_hostname logger_timestamp\n"
          "# ROBOTLASER1 laser_type start_angle field_of_view angular_resolution maximum_range "
          "accuracy remission_mode num_readings [ranges] num_remissions [remissions] laser_x "
          "laser_y laser_theta robot_x robot_y robot_theta laser_tv laser_rv forward_safety_dist "
          "side_safety_dist turn_axis ipc_timestamp ipc_hostname logger_timestamp\n";
}

void CarmenWriter::OnOdometry(const OdometryReading& reading) {
  Line("ODOM")
      .Fixed6(reading.odom_T_robot)
      .Fixed6(reading.velocity)
      .Text(" 0")
      .Write(reading.stamp_s, out_);
}

void CarmenWriter::OnScan(const OdometryReading& odometry, const LidarOptions& lidar,
                          const std::vector<double>& ranges_m) {
  // The field of view is from the first to the last beam, all round too, so that readers that
  // divide it by the number of gaps agree with those that use the resolution.
  Line line("ROBOTLASER1 0");
  line.Exact(lidar.start_angle_rad())
      .Exact(lidar.angular_resolution_rad() * (lidar.beams - 1))
      .Exact(lidar.angular_resolution_rad())
      .Exact(lidar.max_range_m)
      .Exact(lidar.range_noise_m)
      .Text(" 0 ")
      .Text(std::to_string(ranges_m.size()).c_str());
  for (const double range_m : ranges_m) line.Fixed<3>(range_m);
  line.Text(" 0")
      .Fixed6(odometry.odom_T_robot * lidar.robot_T_laser)
      .Fixed6(odometry.odom_T_robot)
      .Fixed6(odometry.velocity)
      .Text(" 0 0 0")
      .Write(odometry.stamp_s, out_);
}

}  // namespace gmapping_spa::simulation
