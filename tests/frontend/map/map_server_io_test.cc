// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/map/map_server_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>

namespace gmapping_spa::map {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr CellState kU = CellState::kUnknown, kF = CellState::kFree, kO = CellState::kOccupied;
constexpr const char* kKeys =
    "resolution: 0.1\norigin: [1.5, -2, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";

class MapServerIo : public testing::Test {
 protected:
  MapServerIo() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = testing::TempDir() + "map_server_io_" + test->name();
    std::filesystem::create_directories(folder_);
  }
  ~MapServerIo() override { std::filesystem::remove_all(folder_); }

  std::string Write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ + "/" + name, std::ios::binary) << text;
    return folder_ + "/" + name;
  }
  std::string WritePng(int width, int height, int channels,
                       const std::vector<std::uint8_t>& pixels) const {
    stbi_write_png((folder_ + "/map.png").c_str(), width, height, channels, pixels.data(), 0);
    return Write("map.yaml", std::string("image: map.png\n") + kKeys);
  }
  // The message that reading `yaml` gives, beside an image of one free pixel.
  std::string ErrorOf(const std::string& yaml) const {
    Write("map.pgm", "P5\n1 1\n255\n\xfe");
    const std::string path = Write("map.yaml", yaml);
    try {
      ReadMap(path);
    } catch (const std::runtime_error& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      return message.substr(folder_.size() + 1);
    }
    return "no error";
  }

  std::string folder_;
};

TEST_F(MapServerIo, RoundTripIsExact) {
  const TrinaryMap map{3, 2, 0.025, -1.0 / 3.0, 1e-17, {kF, kO, kU, kO, kU, kF}};
  std::ostringstream pgm, yaml;
  WritePgm(map, pgm);
  WriteMapYaml(map, "truth.pgm", yaml);
  Write("truth.pgm", pgm.str());
  const TrinaryMap back = ReadMap(Write("truth.yaml", yaml.str()));
  EXPECT_EQ(back.width, 3);
  EXPECT_EQ(back.height, 2);
  EXPECT_EQ(back.resolution_m, map.resolution_m);
  EXPECT_EQ(back.origin_x_m, map.origin_x_m);
  EXPECT_EQ(back.origin_y_m, map.origin_y_m);
  EXPECT_EQ(back.cells, map.cells);
}

TEST_F(MapServerIo, FirstLineOfTheImageIsTheTop) {
  std::ostringstream pgm;
  WritePgm({2, 2, 0.05, 0.0, 0.0, {kF, kO, kU, kU}}, pgm);
  EXPECT_EQ(pgm.str(), std::string("P5\n2 2\n255\n\xcd\xcd\xfe\0", 15));
}

TEST_F(MapServerIo, ReadsTheCommentOfRosMapSaver) {
  Write("map.pgm", "P5\n# CREATOR: map_saver.cpp 0.050 m/pix\n2 1\n255\n\xfe\xcd");
  const TrinaryMap map = ReadMap(Write("map.yaml", std::string("image: map.pgm\n") + kKeys));
  EXPECT_THAT(map.cells, testing::ElementsAre(kF, kU));
  EXPECT_EQ(map.origin_x_m, 1.5);
  EXPECT_EQ(map.origin_y_m, -2.0);
  EXPECT_EQ(map.resolution_m, 0.1);
}

TEST_F(MapServerIo, ThresholdsAreStrict) {
  // Darkness 0.2, 0.6 and 0.8.
  Write("map.pgm", std::string("P5\n3 1\n255\n") + "\xcc\x66\x33");
  const TrinaryMap map = ReadMap(Write("map.yaml",
                                       "image: map.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: "
                                       "0\noccupied_thresh: 0.6\nfree_thresh: 0.2\n"));
  EXPECT_THAT(map.cells, testing::ElementsAre(kU, kU, kO));
}

TEST_F(MapServerIo, NegateMakesWhiteOccupied) {
  Write("map.pgm", std::string("P5\n2 1\n255\n\xff\0", 13));
  const TrinaryMap map = ReadMap(Write("map.yaml",
                                       "image: map.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: "
                                       "1\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"));
  EXPECT_THAT(map.cells, testing::ElementsAre(kO, kF));
}

TEST_F(MapServerIo, NegateMayBeABooleanAsNav2WritesIt) {
  Write("map.pgm", std::string("P5\n2 1\n255\n\xff\0", 13));
  for (const auto& [negate, first] :
       {std::pair("false", kF), std::pair("True", kO), std::pair("no", kF), std::pair("1", kO)}) {
    const TrinaryMap map = ReadMap(
        Write("map.yaml",
              std::string("\xef\xbb\xbfimage: map.pgm\nresolution: 1\norigin: [0, 0, 0.0]\n") +
                  "negate: " + negate + "\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"));
    EXPECT_EQ(map.cells.at(0), first) << negate;
  }
}

TEST_F(MapServerIo, ReadsPngOfAnyChannels) {
  EXPECT_THAT(ReadMap(WritePng(3, 1, 1, {0, 205, 254})).cells, testing::ElementsAre(kO, kU, kF));
  // Channels are averaged: 85 gives darkness 2/3.
  EXPECT_THAT(ReadMap(WritePng(2, 1, 3, {255, 0, 0, 255, 255, 250})).cells,
              testing::ElementsAre(kO, kF));
  // As in map_server, alpha is one of them: a transparent black pixel is occupied, an opaque one
  // has darkness 0.75 and a transparent white one 0.25.
  EXPECT_THAT(ReadMap(WritePng(3, 1, 4, {0, 0, 0, 0, 0, 0, 0, 255, 255, 255, 255, 0})).cells,
              testing::ElementsAre(kO, kO, kU));
  EXPECT_THAT(ReadMap(WritePng(2, 1, 2, {0, 255, 255, 0})).cells, testing::ElementsAre(kO, kU));
}

TEST_F(MapServerIo, NamesFileAndLineOfABadKey) {
  const std::string image = "image: map.pgm\n", keys = kKeys;
  ASSERT_EQ(ErrorOf(image + keys), "no error");
  ASSERT_EQ(ErrorOf(image + "mode: trinary\n" + keys), "no error");
  EXPECT_EQ(ErrorOf(keys), "map.yaml: expected the key 'image', found none");
  EXPECT_EQ(ErrorOf("image: no.pgm\n" + keys), "no.pgm: expected an image, found nothing to read");
  EXPECT_THAT(ErrorOf("mode: scale\n" + image + keys), StartsWith("map.yaml:1: "));
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = image + keys;
    return ErrorOf(text.replace(text.find(from), from.size(), to));
  };
  for (const char* resolution : {"-1", "0", "1e-4", "1e5"}) {
    EXPECT_THAT(with("0.1", resolution),
                HasSubstr("map.yaml:2: expected a resolution from 0.001 to 100 m, found"));
  }
  EXPECT_THAT(with("[1.5, -2, 0]", "[1.5, -1e8, 0]"),
              HasSubstr("map.yaml:3: expected an origin within 1e+06 m, found -1e+08"));
  EXPECT_EQ(with("0.1", "fine"), "map.yaml:2: expected a number for 'resolution', found 'fine'");
  EXPECT_THAT(with("0.1", ".nan"), StartsWith("map.yaml:2: expected a number"));
  EXPECT_EQ(with("-2, 0", "-2"), "map.yaml:3: expected the origin [x, y, 0], found a list of 2");
  EXPECT_THAT(with("-2, 0", "-2, 0.1"), HasSubstr("yaw 0.1"));
  EXPECT_THAT(with("negate: 0", "negate: 2"), StartsWith("map.yaml:4: "));
  EXPECT_THAT(with("0.65", "65"), StartsWith("map.yaml:5: "));
  EXPECT_THAT(with("0.65", "[0.65"), HasSubstr("expected YAML"));
}

TEST_F(MapServerIo, RefusesBrokenImages) {
  const auto error_of = [this](const std::string& image) {
    Write("bad.pgm", image);
    return ErrorOf(std::string("image: bad.pgm\n") + kKeys);
  };
  EXPECT_THAT(error_of(""), HasSubstr("found nothing to read"));
  EXPECT_THAT(error_of("P2\n1 1\n255\n0"), HasSubstr("expected a PGM or PNG image"));
  EXPECT_EQ(error_of("P5\n2 2\n255\n\x01\x01\x01"), "bad.pgm: expected 4 bytes of pixels, found 3");
  EXPECT_THAT(error_of("P5\n2 2\n15\n\x01\x01\x01\x01"), HasSubstr("maximum value 255, found 15"));
  EXPECT_THAT(error_of("P5\n100000 100000\n255\n"), HasSubstr("100000 x 100000"));
  EXPECT_THAT(error_of("P5\n0 1\n255\n"), HasSubstr("pixels, found 0 x 1"));
  WritePng(40, 40, 1, std::vector<std::uint8_t>(1600, 7));
  std::filesystem::resize_file(folder_ + "/map.png", 50);
  EXPECT_THAT(ErrorOf(std::string("image: map.png\n") + kKeys), HasSubstr("intact image"));
}

TEST_F(MapServerIo, RefusesAYamlFileWithoutKeys) {
  EXPECT_THROW(ReadMap(folder_ + "/none.yaml"), std::runtime_error);
  EXPECT_THAT(ErrorOf(""), HasSubstr("found nothing to read"));
  EXPECT_EQ(ErrorOf("- image\n"), "map.yaml:1: expected a table of keys, found a list of 1");
}

}  // namespace
}  // namespace gmapping_spa::map
