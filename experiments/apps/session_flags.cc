// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/session_flags.h"

#include <gflags/gflags.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "experiments/apps/input_file.h"

DEFINE_string(save_session, "",
              "File for the session: the whole state of the run after the last scan, before the "
              "final optimization, also where the program is told to end. --resume goes on from "
              "it. Empty: none.");
DEFINE_double(checkpoint_every, 0.0,
              "Wall time in s, from 0, after which the session is written again and again, so that "
              "a run that is killed can go on from there (needs --save_session). Results do not "
              "depend on it. 0: only at the end.");
DEFINE_string(resume, "",
              "Session file to go on with, on the same log or one that has more scans at its end, "
              "and with the same flags. Empty: from the begin of the log.");

DEFINE_string(map_session, "",
              "Session file of another run, from another day or start, in whose map this one goes "
              "on: the robot is looked for in it, and old and new become one map. Empty: a map of "
              "its own.");
DEFINE_bool(localize, false,
            "With --map_session: leave its map as it is, and find out where in it the robot is at "
            "each scan, and how surely.");

namespace gmapping_spa::apps {

FlagGroups SessionFlagGroups() {
  return {{"session",
           "Sessions",
           {"save_session", "checkpoint_every", "resume", "map_session", "localize"}}};
}

void BeginAsFlagsSay(SlamRun* slam) {
  const auto read = [](const std::string& path) {
    return session::ReadSession(OpenInput(path).get(), path);
  };
  if (FLAGS_localize && FLAGS_map_session.empty()) {
    throw std::runtime_error("--localize needs --map_session=FILE: the map to localize in");
  }
  if (!FLAGS_resume.empty()) {
    slam->Resume(read(FLAGS_resume), FLAGS_resume);  // which knows of the map
    if (!FLAGS_map_session.empty() && !slam->gmapping().session()) {
      throw std::runtime_error(FLAGS_resume +
                               ": expected the session of a run with --map_session, " +
                               "found one that has a map of its own");
    }
  } else if (!FLAGS_map_session.empty()) {
    slam->GoOnInMapOf(
        read(FLAGS_map_session), FLAGS_map_session,
        FLAGS_localize ? frontend::MapSession::Use::kLocalize : frontend::MapSession::Use::kMapOn);
  }
}

std::unique_ptr<SessionSaver> MakeSessionSaver(SlamRun* slam) {
  const double every_s = FLAGS_checkpoint_every;
  if (!(every_s >= 0.0) || !std::isfinite(every_s)) {
    throw std::runtime_error("--checkpoint_every: expected a number from 0");
  }
  if (FLAGS_save_session.empty()) {
    if (every_s > 0.0) {
      throw std::runtime_error("--checkpoint_every needs --save_session=FILE");
    }
    return nullptr;
  }
  slam->PrepareToSave();
  return std::make_unique<SessionSaver>(
      FLAGS_save_session, every_s > 0.0 ? every_s : std::numeric_limits<double>::infinity());
}

}  // namespace gmapping_spa::apps
