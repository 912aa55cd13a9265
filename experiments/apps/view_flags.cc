// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/view_flags.h"

#include <gflags/gflags.h>

#include <chrono>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "experiments/apps/app.h"
#include "experiments/apps/finished_run.h"
#include "experiments/apps/flag_checks.h"
#include "experiments/apps/server_flags.h"
#include "experiments/view/finished_view.h"

DEFINE_string(view, "",
              "Folder with the results of a run, or two with a comma between them, to show on a "
              "page; nothing else is done. Alone, or 'live' (in a --flagfile): a page that shows "
              "this run while it goes. Empty: no page.");
DEFINE_bool(view_wait, false, "With --view, waits for the first page before the first scan.");
DEFINE_bool(view_keep, false,
            "With --view, keeps the page when the results are written, until Ctrl-C.");
DEFINE_string(view_origins, "https://app.foxglove.dev,file://",
              "Origins, with commas between them, of other pages that may read the run by "
              "Foxglove's protocol; none may steer it. The default is Foxglove in a browser and as "
              "an application.");

namespace gmapping_spa::apps {
namespace {

constexpr const char* kLive = "live";
constexpr std::size_t kMaxRuns = 2;

std::vector<std::string> Words(const std::string& list) {
  std::vector<std::string> words;
  std::istringstream in(list);
  for (std::string word; std::getline(in, word, ',');) {
    if (!word.empty()) words.push_back(word);
  }
  return words;
}

view::ServerOptions ViewServerOptionsFromFlags() {
  view::ServerOptions options = ServerOptionsFromFlags();
  options.reading_origins = Words(FLAGS_view_origins);
  return options;
}

}  // namespace

FlagGroups ViewFlagGroups() {
  return {{"view",
           "Page that shows the run",
           {"view", "view_port", "view_address", "view_wait", "view_keep", "view_origins"}}};
}

void CompleteViewFlag(int argc, char** argv) {
  static char view_live[] = "--view=live";
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--view" || word == "-view") argv[i] = view_live;
  }
}

bool ViewsFinishedRuns() { return !FLAGS_view.empty() && FLAGS_view != kLive; }

void ViewFinishedRuns() {
  const std::vector<std::string> folders = Words(FLAGS_view);
  if (folders.empty() || folders.size() > kMaxRuns) {
    FailFlag("view", FLAGS_view, "expected 'live', a folder, or two with a comma between them");
  }
  std::vector<view::FinishedRun> runs;
  for (const std::string& folder : folders) runs.push_back(ReadFinishedRun(folder));
  const view::FinishedView finished_view(ViewServerOptionsFromFlags(), std::move(runs));
  SayWhereThePageIs(finished_view.port());
  while (ReceivedSignal() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(100));
}

std::unique_ptr<view::LiveView> LiveViewFromFlags(const std::string& name, double resolution_m) {
  if (FLAGS_view.empty()) {
    for (const char* flag : {"view_wait", "view_keep"}) {
      if (gflags::GetCommandLineFlagInfoOrDie(flag).current_value == "false") continue;
      throw std::runtime_error(std::string("--") + flag +
                               " needs --view: the page that it is about");
    }
    return nullptr;
  }
  auto live_view = std::make_unique<view::LiveView>(
      ViewServerOptionsFromFlags(),
      view::RunTitle{.name = std::filesystem::path(name).filename().string(),
                     .resolution_m = resolution_m},
      [] { return ReceivedSignal() != 0; });
  SayWhereThePageIs(live_view->port());
  if (FLAGS_view_wait) live_view->WaitForClient();
  return live_view;
}

void EndLiveView(view::LiveView* live_view) {
  if (FLAGS_view_keep) live_view->Keep();
  live_view->Drain();
}

}  // namespace gmapping_spa::apps
