// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/output_files.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace gmapping_spa::apps {
namespace fs = std::filesystem;
namespace {

// A name in the folder of the final one, so that renaming never copies; the number of the process
// keeps programs apart that write to the same folder.
std::string TemporaryName(const std::string& folder, const std::string& name) {
  return fs::path(folder) / (".partial-" + std::to_string(getpid()) + "-" + name);
}

// The reason of the last failed call, if the library underneath tells one.
std::string Reason() { return errno == 0 ? "" : ": " + std::generic_category().message(errno); }

// Throws unless files can be made in the folder. Only trying tells: the super user passes every
// check of permissions, read-only and virtual file systems included.
void TryToWrite(const std::string& folder) {
  const std::string probe = TemporaryName(folder, "probe");
  errno = 0;
  const bool made = std::ofstream(probe).is_open();
  const std::string reason = Reason();
  if (!made) throw std::runtime_error("cannot write to the folder '" + folder + "'" + reason);
  std::error_code ignored;
  fs::remove(probe, ignored);
}

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

}  // namespace

OutputFiles::OutputFiles(const std::string& folder) : folder_(folder) {
  if (folder.empty()) throw std::runtime_error("the name of the output folder is empty");
  std::error_code error;
  if (!fs::is_directory(folder_, error)) {
    made_folder_ = fs::create_directories(folder_, error);
    if (error) {
      throw std::runtime_error("cannot make the folder '" + folder_ + "': " + error.message());
    }
  }
  TryToWrite(folder_);
}

OutputFiles::~OutputFiles() {
  std::error_code ignored;
  if (!committed_) {
    for (const std::string& name : names_) fs::remove(TemporaryName(folder_, name), ignored);
  }
  // Removes an empty folder only.
  if (made_folder_) fs::remove(folder_, ignored);
}

void OutputFiles::Write(const std::string& name, const std::function<void(std::ostream&)>& write) {
  std::ofstream out(TemporaryPath(name), std::ios::binary);
  errno = 0;
  if (out) write(out);
  out.close();
  if (!out) {
    throw std::runtime_error("cannot write '" + std::string(fs::path(folder_) / name) + "'" +
                             Reason());
  }
}

std::string OutputFiles::TemporaryPath(const std::string& name) {
  if (std::find(names_.begin(), names_.end(), name) == names_.end()) names_.push_back(name);
  return TemporaryName(folder_, name);
}

void OutputFiles::Commit() {
  // What can be known to fail fails before the first file is replaced.
  for (const std::string& name : names_) {
    const fs::path target = fs::path(folder_) / name;
    if (!fs::exists(TemporaryName(folder_, name)) || fs::is_directory(target)) {
      throw std::runtime_error("cannot write '" + target.string() + "'");
    }
  }
  const SignalsBlocked blocked;  // between two files, the folder would hold some of each set
  for (const std::string& name : names_) {
    const fs::path target = fs::path(folder_) / name;
    std::error_code error;
    fs::rename(TemporaryName(folder_, name), target, error);
    if (error)
      throw std::runtime_error("cannot write '" + target.string() + "': " + error.message());
  }
  committed_ = true;
}

}  // namespace gmapping_spa::apps
