// SPDX-License-Identifier: BSD-3-Clause
// Output files that appear whole or not at all.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_OUTPUT_FILES_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_OUTPUT_FILES_H_

#include <functional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "experiments/apps/staging_folder.h"

namespace gmapping_spa::apps {

// A set of files in one folder that replace their predecessors together, even when the process is
// killed (staging_folder.h). What was not committed is removed by the destructor, and so is the
// folder when this object made it and it is still empty.
class OutputFiles {
 public:
  // Makes `folder` (and its parents) if needed; throws std::runtime_error with one line when that
  // is not possible or when the folder cannot be written to: before hours of work, not after.
  explicit OutputFiles(const std::string& folder);
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  // Writes one file through a stream; throws with one line when the device is full.
  void Write(const std::string& name, const std::function<void(std::ostream&)>& write);

  // Path of a temporary file for a writer that wants a file name (PNG); it keeps the name. Throws
  // with one line, as Write does, when something other than a file has the name, such as a device.
  std::string TemporaryPath(const std::string& name);

  // Puts all files in place. Call it once.
  void Commit();

 private:
  struct Folder {
    std::string path;
    bool is_new = false;
    Folder(std::string p, bool n) : path(std::move(p)), is_new(n) {}
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
  };

  Folder folder_;  // outlives the staging folder in it
  StagingFolder staging_;
  std::vector<std::string> names_;
};

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_OUTPUT_FILES_H_
