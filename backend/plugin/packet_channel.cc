// SPDX-License-Identifier: BSD-3-Clause
#include "backend/plugin/packet_channel.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <system_error>

#include "backend/packet.h"

namespace gmapping_spa::backend {
namespace {

using Clock = std::chrono::steady_clock;

struct Header {
  std::uint64_t magic;
  std::uint64_t size;
};
constexpr std::uint64_t kMagic = 0x6b6361705f617073;

// Waits until the socket can be read from or written to, or has something wrong with it.
void WaitFor(int socket, decltype(pollfd::events) events, Clock::time_point deadline) {
  for (;;) {
    int timeout_ms = -1;  // for ever
    if (deadline != Clock::time_point::max()) {
      using std::chrono::milliseconds;
      const auto left = std::chrono::ceil<milliseconds>(deadline - Clock::now());
      if (left <= milliseconds(0)) throw ChannelTimeout();
      timeout_ms = static_cast<int>(std::min<std::int64_t>(left.count(), 1'000'000));
    }
    pollfd what{socket, events, 0};
    const int count = poll(&what, 1, timeout_ms);
    if (count > 0) return;
    if (count < 0 && errno != EINTR) throw std::system_error(errno, std::generic_category());
  }
}

bool IsToRepeat(int error) { return error == EINTR || error == EAGAIN || error == EWOULDBLOCK; }

void SendBytes(int socket, const char* data, std::size_t size, Clock::time_point deadline) {
  while (size > 0) {
    WaitFor(socket, POLLOUT, deadline);
    const ssize_t sent = send(socket, data, size, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0 && !IsToRepeat(errno)) throw ChannelClosed();
    if (sent <= 0) continue;
    data += sent;
    size -= static_cast<std::size_t>(sent);
  }
}

}  // namespace

PacketChannel::~PacketChannel() { close(socket_); }

void PacketChannel::Send(const std::vector<char>& packet, TimePoint deadline) const {
  const Header header{kMagic, packet.size()};
  SendBytes(socket_, reinterpret_cast<const char*>(&header), sizeof(header), deadline);
  SendBytes(socket_, packet.data(), packet.size(), deadline);
}

void PacketChannel::ReceiveBytes(char* data, std::size_t size, TimePoint deadline) const {
  while (size > 0) {
    WaitFor(socket_, POLLIN, deadline);
    const ssize_t received = recv(socket_, data, size, MSG_DONTWAIT);
    if (received == 0 || (received < 0 && !IsToRepeat(errno))) throw ChannelClosed();
    if (received < 0) continue;
    data += received;
    size -= static_cast<std::size_t>(received);
  }
}

std::vector<char> PacketChannel::Receive(std::size_t max_size, TimePoint deadline) const {
  Header header{};
  ReceiveBytes(reinterpret_cast<char*>(&header), sizeof(header), deadline);
  if (header.magic != kMagic || header.size > max_size) {
    throw MalformedPacket("expected a packet, found something else");
  }
  std::vector<char> packet(header.size);
  ReceiveBytes(packet.data(), packet.size(), deadline);
  return packet;
}

}  // namespace gmapping_spa::backend
