// SPDX-License-Identifier: BSD-3-Clause
// Small bags of every kind, message by message.
#ifndef GMAPPING_SPA_TESTS_FRONTEND_ROSBAG_SMALL_BAG_H_
#define GMAPPING_SPA_TESTS_FRONTEND_ROSBAG_SMALL_BAG_H_

#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "experiments/conversion/bag_writer.h"
#include "experiments/conversion/db3_writer.h"
#include "experiments/conversion/mcap_writer.h"
#include "experiments/conversion/message_bytes.h"
#include "experiments/conversion/ros1_bag_writer.h"
#include "frontend/rosbag/open_bag.h"
#include "frontend/sensor/laser_scan.h"

namespace gmapping_spa::rosbag {

inline constexpr std::int64_t kSecond_ns = 1000000000;

struct ScanFields {
  std::string frame = "laser";
  float angle_min_rad = -1.0f, angle_increment_rad = 0.5f, time_increment_s = 0.0f;
  float range_min_m = 0.1f, range_max_m = 30.0f;
  std::vector<float> ranges_m = {1.0f, 2.0f, 3.0f, 4.0f, 5.0f};
};

inline std::string ScanBytes(Encoding encoding, std::int64_t stamp_ns,
                             const ScanFields& scan = {}) {
  conversion::MessageBytes message(encoding);
  message.Header(stamp_ns, scan.frame).Put(scan.angle_min_rad).Put(0.0f);
  message.Put(scan.angle_increment_rad).Put(scan.time_increment_s).Put(0.0f);
  message.Put(scan.range_min_m).Put(scan.range_max_m).Floats(scan.ranges_m).Floats({});
  return message.bytes();
}

// Position and quaternion.
using PoseNumbers = std::vector<double>;

inline PoseNumbers Planar(double x, double y, double theta) {
  return {x, y, 0.0, 0.0, 0.0, std::sin(theta / 2.0), std::cos(theta / 2.0)};
}

inline std::string OdometryBytes(Encoding encoding, std::int64_t stamp_ns, const PoseNumbers& pose,
                                 const std::string& child = "base_link") {
  conversion::MessageBytes message(encoding);
  message.Header(stamp_ns, "odom").Text(child);
  for (const double value : pose) message.Put(value);
  for (int i = 0; i < 36 + 6 + 36; ++i) message.Put(0.0);
  return message.bytes();
}

inline std::string TfBytes(Encoding encoding, std::int64_t stamp_ns, const std::string& parent,
                           const std::string& child, const PoseNumbers& pose) {
  conversion::MessageBytes message(encoding);
  message.Put(std::uint32_t{1}).Header(stamp_ns, parent).Text(child);
  for (const double value : pose) message.Put(value);
  return message.bytes();
}

// Of one kind: "bag", "packed.bag", "mcap", "packed.mcap" or "db3".
class SmallBag {
 public:
  SmallBag(std::string path, const std::string& kind) : path_(std::move(path)) {
    const bool packs = kind.starts_with("packed");
    if (kind == "db3") {
      writer_ = conversion::MakeDb3Writer(path_);
      return;
    }
    out_.open(path_, std::ios::binary | std::ios::trunc);
    if (kind.ends_with("mcap")) {
      writer_ = std::make_unique<conversion::McapWriter>(out_, packs);
    } else {
      writer_ = std::make_unique<conversion::Ros1BagWriter>(out_, packs);
    }
  }

  Encoding encoding() const { return writer_->encoding(); }

  void Write(const std::string& topic, const std::string& type, std::int64_t time_ns,
             const std::string& message) {
    auto found = topics_.find(topic);
    if (found == topics_.end())
      found = topics_.emplace(topic, writer_->AddTopic(topic, type)).first;
    writer_->Write(found->second, time_ns, message);
  }
  void Scan(std::int64_t stamp_ns, const ScanFields& scan = {},
            const std::string& topic = "/scan") {
    Write(topic, "sensor_msgs/LaserScan", stamp_ns, ScanBytes(encoding(), stamp_ns, scan));
  }
  void Odometry(std::int64_t stamp_ns, const PoseNumbers& pose,
                const std::string& child = "base_link", const std::string& topic = "/odom") {
    Write(topic, "nav_msgs/Odometry", stamp_ns, OdometryBytes(encoding(), stamp_ns, pose, child));
  }
  void Tf(std::int64_t stamp_ns, const std::string& parent, const std::string& child,
          const PoseNumbers& pose, const std::string& topic = "/tf_static") {
    Write(topic, "tf2_msgs/TFMessage", stamp_ns,
          TfBytes(encoding(), stamp_ns, parent, child, pose));
  }

  // The path of the bag, which is closed.
  const std::string& Finish() {
    writer_->Finish();
    writer_.reset();
    out_.close();
    return path_;
  }

 private:
  std::string path_;
  std::ofstream out_;
  std::unique_ptr<conversion::BagWriter> writer_;
  std::map<std::string, int> topics_;
};

// A robot that drives along x, with its laser 0.2 m before its middle.
inline void WriteDrive(SmallBag* bag, int scans = 4) {
  bag->Tf(kSecond_ns, "base_link", "laser", Planar(0.2, 0.0, 0.0));
  for (int i = 0; i < scans; ++i) {
    const std::int64_t stamp_ns = (10 + i) * kSecond_ns;
    bag->Odometry(stamp_ns, Planar(0.5 * i, 0.0, 0.1));
    ScanFields scan;
    scan.ranges_m[0] += 0.25f * static_cast<float>(i);
    bag->Scan(stamp_ns + kSecond_ns / 2, scan);
  }
  bag->Odometry((10 + scans) * kSecond_ns, Planar(0.5 * scans, 0.0, 0.1));
}

struct ReadBag {
  std::vector<sensor::LaserScan> scans;
  sensor::LogCounts counts;
  BagReport report;
};

inline ReadBag ReadAll(const std::string& path, const sensor::LogOptions& options = {}) {
  const Bag bag = OpenBag(path, options);
  ReadBag read;
  while (std::optional<sensor::LaserScan> scan = bag.reader->Next()) {
    read.scans.push_back(std::move(*scan));
  }
  read.counts = bag.reader->counts();
  read.report = *bag.report;
  return read;
}

inline std::string BytesOf(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace gmapping_spa::rosbag

#endif  // GMAPPING_SPA_TESTS_FRONTEND_ROSBAG_SMALL_BAG_H_
