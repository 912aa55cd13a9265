// SPDX-License-Identifier: BSD-3-Clause
// A run of SLAM as flags describe it, from the first scan to the files of results.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_SLAM_RUN_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_SLAM_RUN_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "backend/plugin/optimizer.h"
#include "experiments/apps/json.h"
#include "experiments/apps/output_files.h"
#include "experiments/apps/run_record.h"
#include "experiments/view/slam_observer.h"
#include "frontend/api/slam_options.h"
#include "frontend/improved_gmapping.h"
#include "frontend/sensor/laser_scan.h"
#include "frontend/sensor/log_reader.h"
#include "frontend/session/session_file.h"

namespace gmapping_spa::apps {

class SlamRun {
 public:
  // Throws std::runtime_error with one line when a flag makes no sense.
  SlamRun();

  // Tells `observer`, which outlives this or is null, how it goes.
  void SetObserver(view::SlamObserver* observer) { observer_ = observer; }

  // Goes on with a session; `name` is for messages. From now on the scans that it has taken are
  // compared with those that AddScan is given, and nothing else is done with them. Throws
  // std::runtime_error with one line when the session has other flags or does not fit. Call it
  // before AddScan.
  void Resume(const session::Session& session, const std::string& name);
  // Whether AddScan has not yet been given all scans that the session has taken.
  bool CatchesUp() const { return given_scans_ < resumed_scans_; }
  // To be called after the last scan: throws std::runtime_error with one line when it catches up.
  void CheckThatSessionEnded() const;

  // Goes on in the map of a session: scans to come are of another log, and all flags but the size
  // of cells may be others. Throws std::runtime_error with one line when the session has no scans,
  // cells of another size or does not fit. Call it before AddScan.
  void GoOnInMapOf(const session::Session& session, const std::string& name,
                   frontend::MapSession::Use use);

  // For the last line to the user: "; found in the old map after 1.5 s"; empty without an old map.
  std::string WordsOnLocalization() const;

  // Call it before AddScan where sessions will be saved. Warns where those that go on with them may
  // end with other bytes.
  void PrepareToSave();
  // What there is now, of scans out of `log`.
  session::Session MakeSession(const std::string& log) const;

  // Throws std::runtime_error with one line when the scan is not the one that the session has
  // taken.
  void AddScan(const sensor::LaserScan& scan);

  // After the last scan, or the last one before the process received a signal: then results are
  // those of the scans so far, without the final optimization, and the record says so. Writes
  // the files of result_files.h, loop_closures.csv and run.json, where the robot is localized in a
  // map localization.csv, too, and warns of what was noticed. `input` tells for the record what the
  // scans were made of; `log_counts` are those of the log's reader, empty where there is none.
  // Returns whether the results are those of all scans. Throws
  // std::runtime_error with one line where the map would be empty.
  bool Finish(const std::function<Json()>& input, const sensor::LogCounts& log_counts,
              OutputFiles* files);

  // Takes over the state of a session that was made with the flags of this program, to edit it; no
  // scans are asked for again, and the back end may be another one. Throws std::runtime_error with
  // one line when it does not fit.
  void Load(const session::Session& session, const std::string& name);
  frontend::ImprovedGmapping& gmapping() { return gmapping_; }
  // Writes the files of Finish of closures that were edited (ImprovedGmapping::FinishEdited);
  // `edits` tells the record how.
  void FinishEdited(const Json& input, const Json& edits, int refine, OutputFiles* files);

  const frontend::ImprovedGmapping::Counts& counts() const { return gmapping_.counts(); }
  // To look at while scans come.
  const frontend::ImprovedGmapping& gmapping() const { return gmapping_; }

 private:
  explicit SlamRun(const SlamOptions& options);
  using LoadFunction = void(std::string_view state, frontend::ImprovedGmapping* gmapping);
  void LoadBy(LoadFunction* load, const session::Session& session, const std::string& name);
  backend::Trajectory OfThisLog(const frontend::SlamResult& result) const;
  bool WriteResults(const std::function<Json()>& input, const sensor::LogCounts& log_counts,
                    OutputFiles* files);
  // All but run.json, of which the record is returned.
  Json WriteEstimate(const frontend::SlamResult& estimate, const std::function<Json()>& input,
                     const sensor::LogCounts& log_counts, OutputFiles* files);

  double occupied_threshold_;
  bool is_async_;
  std::shared_ptr<backend::Optimizer> optimizer_;
  frontend::ImprovedGmapping gmapping_;
  Stopwatch stopwatch_;
  view::SlamObserver* observer_ = nullptr;
  std::string session_name_;
  std::int64_t resumed_scans_ = 0;
  std::int64_t given_scans_ = 0;
};

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_SLAM_RUN_H_
