// SPDX-License-Identifier: BSD-3-Clause
// Files for readers that want a path.
#ifndef GMAPPING_SPA_TESTS_FUZZ_INPUT_FOLDER_H_
#define GMAPPING_SPA_TESTS_FUZZ_INPUT_FOLDER_H_

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/fuzz/contract.h"

namespace gmapping_spa::fuzz {

// A folder of this process, removed at its end.
class InputFolder {
 public:
  InputFolder() {
    path_ = (std::filesystem::temp_directory_path() / "gmapping_spa_fuzz_XXXXXX").string();
    if (mkdtemp(path_.data()) == nullptr) Break("cannot make " + path_);
  }
  ~InputFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  InputFolder(const InputFolder&) = delete;
  InputFolder& operator=(const InputFolder&) = delete;

  const std::string& path() const { return path_; }

  // Writes a file and returns its path.
  std::string FileWith(const std::string& name, const std::string& text) const {
    std::ofstream(path_ + "/" + name, std::ios::binary) << text;
    return path_ + "/" + name;
  }

 private:
  std::string path_;
};

}  // namespace gmapping_spa::fuzz

#endif  // GMAPPING_SPA_TESTS_FUZZ_INPUT_FOLDER_H_
