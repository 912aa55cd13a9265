// SPDX-License-Identifier: BSD-3-Clause
// Scans and odometry of a bag.
#ifndef GMAPPING_SPA_FRONTEND_ROSBAG_BAG_READER_H_
#define GMAPPING_SPA_FRONTEND_ROSBAG_BAG_READER_H_

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "frontend/rosbag/laser_frames.h"
#include "frontend/rosbag/message_source.h"
#include "frontend/rosbag/open_bag.h"
#include "frontend/rosbag/ros_messages.h"
#include "frontend/rosbag/tf_odometry.h"
#include "frontend/rosbag/topic_choice.h"
#include "frontend/rosbag/transform_tree.h"
#include "frontend/sensor/log_options.h"
#include "frontend/sensor/log_record.h"

namespace gmapping_spa::rosbag {

// README.md of this folder tells what is read. A scan is held back until tf has told where its
// laser is mounted, for 10 s of recording at most; what comes in the meantime is held with it.
class BagReader : public sensor::RecordReader {
 public:
  // `name` stands for the bag in messages. Fills the report in.
  BagReader(std::unique_ptr<MessageSource> source, std::string name,
            const sensor::LogOptions& options, std::shared_ptr<BagReport> report);

  std::optional<sensor::LogRecord> Next() override;
  sensor::LogCounts counts() const override;

 private:
  struct Held {
    sensor::LogRecord record;
    std::string frame;  // of the scan, or whose pose the odometry tells
    std::int64_t time_ns = 0;
  };

  void BeginReport();
  // Reads a message; false at the end of the bag.
  bool Read();
  // Counts it, or throws where --bad_record=fail says so.
  void LeaveOut(const BagMessage& message, const std::string& reason);
  void Take(const BagMessage& message);
  void TakeScan(const BagMessage& message);
  void TakeOdometry(const BagMessage& message);
  void TakeTf(const BagMessage& message);
  double Stamp(const MessageHeader& header, const BagMessage& message);
  bool MayWait() const;
  // How a frame lies on the robot, by what tf has told so far.
  std::optional<Mounting> Find(const std::string& frame, bool may_assume) const;
  // Puts that into mountings_: reads on until it is known, and sticks to it unless it was assumed.
  // Whether it is new.
  bool Decide(const std::string& frame);
  void Mount(const std::string& frame, sensor::ScanRecord* record);

  std::unique_ptr<MessageSource> source_;
  std::string name_;
  sensor::LogOptions options_;
  std::shared_ptr<BagReport> report_;
  TopicChoice choice_;
  TfOdometry tf_odometry_;
  TransformTree tree_;
  LaserFrames frames_;
  std::map<std::string, Mounting> mountings_;
  std::deque<Held> held_;
  std::int64_t newest_ns_ = 0;
  std::uint64_t unpacked_bytes_ = 0;  // of messages packed by themselves
  bool at_end_ = false;

  std::int64_t num_messages_ = 0;
  std::int64_t num_scans_ = 0;
  std::int64_t num_odometry_ = 0;
  std::int64_t num_transforms_ = 0;
  std::int64_t num_malformed_ = 0;
  std::int64_t num_unstamped_ = 0;
  std::int64_t num_assumed_poses_ = 0;
  std::int64_t num_other_bases_ = 0;
  std::int64_t num_changed_poses_ = 0;
  std::int64_t num_tilted_ = 0;
  std::string first_malformed_;  // its message, until it was said
};

}  // namespace gmapping_spa::rosbag

#endif  // GMAPPING_SPA_FRONTEND_ROSBAG_BAG_READER_H_
