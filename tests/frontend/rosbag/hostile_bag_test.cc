// SPDX-License-Identifier: BSD-3-Clause
// Damaged and hostile bags: sane scans or one line that names the place, and no more memory than
// a bag may take.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <zstd.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "frontend/rosbag/mcap_file.h"
#include "frontend/rosbag/unpack.h"
#include "tests/frontend/rosbag/small_bag.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace gmapping_spa::rosbag {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class HostileBag : public testing::TestWithParam<std::string> {
 protected:
  std::string GoodBytes(int scans = 4) {
    SmallBag bag(folder_.Path("good_" + std::to_string(scans)), GetParam());
    WriteDrive(&bag, scans);
    return BytesOf(bag.Finish());
  }
  std::string PathOf(const std::string& bytes) const { return folder_.FileWith("log", bytes); }

  void ExpectSaneScansOrOneLine(const std::string& bytes, sensor::BadRecordPolicy policy) {
    const std::string path = PathOf(bytes);
    try {
      for (const sensor::LaserScan& scan : ReadAll(path, {.bad_record = policy}).scans) {
        ASSERT_TRUE(std::isfinite(scan.stamp_s));
        ASSERT_TRUE(scan.odom_T_robot.IsFinite());
        ASSERT_TRUE(scan.robot_T_laser.IsFinite());
        ASSERT_FALSE(scan.beams.empty());
        for (const sensor::Beam& beam : scan.beams) ASSERT_TRUE(std::isfinite(beam.angle_rad));
      }
    } catch (const std::runtime_error& error) {
      const std::string message = error.what();
      ASSERT_TRUE(message.starts_with(path + ":")) << message;
      ASSERT_EQ(std::count(message.begin(), message.end(), '\n'), 0) << message;
    }
  }

  TemporaryFolder folder_;
};

TEST_P(HostileBag, CutOffAnywhereGivesSaneScansOrOneLine) {
  const std::string bytes = GoodBytes();
  const std::size_t step = bytes.size() / 101 + 1;
  for (std::size_t size = 16; size < bytes.size(); size += step) {
    ASSERT_NO_FATAL_FAILURE(
        ExpectSaneScansOrOneLine(bytes.substr(0, size), sensor::BadRecordPolicy::kSkip))
        << size;
  }
}

TEST_P(HostileBag, AnyByteReplacedGivesSaneScansOrOneLine) {
  const std::string bytes = GoodBytes(2);
  const std::size_t step = bytes.size() / 251 + 1;
  for (std::size_t i = 16; i < bytes.size(); i += step) {
    if (bytes.compare(i, 8, "        ") == 0) continue;  // room that ROS 1 leaves
    for (const char replacement : {'\0', '\x7f'}) {
      std::string damaged = bytes;
      damaged[i] = replacement;
      ASSERT_NO_FATAL_FAILURE(ExpectSaneScansOrOneLine(damaged, sensor::BadRecordPolicy::kFail))
          << "byte " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Damage, HostileBag,
                         testing::Values("bag", "packed.bag", "mcap", "packed.mcap", "db3"),
                         [](const auto& param_info) {
                           std::string name = param_info.param;
                           std::erase(name, '.');
                           return name;
                         });

class HostileBagTest : public testing::Test {
 protected:
  std::string Drive(const std::string& kind, int scans = 4) {
    SmallBag bag(folder_.Path("log"), kind);
    WriteDrive(&bag, scans);
    return bag.Finish();
  }
  std::string Rewrite(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
    return path;
  }
  std::string Replaced(const std::string& path, const std::string& old, const std::string& with) {
    std::string bytes = BytesOf(path);
    const std::size_t found = bytes.find(old);
    EXPECT_NE(found, std::string::npos);
    return Rewrite(path, bytes.replace(found, old.size(), with));
  }

  TemporaryFolder folder_;
};

TEST_F(HostileBagTest, OtherDefinitionOfAMessageIsRefused) {
  const std::string path = Drive("bag");
  std::string bytes = BytesOf(path);
  const std::string md5sum = "90c7ef2dc6895d81024acba2ac42f369";
  for (std::size_t i = bytes.find(md5sum); i != std::string::npos; i = bytes.find(md5sum, i + 1)) {
    bytes[i] = '8';
  }
  EXPECT_EQ(MessageOf([&] { ReadAll(Rewrite(path, bytes)); }),
            path + ": topic '/scan': expected sensor_msgs/LaserScan of the MD5 sum " + md5sum +
                ", found '80c7ef2dc6895d81024acba2ac42f369'");
}

TEST_F(HostileBagTest, ChunkThatLiesAboutItsSizeIsNamedByItsPlace) {
  const std::string path = Drive("packed.bag");
  const std::string bytes = BytesOf(path);
  const std::size_t size = bytes.find("size=") + 5;
  std::string larger = bytes, huge = bytes;
  larger[size + 1] = static_cast<char>(larger[size + 1] + 1);
  huge[size + 3] = '\x7f';
  EXPECT_THAT(MessageOf([&] { ReadAll(Rewrite(path, larger)); }),
              AllOf(StartsWith(path + ": byte 4117: expected a chunk that unpacks to "),
                    HasSubstr(", found ")));
  EXPECT_THAT(MessageOf([&] { ReadAll(Rewrite(path, huge)); }),
              StartsWith(path + ": byte 4117: expected a chunk of at most 268435456 bytes"));
}

TEST_F(HostileBagTest, LengthOfAnArrayIsNotBelieved) {
  for (const char* kind : {"bag", "mcap"}) {
    SmallBag bag(folder_.Path("log"), kind);
    bag.Scan(kSecond_ns);
    std::string message = ScanBytes(bag.encoding(), 2 * kSecond_ns);
    const std::string length("\x05\0\0\0", 4);
    message.replace(message.rfind(length), 4, "\xff\xff\xff\x7f");
    bag.Write("/scan", "sensor_msgs/LaserScan", 2 * kSecond_ns, message);
    const std::string path = bag.Finish();
    EXPECT_EQ(ReadAll(path).counts.at("malformed_records"), 1);
    EXPECT_THAT(MessageOf([&] { ReadAll(path, {.bad_record = sensor::BadRecordPolicy::kFail}); }),
                AllOf(StartsWith(path + ": byte "),
                      HasSubstr("topic /scan: expected 2147483647 ranges, found 24 bytes")));
  }
}

TEST_F(HostileBagTest, LoopOfTransformsIsNamed) {
  SmallBag bag(folder_.Path("log"), "mcap");
  bag.Odometry(kSecond_ns, Planar(0, 0, 0));
  bag.Tf(kSecond_ns, "laser", "mast", Planar(0, 0, 0));
  bag.Tf(kSecond_ns, "mast", "laser", Planar(0, 0, 0));
  bag.Scan(2 * kSecond_ns);
  const std::string path = bag.Finish();
  EXPECT_EQ(MessageOf([&] { ReadAll(path); }),
            path + ": expected a tree of transforms, found a loop at the frame 'laser'");
  EXPECT_EQ(ReadAll(path, {.robot_T_laser = backend::SE2{}}).scans.size(), 1u);
}

TEST_F(HostileBagTest, TransformOfAFrameToItselfIsLeftOut) {
  SmallBag bag(folder_.Path("log"), "mcap");
  bag.Odometry(kSecond_ns, Planar(0, 0, 0));
  bag.Tf(kSecond_ns, "base_link", "laser", Planar(0.5, 0, 0));
  bag.Tf(kSecond_ns, "laser", "laser", Planar(0, 0, 0));
  bag.Scan(2 * kSecond_ns);
  const std::string path = bag.Finish();
  const ReadBag read = ReadAll(path);
  EXPECT_EQ(read.counts.at("malformed_records"), 1);
  EXPECT_NEAR(read.scans.at(0).robot_T_laser.x, 0.5, 1e-9);
  EXPECT_THAT(MessageOf([&] { ReadAll(path, {.bad_record = sensor::BadRecordPolicy::kFail}); }),
              HasSubstr("found one of 'laser' to itself"));
}

// As a recorder leaves a bag behind whose battery went flat.
TEST_F(HostileBagTest, BagThatWasNotClosedIsReadAsFarAsItGoes) {
  const std::string path = Drive("bag", 8000);
  std::string bytes = BytesOf(path);
  const std::size_t index = bytes.find("index_pos=") + 10;
  bytes.replace(index, 8, std::string(8, '\0'));
  bytes.resize(bytes.size() * 3 / 4);
  Rewrite(path, bytes);
  const ReadBag read = ReadAll(path);
  EXPECT_GT(read.scans.size(), 4000u);
  EXPECT_LT(read.scans.size(), 8000u);
  EXPECT_EQ(read.counts.at("unclosed_bag"), 1);
  EXPECT_GT(read.counts.at("cut_off_bytes"), 0);
  EXPECT_THAT(MessageOf([&] { ReadAll(path, {.bad_record = sensor::BadRecordPolicy::kFail}); }),
              HasSubstr("expected a bag that was closed"));
}

TEST_F(HostileBagTest, ClosedBagThatWasCutOffIsRefused) {
  const std::string path = Drive("bag", 8000);
  const std::string bytes = BytesOf(path);
  EXPECT_THAT(MessageOf([&] { ReadAll(Rewrite(path, bytes.substr(0, bytes.size() / 2))); }),
              AllOf(StartsWith(path + ": byte 17: expected a whole bag"), HasSubstr("cut off")));
}

TEST_F(HostileBagTest, McapThatWasNotClosedIsReadAsFarAsItGoes) {
  const std::string path = Drive("packed.mcap", 8000);
  const std::string bytes = BytesOf(path);
  Rewrite(path, bytes.substr(0, bytes.size() * 3 / 4));
  const ReadBag read = ReadAll(path);
  EXPECT_GT(read.scans.size(), 2000u);
  EXPECT_LT(read.scans.size(), 8000u);
  EXPECT_EQ(read.counts.at("unclosed_bag"), 1);
}

TEST_F(HostileBagTest, DamagedChunkIsFoundOutByItsCrc) {
  const std::string path = Drive("mcap");
  EXPECT_THAT(MessageOf([&] { ReadAll(Replaced(path, "base_link", "base_lick")); }),
              HasSubstr("CRC"));
}

// 4 GB of zeros in some hundred kB, which the record says to be little.
TEST_F(HostileBagTest, BombOfZstdStaysPacked) {
  const std::string zeros(1 << 24, '\0');
  std::string bomb(ZSTD_compressBound(zeros.size()), '\0');
  bomb.resize(ZSTD_compress(bomb.data(), bomb.size(), zeros.data(), zeros.size(), 3));
  std::string packed;
  for (int i = 0; i < 256; ++i) packed += bomb;
  std::string chunk;
  for (int i = 0; i < 2; ++i) conversion::AppendNumber(kSecond_ns, &chunk);
  conversion::AppendNumber(std::uint64_t{1000}, &chunk);
  conversion::AppendNumber(std::uint32_t{0}, &chunk);
  conversion::AppendPrefixed("zstd", &chunk);
  conversion::AppendNumber(static_cast<std::uint64_t>(packed.size()), &chunk);
  chunk += packed;
  std::string bytes(kMcapMagic);
  bytes += '\x06';
  conversion::AppendNumber(static_cast<std::uint64_t>(chunk.size()), &bytes);
  const std::string path = Rewrite(folder_.Path("log"), bytes + chunk);
  EXPECT_EQ(MessageOf([&] { ReadAll(path); }),
            path +
                ": byte 8: expected a chunk that unpacks to 1000 bytes, found a larger or a "
                "damaged one");
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  EXPECT_LT(usage.ru_maxrss / 1024, 1500);  // MB, the other tests' included
}

TEST_F(HostileBagTest, NestedViewsAreNoTables) {
  const std::string path = Drive("db3");
  // Of the same length, so that the page stays whole.
  Replaced(path, "CREATE TABLE messages(", "CREATE TABLE massages(");
  EXPECT_EQ(MessageOf([&] { ReadAll(path); }).find(path), 0u);
}

}  // namespace
}  // namespace gmapping_spa::rosbag
