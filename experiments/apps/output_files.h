// SPDX-License-Identifier: BSD-3-Clause
// Output files that appear whole or not at all.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_OUTPUT_FILES_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_OUTPUT_FILES_H_

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace gmapping_spa::apps {

// A set of files in one folder that replace their predecessors together. They are written under
// temporary names next to their final ones; Commit renames them. What was not committed is removed
// by the destructor, and so is the folder when this object made it and it is still empty.
class OutputFiles {
 public:
  // Makes `folder` (and its parents) if needed; throws std::runtime_error with one line when that
  // is not possible or when the folder cannot be written to: before hours of work, not after.
  explicit OutputFiles(const std::string& folder);
  ~OutputFiles();
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  // Writes one file through a stream; throws with one line when the device is full.
  void Write(const std::string& name, const std::function<void(std::ostream&)>& write);

  // Path of a temporary file for a writer that wants a file name (PNG); it keeps the extension.
  std::string TemporaryPath(const std::string& name);

  // Moves all files to their final names.
  void Commit();

 private:
  std::string folder_;
  bool made_folder_ = false;
  bool committed_ = false;
  std::vector<std::string> names_;
};

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_OUTPUT_FILES_H_
