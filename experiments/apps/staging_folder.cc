// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/staging_folder.h"

#include <fcntl.h>
#include <glog/logging.h>
#include <stdlib.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <vector>

namespace gmapping_spa::apps {
namespace fs = std::filesystem;
namespace {

constexpr char kStagingPrefix[] = ".gmapping_spa-partial-";
constexpr char kCommitName[] = ".gmapping_spa-commit";

[[noreturn]] void Fail(const std::string& what, const std::error_code& error) {
  throw std::runtime_error(what + ": " + error.message());
}

std::error_code LastError() { return {errno, std::generic_category()}; }

// SIGINT and SIGTERM wait for its end.
class SignalsBlocked {
 public:
  SignalsBlocked() {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &signals, &before_);
  }
  ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  sigset_t before_;
};

int OpenFolder(const std::string& folder) {
  return open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
}

// Holds off other processes that commit or complete a set here, until its end or that of the
// process. Where the file system has no locks, it is the user who must not run two at once.
class FolderLocked {
 public:
  explicit FolderLocked(const std::string& folder) : descriptor_(OpenFolder(folder)) {
    if (descriptor_ >= 0) flock(descriptor_, LOCK_EX);
  }
  ~FolderLocked() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  FolderLocked(const FolderLocked&) = delete;
  FolderLocked& operator=(const FolderLocked&) = delete;

 private:
  int descriptor_;
};

std::vector<std::string> NamesIn(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    names.push_back(entry.path().filename().string());
  }
  if (error) Fail("cannot read the folder '" + folder.string() + "'", error);
  return names;
}

// Moves all that the folder of a commit holds. It can be called again, wherever it ended.
void MoveIntoPlace(const fs::path& folder) {
  const fs::path commit = folder / kCommitName;
  const std::vector<std::string> names = NamesIn(commit);
  std::error_code error;
  // A single file replaces its predecessor in one step.
  for (std::size_t k = 0; names.size() > 1 && k < names.size(); ++k) {
    fs::remove(folder / names[k], error);
    if (error) Fail("cannot write '" + (folder / names[k]).string() + "'", error);
  }
  for (const std::string& name : names) {
    fs::rename(commit / name, folder / name, error);
    if (error) Fail("cannot write '" + (folder / name).string() + "'", error);
  }
  fs::remove(commit, error);
}

// With the folder locked.
void CompleteSetLocked(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::is_directory(folder / kCommitName, ignored)) return;
  MoveIntoPlace(folder);
  LOG(WARNING) << folder.string()
               << ": completed the files of a run that was killed when it put them in place";
}

// With the folder locked. A process that is alive holds the lock of its folder.
void RemoveAbandoned(const fs::path& folder) {
  for (const std::string& name : NamesIn(folder)) {
    if (!name.starts_with(kStagingPrefix)) continue;
    const fs::path path = folder / name;
    const int descriptor = OpenFolder(path.string());
    if (descriptor < 0) continue;
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) {
      const std::size_t count = NamesIn(path).size();
      std::error_code error;
      fs::remove_all(path, error);
      LOG_IF(WARNING, count > 0 || error)
          << folder.string() << ": " << (error ? "cannot remove " : "removed ") << count
          << " unfinished files of a run that was killed";
    }
    close(descriptor);
  }
}

// What cannot reach the device must fail while the old set counts.
void Flush(const fs::path& file) {
  const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  const bool flushed = descriptor >= 0 && fsync(descriptor) == 0;
  const std::error_code error = LastError();
  if (descriptor >= 0) close(descriptor);
  if (!flushed) Fail("cannot write '" + file.filename().string() + "'", error);
}

}  // namespace

void CompleteSet(const std::string& folder) {
  std::error_code ignored;
  if (!fs::is_directory(fs::path(folder) / kCommitName, ignored)) return;
  const FolderLocked locked(folder);
  CompleteSetLocked(folder);
}

void CompleteSetOf(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  CompleteSet(folder.empty() ? "." : folder.string());
}

StagingFolder::StagingFolder(const std::string& folder)
    : folder_(folder), path_(folder + "/" + kStagingPrefix + "XXXXXX") {
  const FolderLocked locked(folder);
  CompleteSetLocked(folder);
  // Only trying tells: the super user passes every check of permissions, read-only and virtual file
  // systems included.
  if (mkdtemp(path_.data()) == nullptr) {
    Fail("cannot write to the folder '" + folder + "'", LastError());
  }
  lock_ = OpenFolder(path_);
  if (lock_ >= 0) flock(lock_, LOCK_EX);
  RemoveAbandoned(folder);
}

StagingFolder::~StagingFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  if (lock_ >= 0) close(lock_);
}

void StagingFolder::Commit() {
  for (const std::string& name : NamesIn(path_)) {
    Flush(fs::path(path_) / name);
    // A folder in the way fails before the first file is replaced.
    if (fs::is_directory(fs::path(folder_) / name)) {
      Fail("cannot write '" + (fs::path(folder_) / name).string() + "'",
           std::make_error_code(std::errc::is_a_directory));
    }
  }
  const SignalsBlocked blocked;
  const FolderLocked locked(folder_);
  CompleteSetLocked(folder_);  // of another process, killed since
  std::error_code error;
  fs::rename(path_, fs::path(folder_) / kCommitName, error);
  if (error) Fail("cannot write to the folder '" + folder_ + "'", error);
  MoveIntoPlace(folder_);
}

}  // namespace gmapping_spa::apps
