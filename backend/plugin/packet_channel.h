// SPDX-License-Identifier: BSD-3-Clause
// Packets between two processes.
#ifndef GMAPPING_SPA_BACKEND_PLUGIN_PACKET_CHANNEL_H_
#define GMAPPING_SPA_BACKEND_PLUGIN_PACKET_CHANNEL_H_

#include <chrono>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace gmapping_spa::backend {

// The other process has ended, or has closed its end.
struct ChannelClosed : std::runtime_error {
  ChannelClosed() : std::runtime_error("the other process is gone") {}
};
struct ChannelTimeout : std::runtime_error {
  ChannelTimeout() : std::runtime_error("the other process does not answer") {}
};

// One end of a stream socket, which it owns.
class PacketChannel {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  explicit PacketChannel(int socket) : socket_(socket) {}
  ~PacketChannel();
  PacketChannel(const PacketChannel&) = delete;
  PacketChannel& operator=(const PacketChannel&) = delete;

  // Throw ChannelClosed, ChannelTimeout at the deadline, and MalformedPacket when what comes is
  // no packet or has more than max_size bytes.
  void Send(const std::vector<char>& packet, TimePoint deadline) const;
  std::vector<char> Receive(std::size_t max_size, TimePoint deadline) const;

 private:
  void ReceiveBytes(char* data, std::size_t size, TimePoint deadline) const;

  int socket_;
};

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_PLUGIN_PACKET_CHANNEL_H_
