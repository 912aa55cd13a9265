// SPDX-License-Identifier: BSD-3-Clause
// What is packed in a session, behind its checksum: loaded as when a run is gone on with. The first
// byte of the input chooses the session of a small run, the others change what it holds: a place (2
// bytes), a length (1 byte) and as many bytes to stand there.
#include <zstd.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "backend/spa/spa_optimizer.h"
#include "frontend/improved_gmapping.h"
#include "frontend/session/session_file.h"
#include "frontend/session/state.h"
#include "frontend/slam_parts.h"
#include "tests/fuzz/contract.h"

namespace gmapping_spa::fuzz {
namespace {

constexpr std::size_t kHeaderBytes = 4 + 4 + 8 + 8;  // frontend/session/README.md tells its fields

class Run {
 public:
  Run() { gmapping_.KeepStateOf(optimizer_); }

  frontend::ImprovedGmapping& gmapping() { return gmapping_; }

  void Drive(int scans) {
    for (const int end = next_ + scans; next_ < end; ++next_) {
      sensor::LaserScan scan;
      scan.index = next_;
      scan.stamp_s = 0.5 * next_;
      scan.has_odometry = true;
      scan.odom_T_robot = {0.1 * next_, 0.0, 0.0};
      for (int i = 0; i < 5; ++i) {
        scan.beams.push_back({0.7 * (i - 2), 2.0 - 0.1 * next_, sensor::BeamStatus::kHit});
      }
      gmapping_.AddScan(scan);
    }
  }

 private:
  // A wheel's odometry, by which two scans make a graph.
  static SlamOptions Options() {
    SlamOptions options;
    options.particles = 2;
    options.resolution_m = 0.5;
    options.odometry = SlamOptions::Odometry::kRaw;
    options.linear_update_m = 0.05;
    options.optimize_every = 2;
    return options;
  }

  int next_ = 0;
  std::shared_ptr<backend::Optimizer> optimizer_ = std::make_shared<spa::SpaOptimizer>();
  frontend::ImprovedGmapping gmapping_{frontend::GmappingOptions(Options()),
                                       frontend::MakeScanMatcher(Options()),
                                       frontend::BindOptimizer(Options(), optimizer_)};
};

// What is packed in the session of a run.
std::string ContentOf(const frontend::ImprovedGmapping& gmapping) {
  std::ostringstream out;
  session::WriteSession(
      {{.program = "1.0", .log = "log", .flags = {{"seed", "1"}}}, session::SaveState(gmapping)},
      &out);
  const std::string packed = out.str().substr(session::kMagic.size() + kHeaderBytes);
  std::uint64_t size = 0;  // the last field of the header
  out.str().copy(reinterpret_cast<char*>(&size), sizeof size,
                 session::kMagic.size() + kHeaderBytes - sizeof size);
  std::string content(size, '\0');
  ZSTD_decompress(content.data(), content.size(), packed.data(), packed.size());
  return content;
}

template <typename Number>
std::string BytesOf(Number number) {
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

std::string SessionWith(const std::string& content) {
  std::string packed(ZSTD_compressBound(content.size()), '\0');
  packed.resize(ZSTD_compress(packed.data(), packed.size(), content.data(), content.size(), 1));
  const std::string version = BytesOf(session::kSessionVersion);
  const std::string rest =
      BytesOf(std::uint64_t{packed.size()}) + BytesOf(std::uint64_t{content.size()}) + packed;
  boost::crc_32_type crc;
  crc.process_bytes(version.data(), version.size());
  crc.process_bytes(rest.data(), rest.size());
  return std::string(session::kMagic) + version + BytesOf(std::uint32_t{crc.checksum()}) + rest;
}

std::vector<std::string> Contents() {
  std::vector<std::string> contents;
  Run run;
  for (const int scans : {0, 1, 3}) {  // the last one while the graph is optimized
    run.Drive(scans);
    contents.push_back(ContentOf(run.gmapping()));
  }
  run.gmapping().BeginSession(frontend::MapSession::Use::kMapOn);
  run.Drive(2);
  contents.push_back(ContentOf(run.gmapping()));
  return contents;
}

std::string Changed(std::string content, std::string_view changes) {
  while (changes.size() > 3) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(changes[i]); };
    const std::size_t place = (byte(0) | byte(1) << 8) % content.size();
    const std::size_t size =
        std::min({std::size_t{byte(2)}, changes.size() - 3, content.size() - place});
    content.replace(place, size, changes.substr(3, size));
    changes.remove_prefix(3 + size);
  }
  return content;
}

}  // namespace
}  // namespace gmapping_spa::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gmapping_spa;
  static const std::vector<std::string> contents = fuzz::Contents();
  if (size == 0) return 0;
  std::istringstream in(fuzz::SessionWith(
      fuzz::Changed(contents[data[0] % contents.size()], fuzz::TextOf(data + 1, size - 1))));
  const bool is_changed = size > 4;
  const bool is_loaded = fuzz::ReadsOrRefuses([&] {
    fuzz::Run run;
    session::LoadState(session::ReadSession(&in, "session").state, &run.gmapping());
  });
  if (!is_changed && !is_loaded) fuzz::Break("expected a session to be loaded as it was written");
  return 0;
}
