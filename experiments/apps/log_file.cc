// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/log_file.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

#include "experiments/apps/input_file.h"
#include "frontend/sensor/open_log.h"

namespace gmapping_spa::apps {

namespace fs = std::filesystem;

namespace {

// A gzipped bag would pass for a CARMEN log without a scan. Pipes can be read only once.
void RefusePackedBag(const std::string& path) {
  if (!fs::is_regular_file(path)) return;
  std::string bytes(16, '\0');
  const std::unique_ptr<std::istream> in = OpenInput(path);
  in->read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in->gcount()));
  if (!rosbag::BeginsAsABag(bytes)) return;
  throw std::runtime_error(path +
                           ": expected a bag, found one packed by gzip: unpack it first "
                           "(gunzip)");
}

}  // namespace

LogFile OpenLogFile(const std::string& path, const sensor::LogOptions& options) {
  if (rosbag::IsBag(path)) {
    rosbag::Bag bag = rosbag::OpenBag(path, options);
    return {std::move(bag.reader), std::move(bag.report), "messages"};
  }
  RefusePackedBag(path);
  return {sensor::OpenCarmenLog(OpenInput(path), path, options), nullptr, "lines"};
}

std::int64_t ProgressTotal(const LogFile& log, const std::string& path) {
  if (log.total) return *log.total;
  if (!log.bag) {
    const std::unique_ptr<std::istream> in = OpenInput(path);
    return std::count(std::istreambuf_iterator<char>(*in), {}, '\n');
  }
  std::int64_t messages = 0;
  for (const rosbag::BagReport::Topic& topic : log.bag->topics) {
    if (!topic.used_for.empty()) messages += topic.messages;
  }
  return messages;
}

Json IdentifyLog(const std::string& path) {
  const auto identify = [](const std::string& file) -> Json {
    const FileIdentity identity = IdentifyFile(file);
    return {{"sha256", identity.sha256}, {"bytes", identity.bytes}};
  };
  if (!fs::is_directory(path)) return identify(path);
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(path)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  Json list = Json::array();
  for (const fs::path& file : files) {
    Json json = identify(file.string());
    json["name"] = file.filename().string();
    list.push_back(std::move(json));
  }
  return {{"files", list}};
}

}  // namespace gmapping_spa::apps
