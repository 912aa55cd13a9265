// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/session_log.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "backend/plugin/optimizer.h"
#include "experiments/apps/input_file.h"
#include "experiments/apps/slam_flags.h"
#include "frontend/improved_gmapping.h"
#include "frontend/session/session_file.h"
#include "frontend/session/state.h"
#include "frontend/slam_parts.h"

namespace gmapping_spa::apps {
namespace {

class SessionLog : public sensor::LogReader {
 public:
  explicit SessionLog(sensor::ScanArchive scans) : scans_(std::move(scans)) {}

  std::optional<sensor::LaserScan> Next() override {
    if (counts_["scans"] == scans_.size()) return std::nullopt;
    sensor::LaserScan scan = scans_.Measured(static_cast<int>(counts_["scans"]++));
    for (const sensor::Beam& beam : scan.beams) {
      counts_["beams_hit"] += beam.status == sensor::BeamStatus::kHit;
      counts_["beams_no_return"] += beam.status == sensor::BeamStatus::kNoReturn;
    }
    return scan;
  }

  sensor::LogCounts counts() const override { return counts_; }

 private:
  sensor::ScanArchive scans_;
  sensor::LogCounts counts_ = {{"scans", 0}, {"beams_hit", 0}, {"beams_no_return", 0}};
};

}  // namespace

bool IsSessionFile(const std::string& path) {
  if (!std::filesystem::is_regular_file(path)) return false;
  std::string bytes(session::kMagic.size(), '\0');
  OpenInput(path)->read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return bytes == session::kMagic;
}

LogFile OpenSessionLog(const std::string& path) {
  const session::Session session = session::ReadSession(OpenInput(path).get(), path);
  const SlamOptions options = SlamOptionsFromFlags();
  // No back end: what it would have to do is not asked for.
  frontend::ImprovedGmapping gmapping(frontend::GmappingOptions(options),
                                      frontend::MakeScanMatcher(options),
                                      [](backend::PoseGraph*) { return backend::Summary{}; });
  try {
    session::LoadKnown(session.state, &gmapping);
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": expected the state of a run with these flags, found one " +
                             "that does not fit: " + error.what());
  }
  if (gmapping.session()) {
    throw std::runtime_error(path +
                             ": expected a session of one log, found one that went on in the map "
                             "of another: give its logs one after another");
  }
  LogFile log;
  log.total = gmapping.scans().size();
  log.progress_count = "scans";
  log.reader = std::make_unique<SessionLog>(gmapping.scans());
  return log;
}

}  // namespace gmapping_spa::apps
