// SPDX-License-Identifier: BSD-3-Clause
// Replacing a set of files in a folder so that whoever kills the process gets the old or the new
// one.
//
// Files are written in a hidden folder inside of theirs, which a lock marks as alive. Renaming it
// to kCommitName is the one step that decides: before it the old set counts, after it the new one,
// whose files have only to be moved into place. Old files go before the first new one comes, so
// that at no moment there are some of each. What a killed process leaves of either kind, the next
// one finds.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_STAGING_FOLDER_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_STAGING_FOLDER_H_

#include <string>

namespace gmapping_spa::apps {

// Moves the rest of a set into place whose process was killed on the way, and says so on the log.
// Throws std::runtime_error with one line when files
// cannot be moved; nothing happens where there is no such set, or no folder.
void CompleteSet(const std::string& folder);
// Likewise with the folder of a file that is to be read.
void CompleteSetOf(const std::string& path);

class StagingFolder {
 public:
  // Completes the set in `folder`, removes what killed processes left of their own hidden folders,
  // which it says on the log, and makes a new one. Throws std::runtime_error with one line when the
  // folder cannot be written to.
  explicit StagingFolder(const std::string& folder);
  // What was not committed is removed.
  ~StagingFolder();
  StagingFolder(const StagingFolder&) = delete;
  StagingFolder& operator=(const StagingFolder&) = delete;

  const std::string& path() const { return path_; }

  // All files in path() replace those of their names. Throws std::runtime_error with one line:
  // until the deciding step with the old set as it was; after it, CompleteSet makes up for the
  // rest.
  void Commit();

 private:
  std::string folder_;
  std::string path_;
  int lock_ = -1;  // file descriptor
};

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_STAGING_FOLDER_H_
