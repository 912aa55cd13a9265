// SPDX-License-Identifier: BSD-3-Clause
// Writes sessions while a run goes on.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_SESSION_SAVER_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_SESSION_SAVER_H_

#include <chrono>
#include <future>
#include <string>

#include "frontend/session/session_file.h"

namespace gmapping_spa::apps {

// Each session replaces the one before; who kills the process gets one of the two (output_files.h).
class SessionSaver {
 public:
  // `every_s`: wall time from one checkpoint to the next, above 0; infinite: there are none. Throws
  // std::runtime_error with one line when the folder of the file cannot be written to.
  SessionSaver(const std::string& path, double every_s);

  // Whether it is time for a checkpoint, and the one before is written.
  bool IsDue() const;

  // Begins to write in a thread of its own. One that cannot be written is warned of: the run goes
  // on, and the next one may fit. Precondition: IsDue.
  void WriteCheckpoint(session::Session session);

  // Writes the last one; throws std::runtime_error with one line when that is not possible.
  void WriteLast(const session::Session& session);

 private:
  using Clock = std::chrono::steady_clock;

  void EndWriting();

  std::string path_;
  double every_s_;
  Clock::time_point latest_ = Clock::now();
  std::future<void> writing_;  // its destructor waits
};

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_SESSION_SAVER_H_
