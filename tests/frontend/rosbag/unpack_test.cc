// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/unpack.h"

#include <bzlib.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lz4frame.h>
#include <zstd.h>

#include "frontend/rosbag/byte_cursor.h"
#include "tests/message_of.h"

namespace gmapping_spa::rosbag {
namespace {

using ::testing::HasSubstr;

// What repeats itself, and what does not.
std::string Text() {
  std::string text;
  for (int i = 0; i < 20000; ++i) text += std::to_string(i * i % 1013) + " the same again ";
  return text;
}

std::string Packed(Packing packing, const std::string& text) {
  std::string packed(text.size() + 4096, '\0');
  std::size_t size = text.size();
  if (packing == Packing::kBz2) {
    auto length = static_cast<unsigned int>(packed.size());
    std::string copy = text;
    BZ2_bzBuffToBuffCompress(packed.data(), &length, copy.data(),
                             static_cast<unsigned int>(copy.size()), 9, 0, 0);
    size = length;
  } else if (packing == Packing::kLz4) {
    size = LZ4F_compressFrame(packed.data(), packed.size(), text.data(), text.size(), nullptr);
  } else if (packing == Packing::kZstd) {
    size = ZSTD_compress(packed.data(), packed.size(), text.data(), text.size(), 3);
  } else {
    packed = text;
  }
  packed.resize(size);
  return packed;
}

class EveryPacking : public testing::TestWithParam<Packing> {};

TEST_P(EveryPacking, GivesBackWhatWasPacked) {
  const std::string text = Text();
  EXPECT_EQ(Unpack(GetParam(), Packed(GetParam(), text), text.size(), "log", 0), text);
}

TEST_P(EveryPacking, MustHaveTheSizeThatWasTold) {
  const std::string text = Text(), packed = Packed(GetParam(), text);
  for (const std::size_t size : {text.size() - 1, text.size() + 1, std::size_t{0}}) {
    EXPECT_THROW(Unpack(GetParam(), packed, size, "log", 0), BagError) << size;
  }
  EXPECT_THAT(MessageOf([&] { Unpack(GetParam(), packed, std::uint64_t{1} << 40, "log", 77); }),
              HasSubstr("log: byte 77: expected a chunk of at most 268435456 bytes"));
}

TEST_P(EveryPacking, CutOffIsAnError) {
  const std::string text = Text(), packed = Packed(GetParam(), text);
  for (const std::size_t size : {packed.size() - 1, packed.size() / 2, std::size_t{0}}) {
    EXPECT_THROW(Unpack(GetParam(), packed.substr(0, size), text.size(), "log", 0), BagError);
  }
}

INSTANTIATE_TEST_SUITE_P(Unpack, EveryPacking,
                         testing::Values(Packing::kNone, Packing::kBz2, Packing::kLz4,
                                         Packing::kZstd));

}  // namespace
}  // namespace gmapping_spa::rosbag
