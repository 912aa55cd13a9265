// SPDX-License-Identifier: BSD-3-Clause
// A place for the files of a test.
#ifndef GMAPPING_SPA_TESTS_TEMPORARY_FOLDER_H_
#define GMAPPING_SPA_TESTS_TEMPORARY_FOLDER_H_

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace gmapping_spa {

// A new folder, so that tests can run at the same time; it is removed with all that is in it.
class TemporaryFolder {
 public:
  TemporaryFolder() : path_(testing::TempDir() + "/gmapping_spa_test_XXXXXX") {
    if (mkdtemp(path_.data()) == nullptr) throw std::runtime_error("cannot make " + path_);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::string& path() const { return path_; }
  std::string Path(const std::string& name) const { return path_ + "/" + name; }

  // Writes a file of the folder and returns its path.
  std::string FileWith(const std::string& name, const std::string& text) const {
    std::ofstream(Path(name)) << text;
    return Path(name);
  }

 private:
  std::string path_;
};

}  // namespace gmapping_spa

#endif  // GMAPPING_SPA_TESTS_TEMPORARY_FOLDER_H_
