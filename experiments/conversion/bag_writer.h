// SPDX-License-Identifier: BSD-3-Clause
// Containers of messages, to be written.
#ifndef GMAPPING_SPA_EXPERIMENTS_CONVERSION_BAG_WRITER_H_
#define GMAPPING_SPA_EXPERIMENTS_CONVERSION_BAG_WRITER_H_

#include <cstdint>
#include <string_view>

#include "frontend/rosbag/message_source.h"

namespace gmapping_spa::conversion {

class BagWriter {
 public:
  virtual ~BagWriter() = default;
  virtual rosbag::Encoding encoding() const = 0;
  // The types are those of message_definitions.h. Returns the topic's id.
  virtual int AddTopic(std::string_view name, std::string_view type) = 0;
  virtual void Write(int topic, std::int64_t time_ns, std::string_view message) = 0;
  // After the last message.
  virtual void Finish() = 0;
};

}  // namespace gmapping_spa::conversion

#endif  // GMAPPING_SPA_EXPERIMENTS_CONVERSION_BAG_WRITER_H_
