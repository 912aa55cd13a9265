// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/map/map_server_io.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "backend/out_of_memory.h"
#include "backend/text.h"
#include "frontend/map/yaml_file.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_ONLY_PNG
#define STBI_ONLY_PNM
#include <stb/stb_image.h>

namespace gmapping_spa::map {

using backend::ShortestText;

namespace {

// Farther off, coordinates of cells lose their fractions.
constexpr double kFarthestOrigin_m = 1e6;

[[noreturn]] void Fail(const std::string& path, const std::string& message) {
  throw std::runtime_error(backend::Printable(path + ": " + message));
}

std::string ReadBytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes.exceptions(std::ios::failbit);  // else want of memory passes for a file that is empty
  try {
    if (file && bytes << file.rdbuf()) return std::move(bytes).str();
  } catch (const std::ios::failure&) {
  }
  Fail(path, "expected an image, found nothing to read");
}

// One number of a PGM or PPM header, after blanks and comments, which end where stb thinks.
std::int64_t HeaderNumber(std::istream& in) {
  while ((in >> std::ws) && in.peek() == '#') {
    for (char c = '#'; in && c != '\n' && c != '\r';) in.get(c);
  }
  std::int64_t number = -1;
  in >> number;
  return number;
}

void CheckSize(const std::string& path, std::int64_t width, std::int64_t height) {
  if (width <= 0 || height <= 0 || width > kMaxMapCells / height) {
    Fail(path, "expected 1 to " + std::to_string(kMaxMapCells) + " pixels, found " +
                   std::to_string(width) + " x " + std::to_string(height));
  }
}

// stb takes a truncated PGM for a whole one, with pixels of whatever memory held, ignores the
// header's maximum value, and computes with numbers that are too large for it: all is checked here.
void CheckPnm(const std::string& path, const std::string& bytes) {
  std::istringstream in(bytes);
  in.ignore(2);
  const std::int64_t width = HeaderNumber(in), height = HeaderNumber(in),
                     maximum = HeaderNumber(in);
  CheckSize(path, width, height);
  if (maximum != 255)
    Fail(path, "expected an image of maximum value 255, found " + std::to_string(maximum));
  const std::int64_t channels = bytes[1] == '6' ? 3 : 1;
  const std::int64_t expected = width * height * channels;
  const std::int64_t found =
      static_cast<std::int64_t>(bytes.size()) - static_cast<std::int64_t>(in.tellg()) - 1;
  if (found < expected) {
    Fail(path, "expected " + std::to_string(expected) + " bytes of pixels, found " +
                   std::to_string(std::max<std::int64_t>(found, 0)));
  }
}

// Four bytes of a PNG file, the most significant first.
std::size_t BigEndian(const std::string& bytes, std::size_t position) {
  std::size_t number = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    number = number << 8 | static_cast<unsigned char>(bytes.at(position + k));
  }
  return number;
}

// A few bytes must not make stb ask for gigabytes: neither a header of more pixels than the file
// can hold (deflate makes 1032 bytes of one at most, https://zlib.net/zlib_tech.html), nor a chunk
// of more bytes than the file has.
void CheckPng(const std::string& path, const std::string& bytes, std::int64_t pixels) {
  constexpr std::size_t kBitDepth = 24;  // its place in the header
  const std::int64_t bits = bytes.size() > kBitDepth ? bytes[kBitDepth] : 0;
  if (pixels * bits / 8 / 1032 > static_cast<std::int64_t>(bytes.size())) {
    Fail(path, "expected a file as large as its " + std::to_string(pixels) +
                   " pixels can be packed into, found " + std::to_string(bytes.size()) + " bytes");
  }
  constexpr std::size_t kSignature = 8, kOverhead = 12;  // of a chunk: length, type, checksum
  for (std::size_t at = kSignature; at + 4 <= bytes.size();) {
    const std::size_t size = BigEndian(bytes, at);
    if (at + kOverhead + size > bytes.size()) {
      Fail(path, "expected an intact image, found: a chunk of " + std::to_string(size) +
                     " bytes beyond the end of the file");
    }
    if (bytes.compare(at + 4, 4, "IEND") == 0) return;  // what follows is not read
    at += kOverhead + size;
  }
}

struct Image {
  int width, height, channels;
  std::unique_ptr<stbi_uc, void (*)(void*)> pixels;  // row 0 at the top
};

Image ReadImage(const std::string& path) {
  const std::string bytes = ReadBytes(path);
  if (bytes.size() > std::numeric_limits<int>::max()) Fail(path, "expected an image below 2 GB");
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size());
  int width = 0, height = 0, channels = 0;
  const bool is_pnm = bytes.starts_with("P5") || bytes.starts_with("P6");
  if (is_pnm) CheckPnm(path, bytes);
  if (!stbi_info_from_memory(data, size, &width, &height, &channels)) {
    Fail(path, "expected a PGM or PNG image, found something else");
  }
  CheckSize(path, width, height);
  if (!is_pnm) CheckPng(path, bytes, static_cast<std::int64_t>(width) * height);
  // map_server sees grey with alpha as RGBA.
  if (channels == 2) channels = 4;
  Image image{
      width,
      height,
      channels,
      {stbi_load_from_memory(data, size, &width, &height, nullptr, channels), stbi_image_free}};
  if (!image.pixels && std::string_view(stbi_failure_reason()) == "outofmem") {
    throw backend::OutOfMemory("out of memory while reading " + path + ": " +
                               backend::MemoryOfCells(width, height, channels));
  }
  if (!image.pixels) {
    Fail(path, std::string("expected an intact image, found: ") + stbi_failure_reason());
  }
  return image;
}

double ReadThreshold(const YamlFile& yaml, const std::string& key) {
  const double threshold = yaml.Number(key);
  if (threshold < 0.0 || threshold > 1.0) {
    yaml.Fail(yaml.Get(key),
              "expected '" + key + "' from 0 to 1, found " + ShortestText(threshold));
  }
  return threshold;
}

}  // namespace

std::uint8_t PixelOf(CellState state) {
  switch (state) {
    case CellState::kFree:
      return 254;
    case CellState::kOccupied:
      return 0;
    case CellState::kUnknown:
      break;
  }
  return 205;
}

void WritePgm(const TrinaryMap& map, std::ostream& out) {
  out << "P5\n" << map.width << ' ' << map.height << "\n255\n";
  std::string line(map.width, '\0');
  for (int row = map.height - 1; row >= 0; --row) {
    for (int column = 0; column < map.width; ++column) {
      line[column] = static_cast<char>(PixelOf(map.at(column, row)));
    }
    out.write(line.data(), static_cast<std::streamsize>(line.size()));
  }
}

void WriteMapYaml(const TrinaryMap& map, const std::string& image_name, std::ostream& out) {
  out << "image: " << image_name << "\nresolution: " << ShortestText(map.resolution_m)
      << "\norigin: [" << ShortestText(map.origin_x_m) << ", " << ShortestText(map.origin_y_m)
      << ", 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
}

TrinaryMap ReadMap(const std::string& yaml_path) {
  const YamlFile yaml(yaml_path);
  TrinaryMap map;
  map.resolution_m = yaml.Number("resolution");
  if (!(map.resolution_m >= 0.001 && map.resolution_m <= 100.0)) {
    yaml.Fail(yaml.Get("resolution"),
              "expected a resolution from 0.001 to 100 m, found " + ShortestText(map.resolution_m));
  }
  const std::vector<double> origin = yaml.Numbers(yaml.Get("origin"), 3, "the origin [x, y, 0]");
  if (origin[2] != 0.0) {
    yaml.Fail(yaml.Get("origin"),
              "expected a map that is not rotated (yaw 0), found yaw " + ShortestText(origin[2]));
  }
  for (const double coordinate_m : {origin[0], origin[1]}) {
    if (!(std::abs(coordinate_m) <= kFarthestOrigin_m)) {
      yaml.Fail(yaml.Get("origin"), "expected an origin within " + ShortestText(kFarthestOrigin_m) +
                                        " m, found " + ShortestText(coordinate_m));
    }
  }
  map.origin_x_m = origin[0];
  map.origin_y_m = origin[1];
  const bool negate = yaml.Flag("negate");
  const double occupied_thresh = ReadThreshold(yaml, "occupied_thresh");
  const double free_thresh = ReadThreshold(yaml, "free_thresh");
  if (yaml.Has("mode") && yaml.String("mode") != "trinary") {
    yaml.Fail(yaml.Get("mode"), "expected the mode trinary, found '" + yaml.String("mode") + "'");
  }

  const std::filesystem::path image_path =
      std::filesystem::path(yaml_path).parent_path() / yaml.String("image");
  const Image image = ReadImage(image_path.string());
  map.width = image.width;
  map.height = image.height;
  backend::WithMemory("while reading " + yaml_path + ": " +
                          backend::MemoryOfCells(map.width, map.height, 1 + image.channels),
                      [&] { map.cells.resize(static_cast<std::size_t>(map.width) * map.height); });
  const stbi_uc* pixel = image.pixels.get();
  for (int row = map.height - 1; row >= 0; --row) {
    for (int column = 0; column < map.width; ++column) {
      // Alpha counts as a channel in trinary mode: odd, but what map_server does.
      double mean = 0.0;
      for (int channel = 0; channel < image.channels; ++channel) mean += *pixel++;
      mean /= image.channels;
      const double darkness = (negate ? mean : 255.0 - mean) / 255.0;
      map.at(column, row) = darkness > occupied_thresh ? CellState::kOccupied
                            : darkness < free_thresh   ? CellState::kFree
                                                       : CellState::kUnknown;
    }
  }
  return map;
}

}  // namespace gmapping_spa::map
