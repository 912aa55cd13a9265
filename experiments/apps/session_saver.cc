// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/session_saver.h"

#include <glog/logging.h>

#include <exception>
#include <filesystem>
#include <ostream>
#include <utility>

#include "experiments/apps/output_files.h"

namespace gmapping_spa::apps {
namespace {

std::string FolderOf(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  return folder.empty() ? "." : folder.string();
}

std::string NameOf(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

void WriteTo(const std::string& path, const session::Session& session) {
  OutputFiles files(FolderOf(path));
  files.Write(NameOf(path), [&](std::ostream& out) { session::WriteSession(session, &out); });
  files.Commit();
}

}  // namespace

SessionSaver::SessionSaver(const std::string& path, double every_s)
    : path_(path), every_s_(every_s) {
  OutputFiles fails_before_the_work_and_not_after(FolderOf(path));
  fails_before_the_work_and_not_after.TemporaryPath(NameOf(path));
}

bool SessionSaver::IsDue() const {
  if (std::chrono::duration<double>(Clock::now() - latest_).count() < every_s_) return false;
  return !writing_.valid() ||
         writing_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

void SessionSaver::WriteCheckpoint(session::Session session) {
  EndWriting();
  latest_ = Clock::now();
  writing_ = std::async(std::launch::async,
                        [path = path_, session = std::move(session)] { WriteTo(path, session); });
}

void SessionSaver::WriteLast(const session::Session& session) {
  EndWriting();
  WriteTo(path_, session);
}

void SessionSaver::EndWriting() {
  if (!writing_.valid()) return;
  try {
    writing_.get();
  } catch (const std::exception& error) {
    LOG(WARNING) << "a checkpoint is left out: " << error.what();
  }
}

}  // namespace gmapping_spa::apps
