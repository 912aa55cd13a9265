// SPDX-License-Identifier: BSD-3-Clause
// Writes bags of ROS 1, format 2.0 (http://wiki.ros.org/Bags/Format/2.0).
#ifndef GMAPPING_SPA_EXPERIMENTS_CONVERSION_ROS1_BAG_WRITER_H_
#define GMAPPING_SPA_EXPERIMENTS_CONVERSION_ROS1_BAG_WRITER_H_

#include <map>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "experiments/conversion/bag_writer.h"

namespace gmapping_spa::conversion {

// Needs a stream in which it can go back, for the place of the index.
class Ros1BagWriter : public BagWriter {
 public:
  // Chunks are packed by bz2, or as they are.
  Ros1BagWriter(std::ostream& out, bool packs);

  rosbag::Encoding encoding() const override { return rosbag::Encoding::kRos1; }
  int AddTopic(std::string_view name, std::string_view type) override;
  void Write(int topic, std::int64_t time_ns, std::string_view message) override;
  void Finish() override;

 private:
  void WriteBagHeader(std::uint64_t index_byte);
  void FinishChunk();

  std::ostream& out_;
  bool packs_;
  std::vector<std::string> connections_;  // records, by the topic's id
  std::string chunk_;                     // records, not packed yet
  std::int64_t first_ns_ = 0, last_ns_ = 0;
  // Of the chunk: the times and places of messages, by the topic's id.
  std::map<int, std::vector<std::pair<std::int64_t, std::uint32_t>>> index_;
  std::string chunk_infos_;  // records, for the end of the bag
  std::uint32_t num_chunks_ = 0;
};

}  // namespace gmapping_spa::conversion

#endif  // GMAPPING_SPA_EXPERIMENTS_CONVERSION_ROS1_BAG_WRITER_H_
