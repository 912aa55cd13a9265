// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/topic_choice.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "backend/text.h"

namespace gmapping_spa::rosbag {
namespace {

std::string_view WithoutSlash(std::string_view name) {
  return name.starts_with('/') ? name.substr(1) : name;
}

std::string ListOf(const BagContents& contents, const std::vector<std::size_t>& topics) {
  constexpr std::size_t kMost = 12;
  std::string list;
  for (std::size_t i = 0; i < std::min(topics.size(), kMost); ++i) {
    const BagTopic& topic = contents.topics[topics[i]];
    list += (i == 0 ? "" : ", ") + backend::Quoted(topic.name) + " (" +
            std::to_string(topic.messages) + ")";
  }
  return list + (topics.size() > kMost ? ", ..." : "");
}

class Chooser {
 public:
  Chooser(const BagContents& contents, const std::string& name)
      : contents_(contents), name_(name) {}

  std::vector<std::size_t> TopicsOf(std::initializer_list<MessageType> types) const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < contents_.topics.size(); ++i) {
      const BagTopic& topic = contents_.topics[i];
      if (topic.messages > 0 && std::ranges::count(types, TypeNamed(topic.type)) > 0) {
        found.push_back(i);
      }
    }
    return found;
  }

  // Those of the name that was asked for, or of the usual one. `flag` and `what` are for messages.
  std::vector<std::size_t> Choose(const std::vector<std::size_t>& topics, const std::string& asked,
                                  std::string_view usual, const char* flag, const char* what,
                                  std::int64_t* several) const {
    if (!asked.empty()) {
      const std::vector<std::size_t> named = Named(topics, WithoutSlash(asked));
      if (!named.empty()) return named;
      throw std::runtime_error(
          name_ + ": expected " + what + " on the topic " + backend::Quoted(asked) + ", found " +
          (topics.empty() ? "none at all" : "them on " + ListOf(contents_, topics)));
    }
    if (topics.size() < 2) return topics;
    const std::vector<std::size_t> named = Named(topics, usual);
    if (named.empty()) {
      throw std::runtime_error(name_ + ": expected one topic of " + what + ", found " +
                               ListOf(contents_, topics) + ": --" + flag + " names one");
    }
    *several = static_cast<std::int64_t>(topics.size());
    return named;
  }

  void Check(std::size_t position) const {
    const BagTopic& topic = contents_.topics[position];
    const std::string what =
        name_ + ": topic " + backend::Quoted(topic.name) + ": expected " + topic.type;
    if (topic.encoding == Encoding::kUnknown) {
      throw std::runtime_error(what + " as ROS serializes it, found another encoding");
    }
    const std::string_view md5sum = Md5SumOf(TypeNamed(topic.type));
    if (!topic.md5sum.empty() && topic.md5sum != md5sum) {
      throw std::runtime_error(what + " of the MD5 sum " + std::string(md5sum) + ", found " +
                               backend::Quoted(topic.md5sum));
    }
  }

  std::vector<std::size_t> Named(const std::vector<std::size_t>& topics,
                                 std::string_view name) const {
    std::vector<std::size_t> named;
    std::ranges::copy_if(topics, std::back_inserter(named), [&](std::size_t i) {
      return WithoutSlash(contents_.topics[i].name) == name;
    });
    return named;
  }

 private:
  const BagContents& contents_;
  const std::string& name_;
};

std::string Described(const BagContents& contents) {
  std::string list;
  for (std::size_t i = 0; i < std::min<std::size_t>(contents.topics.size(), 12); ++i) {
    const BagTopic& topic = contents.topics[i];
    list += (i == 0 ? "" : ", ") + backend::Quoted(topic.name) + " (" +
            backend::Printable(topic.type) + ")";
  }
  return list.empty() ? "no topic" : list + (contents.topics.size() > 12 ? ", ..." : "");
}

}  // namespace

TopicChoice ChooseTopics(const BagContents& contents, const std::string& name,
                         const sensor::LogOptions& options) {
  const Chooser chooser(contents, name);
  TopicChoice choice;
  choice.use.resize(contents.topics.size(), MessageType::kOther);
  const auto use = [&](const std::vector<std::size_t>& topics) {
    for (const std::size_t topic : topics) {
      chooser.Check(topic);
      choice.use[topic] = TypeNamed(contents.topics[topic].type);
    }
  };
  const std::vector<std::size_t> scans =
      chooser.TopicsOf({MessageType::kLaserScan, MessageType::kMultiEchoLaserScan});
  if (scans.empty()) {
    throw std::runtime_error(name + ": no laser scans found (expected sensor_msgs/LaserScan or " +
                             "MultiEchoLaserScan, found " + Described(contents) +
                             (contents.cut_off_bytes > 0
                                  ? "; the bag is cut off: its last " +
                                        std::to_string(contents.cut_off_bytes) +
                                        " bytes are no whole record"
                                  : "") +
                             ")");
  }
  use(chooser.Choose(scans, options.scan_topic, "scan", "scan_topic", "laser scans",
                     &choice.scan_topics));
  const std::vector<std::size_t> tf = chooser.TopicsOf({MessageType::kTf});
  use(tf);
  choice.has_tf = !tf.empty();
  const std::vector<std::size_t> odometry = chooser.TopicsOf({MessageType::kOdometry});
  const std::string& asked = options.odometry_topic;
  choice.odometry_from_tf = asked.empty() ? choice.has_tf && odometry.empty()
                                          : !chooser.Named(tf, WithoutSlash(asked)).empty();
  if (!choice.odometry_from_tf) {
    use(chooser.Choose(odometry, asked, "odom", "odometry_topic", "odometry",
                       &choice.odometry_topics));
  }
  return choice;
}

}  // namespace gmapping_spa::rosbag
