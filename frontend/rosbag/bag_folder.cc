// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/bag_folder.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include "backend/text.h"
#include "frontend/rosbag/open_bag.h"
#include "frontend/rosbag/open_source.h"

namespace gmapping_spa::rosbag {
namespace {

namespace fs = std::filesystem;

// The files that metadata.yaml lists, relative to its folder or by their name alone.
std::vector<std::string> ListedFiles(const fs::path& metadata) {
  std::vector<std::string> files;
  try {
    std::ifstream in(metadata);
    const YAML::Node root = YAML::Load(in);
    const YAML::Node paths = root["rosbag2_bagfile_information"]["relative_file_paths"];
    for (const YAML::Node& path : paths) files.push_back(path.as<std::string>());
  } catch (const YAML::Exception& error) {
    const std::string line = error.mark.is_null() ? "" : ":" + std::to_string(error.mark.line + 1);
    throw std::runtime_error(
        metadata.string() + line +
        ": expected the metadata of a ROS 2 bag, found: " + backend::Printable(error.msg));
  }
  return files;
}

struct File {
  std::string path;
  std::int64_t first_ns = 0;
  std::vector<std::size_t> topics;  // of the folder, by those of the file
};

class BagFolder : public MessageSource {
 public:
  explicit BagFolder(const fs::path& folder) {
    for (const std::string& path : FindFiles(folder)) Add(path);
    if (files_.empty()) {
      throw std::runtime_error(folder.string() + ": expected a folder with a bag, found no file");
    }
    std::stable_sort(files_.begin(), files_.end(),
                     [](const File& a, const File& b) { return a.first_ns < b.first_ns; });
    contents_.format += ", " + std::to_string(files_.size()) + " files";
    Select(std::vector<bool>(contents_.topics.size(), true));
  }

  const BagContents& contents() const override { return contents_; }

  void Select(const std::vector<bool>& wanted) override {
    wanted_ = wanted;
    next_file_ = 0;
    open_.reset();
  }

  std::optional<BagMessage> Next() override {
    while (true) {
      if (open_) {
        if (std::optional<BagMessage> message = open_->Next()) {
          const File& file = files_[next_file_ - 1];
          message->topic = file.topics[message->topic];
          message->file = &file.path;
          return message;
        }
      }
      if (next_file_ == files_.size()) return std::nullopt;
      const File& file = files_[next_file_++];
      open_ = OpenSource(file.path);
      std::vector<bool> wanted;
      for (const std::size_t topic : file.topics) wanted.push_back(wanted_[topic]);
      open_->Select(wanted);
    }
  }

 private:
  std::vector<std::string> FindFiles(const fs::path& folder) {
    std::vector<std::string> found;
    if (fs::exists(folder / "metadata.yaml")) {
      for (const std::string& name : ListedFiles(folder / "metadata.yaml")) {
        // What is no name of a file is not there either.
        std::error_code ignored;
        fs::path path = folder / name;
        if (!fs::exists(path, ignored)) path = folder / fs::path(name).filename();
        if (fs::is_regular_file(path, ignored)) {
          found.push_back(path.string());
        } else {
          ++contents_.missing_files;
        }
      }
    } else {
      for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        if (entry.is_regular_file() && IsBag(entry.path().string())) {
          found.push_back(entry.path().string());
        }
      }
      std::sort(found.begin(), found.end());
    }
    return found;
  }

  void Add(const std::string& path) {
    const std::unique_ptr<MessageSource> source = OpenSource(path);
    const BagContents& part = source->contents();
    File file{path, part.first_ns, {}};
    for (const BagTopic& topic : part.topics) {
      const auto found = std::find_if(
          contents_.topics.begin(), contents_.topics.end(), [&](const BagTopic& known) {
            return known.name == topic.name && known.type == topic.type &&
                   known.encoding == topic.encoding && known.md5sum == topic.md5sum;
          });
      file.topics.push_back(static_cast<std::size_t>(found - contents_.topics.begin()));
      if (found == contents_.topics.end()) {
        contents_.topics.push_back(topic);
      } else {
        found->messages += topic.messages;
      }
    }
    contents_.format = part.format.substr(0, part.format.find(','));
    AddTimes(part);
    contents_.unclosed = contents_.unclosed || part.unclosed;
    contents_.cut_off_bytes += part.cut_off_bytes;
    contents_.bytes += part.bytes;
    files_.push_back(std::move(file));
  }

  void AddTimes(const BagContents& part) {
    // A recorder that was stopped when it had just begun a file leaves it without messages.
    if (std::ranges::none_of(part.topics, [](const auto& topic) { return topic.messages > 0; })) {
      return;
    }
    contents_.first_ns = has_times_ ? std::min(contents_.first_ns, part.first_ns) : part.first_ns;
    contents_.last_ns = has_times_ ? std::max(contents_.last_ns, part.last_ns) : part.last_ns;
    has_times_ = true;
  }

  BagContents contents_;
  bool has_times_ = false;
  std::vector<File> files_;
  std::vector<bool> wanted_;
  std::size_t next_file_ = 0;
  std::unique_ptr<MessageSource> open_;
};

}  // namespace

std::unique_ptr<MessageSource> OpenBagFolder(const std::string& folder) {
  return std::make_unique<BagFolder>(folder);
}

}  // namespace gmapping_spa::rosbag
