#include "experiments/simulation/carmen_writer.h"

#include <array>
#include <charconv>

namespace gmapping_spa::simulation {
namespace {

// Independent of the stream's settings and locale, and faster than it.
struct Fixed {
  double value;
  int digits;
};
std::ostream& operator<<(std::ostream& out, const Fixed& number) {
  std::array<char, 400> text;  // The largest double has 309 digits before the point.
  const auto result = std::to_chars(text.data(), text.data() + text.size(), number.value,
                                    std::chars_format::fixed, number.digits);
  return out.write(text.data(), result.ptr - text.data());
}

std::ostream& operator<<(std::ostream& out, const backend::SE2& pose) {
  return out << Fixed{pose.x, 6} << ' ' << Fixed{pose.y, 6} << ' ' << Fixed{pose.theta, 6};
}

std::ostream& operator<<(std::ostream& out, const BodyVelocity& velocity) {
  return out << Fixed{velocity.linear_m_s, 6} << ' ' << Fixed{velocity.angular_rad_s, 6};
}

}  // namespace

void CarmenWriter::WriteComment(const std::string& text) { out_ << "# " << text << '\n'; }

void CarmenWriter::WriteOdometry(double stamp_s, const backend::SE2& odom_T_robot,
                                 const BodyVelocity& velocity) {
  out_ << "ODOM " << odom_T_robot << ' ' << velocity << " 0";
  WriteStamps(stamp_s);
}

void CarmenWriter::WriteScan(double stamp_s, const backend::SE2& odom_T_robot,
                             const BodyVelocity& velocity, const LidarOptions& lidar,
                             const std::vector<double>& ranges_m) {
  // The field of view is from the first to the last beam, so that readers that divide it by the
  // number of gaps agree with those that use the resolution.
  out_ << "ROBOTLASER1 0 " << Fixed{lidar.start_angle_rad(), 9} << ' '
       << Fixed{lidar.angular_resolution_rad() * (lidar.beams - 1), 9} << ' '
       << Fixed{lidar.angular_resolution_rad(), 9} << ' ' << Fixed{lidar.max_range_m, 3} << ' '
       << Fixed{lidar.range_noise_m, 3} << " 0 " << ranges_m.size();
  for (const double range_m : ranges_m) out_ << ' ' << Fixed{range_m, 3};
  out_ << " 0 " << odom_T_robot << ' ' << odom_T_robot << ' ' << velocity << " 0 0 0";
  WriteStamps(stamp_s);
}

void CarmenWriter::WriteStamps(double stamp_s) {
  out_ << ' ' << Fixed{stamp_s, 6} << " simulator " << Fixed{stamp_s, 6} << '\n';
}

}  // namespace gmapping_spa::simulation
