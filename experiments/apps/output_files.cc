// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/output_files.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace gmapping_spa::apps {
namespace fs = std::filesystem;
namespace {

// The reason of the last failed call, if the library underneath tells one.
std::string Reason() { return errno == 0 ? "" : ": " + std::generic_category().message(errno); }

// Returns whether the folder is new.
bool MakeFolder(const std::string& folder) {
  if (folder.empty()) throw std::runtime_error("the name of the output folder is empty");
  std::error_code error;
  if (fs::is_directory(folder, error)) return false;
  const bool made = fs::create_directories(folder, error);
  if (error) {
    throw std::runtime_error("cannot make the folder '" + folder + "': " + error.message());
  }
  return made;
}

}  // namespace

OutputFiles::Folder::~Folder() {
  std::error_code ignored;
  if (is_new) fs::remove(path, ignored);  // removes an empty folder only
}

OutputFiles::OutputFiles(const std::string& folder)
    : folder_{folder, MakeFolder(folder)}, staging_(folder) {}

void OutputFiles::Write(const std::string& name, const std::function<void(std::ostream&)>& write) {
  std::ofstream out(TemporaryPath(name), std::ios::binary);
  errno = 0;
  if (out) write(out);
  out.close();
  if (!out) {
    throw std::runtime_error("cannot write '" + (fs::path(folder_.path) / name).string() + "'" +
                             Reason());
  }
}

std::string OutputFiles::TemporaryPath(const std::string& name) {
  // What is moved over a device or a pipe would take its place.
  const fs::path path = fs::path(folder_.path) / name;
  if (fs::exists(path) && !fs::is_regular_file(path)) {
    throw std::runtime_error("cannot write '" + path.string() +
                             "': expected a regular file or none, which can be replaced");
  }
  if (std::find(names_.begin(), names_.end(), name) == names_.end()) names_.push_back(name);
  return fs::path(staging_.path()) / name;
}

void OutputFiles::Commit() {
  for (const std::string& name : names_) {
    if (!fs::exists(fs::path(staging_.path()) / name)) {
      throw std::runtime_error("cannot write '" + (fs::path(folder_.path) / name).string() + "'");
    }
  }
  staging_.Commit();
}

}  // namespace gmapping_spa::apps
