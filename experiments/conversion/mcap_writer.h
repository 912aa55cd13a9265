// SPDX-License-Identifier: BSD-3-Clause
// Writes MCAP with messages of ROS 2 (https://mcap.dev/spec).
#ifndef GMAPPING_SPA_EXPERIMENTS_CONVERSION_MCAP_WRITER_H_
#define GMAPPING_SPA_EXPERIMENTS_CONVERSION_MCAP_WRITER_H_

#include <map>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "experiments/conversion/bag_writer.h"

namespace gmapping_spa::conversion {

class McapWriter : public BagWriter {
 public:
  // Chunks are packed by zstd, or as they are.
  McapWriter(std::ostream& out, bool packs);

  rosbag::Encoding encoding() const override { return rosbag::Encoding::kCdr; }
  int AddTopic(std::string_view name, std::string_view type) override;
  void Write(int topic, std::int64_t time_ns, std::string_view message) override;
  void Finish() override;

 private:
  void WriteOut(const std::string& bytes);
  void FinishChunk();
  std::string Statistics() const;

  std::ostream& out_;
  bool packs_;
  std::uint64_t num_bytes_ = 0;  // written
  std::string declarations_;     // records of schemas and channels
  std::string chunk_;            // records, not packed yet
  std::int64_t first_ns_ = 0, last_ns_ = 0;
  // Of the chunk: the times and places of messages, by the topic's id.
  std::map<int, std::vector<std::pair<std::int64_t, std::uint64_t>>> index_;
  std::string chunk_indices_;  // records, for the summary
  std::uint32_t num_chunks_ = 0;
  std::vector<std::uint64_t> messages_;  // written, by the topic's id
  std::int64_t all_first_ns_ = 0, all_last_ns_ = 0;
};

}  // namespace gmapping_spa::conversion

#endif  // GMAPPING_SPA_EXPERIMENTS_CONVERSION_MCAP_WRITER_H_
