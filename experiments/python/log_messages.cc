// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/python/log_messages.h"

#include <glog/logging.h>
#include <pybind11/pybind11.h>

#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace gmapping_spa::python {
namespace {

namespace py = pybind11;

struct Message {
  google::LogSeverity severity;
  std::string text;
};

class MessageKeeper : public google::LogSink {
 public:
  void send(google::LogSeverity severity, const char* /*path*/, const char* /*file*/, int /*line*/,
            const google::LogMessageTime& /*time*/, const char* message,
            std::size_t length) override {
    const std::lock_guard lock(mutex_);
    messages_.push_back({severity, std::string(message, length)});
  }

  std::vector<Message> Take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(messages_, {});
  }

 private:
  std::mutex mutex_;
  std::vector<Message> messages_;
};

// Never destroyed: a thread may still warn at the end of the process.
MessageKeeper& Keeper() {
  static auto& keeper = *new MessageKeeper;
  return keeper;
}

}  // namespace

void CollectLogMessages() {
  if (!google::IsGoogleLoggingInitialized()) google::InitGoogleLogging("gmapping_spa");
  FLAGS_minloglevel = google::GLOG_WARNING;
  FLAGS_stderrthreshold = google::GLOG_FATAL;
  for (const int severity :
       {google::GLOG_INFO, google::GLOG_WARNING, google::GLOG_ERROR, google::GLOG_FATAL}) {
    google::SetLogDestination(severity, "");
  }
  google::AddLogSink(&Keeper());
}

void HandOnLogMessages() {
  const std::vector<Message> messages = Keeper().Take();
  if (messages.empty()) return;
  const py::object logger = py::module_::import("logging").attr("getLogger")("gmapping_spa");
  for (const Message& message : messages) {
    const char* const method = message.severity == google::GLOG_WARNING ? "warning" : "error";
    const std::string& text = message.text;
    logger.attr(method)("%s", py::reinterpret_steal<py::str>(PyUnicode_DecodeUTF8(
                                  text.data(), static_cast<Py_ssize_t>(text.size()), "replace")));
  }
}

}  // namespace gmapping_spa::python
