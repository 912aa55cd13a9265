// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/tile_message.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>

namespace gmapping_spa::view {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

template <typename Number>
Number At(const Message& message, std::size_t position) {
  Number number{};
  std::memcpy(&number, message.data.data() + position, sizeof(number));
  return number;
}

TEST(TileMessages, HaveHeaderIndexAndCells) {
  TileImages tiles;
  tiles[{-3, 7}] = UnknownImage();
  tiles[{-3, 7}][5] = 42;
  const Messages messages = TileMessages(1, 2.5, tiles);
  ASSERT_THAT(messages, SizeIs(1));
  const Message& message = *messages[0];
  EXPECT_TRUE(message.is_binary);
  EXPECT_THAT(message.data, SizeIs(16 + 260));
  EXPECT_EQ(At<std::uint8_t>(message, 0), 1);
  EXPECT_EQ(At<std::uint8_t>(message, 1), 1);
  EXPECT_EQ(At<std::uint32_t>(message, 4), 1U);
  EXPECT_EQ(At<double>(message, 8), 2.5);
  EXPECT_EQ(At<std::int16_t>(message, 16), -3);
  EXPECT_EQ(At<std::int16_t>(message, 18), 7);
  EXPECT_EQ(At<std::uint8_t>(message, 20 + 5), 42);
  EXPECT_EQ(At<std::uint8_t>(message, 20 + 6), 255);
}

TEST(TileMessages, ManyTilesTakeSeveralMessagesAndNoneTakeNone) {
  TileImages tiles;
  for (int x = 0; x < 5000; ++x) tiles[{x, 0}] = UnknownImage();
  const Messages messages = TileMessages(0, 0.0, tiles);
  ASSERT_THAT(messages, SizeIs(2));
  EXPECT_EQ(At<std::uint32_t>(*messages[0], 4), 4096U);
  EXPECT_EQ(At<std::uint32_t>(*messages[1], 4), 904U);
  EXPECT_EQ(At<std::int16_t>(*messages[1], 16), 4096);
  EXPECT_THAT(TileMessages(0, 0.0, {}), IsEmpty());
}

}  // namespace
}  // namespace gmapping_spa::view
