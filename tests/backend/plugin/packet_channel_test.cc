// SPDX-License-Identifier: BSD-3-Clause
#include "backend/plugin/packet_channel.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <memory>
#include <thread>
#include <vector>

#include "backend/packet.h"

namespace gmapping_spa::backend {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kNever = Clock::time_point::max();

class PacketChannelTest : public testing::Test {
 protected:
  PacketChannelTest() {
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, sockets_.data()), 0);
    near_ = std::make_unique<PacketChannel>(sockets_[0]);
    far_ = std::make_unique<PacketChannel>(sockets_[1]);
  }
  static Clock::time_point Soon() { return Clock::now() + std::chrono::milliseconds(20); }

  std::array<int, 2> sockets_{};
  std::unique_ptr<PacketChannel> near_, far_;
};

TEST_F(PacketChannelTest, PacketsComeWholeAndInOrder) {
  std::vector<char> large(10'000'000);
  for (std::size_t k = 0; k < large.size(); ++k) large[k] = static_cast<char>(k % 251);
  const std::jthread sender([&] {
    near_->Send(large, kNever);
    near_->Send({}, kNever);
    near_->Send({'x'}, kNever);
  });
  EXPECT_EQ(far_->Receive(large.size(), kNever), large);
  EXPECT_EQ(far_->Receive(1, kNever), std::vector<char>());
  EXPECT_EQ(far_->Receive(1, kNever), std::vector<char>({'x'}));
}

TEST_F(PacketChannelTest, NobodyIsWaitedForBeyondTheDeadline) {
  EXPECT_THROW(near_->Receive(1, Soon()), ChannelTimeout);
  EXPECT_THROW(near_->Send(std::vector<char>(10'000'000), Soon()), ChannelTimeout)
      << "more than the socket holds, and nobody takes it";
}

TEST_F(PacketChannelTest, AnEndThatIsGoneIsToldFromOneThatIsSlow) {
  far_.reset();
  EXPECT_THROW(near_->Receive(1, kNever), ChannelClosed);
  EXPECT_THROW(near_->Send({'x'}, kNever), ChannelClosed);
}

TEST_F(PacketChannelTest, WhatIsNoPacketIsRefused) {
  const std::string text = "the quick brown fox";
  ASSERT_EQ(write(sockets_[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
  EXPECT_THROW(near_->Receive(1000, kNever), MalformedPacket);
}

TEST_F(PacketChannelTest, PacketsThatAreTooLargeAreRefusedBeforeMemoryIsAskedFor) {
  far_->Send({'x', 'y'}, kNever);
  EXPECT_THROW(near_->Receive(1, kNever), MalformedPacket);
}

}  // namespace
}  // namespace gmapping_spa::backend
