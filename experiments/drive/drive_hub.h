// SPDX-License-Identifier: BSD-3-Clause
// Who drives and looks, and what there is to see. In the server's thread, but for the constructor.
#ifndef GMAPPING_SPA_EXPERIMENTS_DRIVE_DRIVE_HUB_H_
#define GMAPPING_SPA_EXPERIMENTS_DRIVE_DRIVE_HUB_H_

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/drive/drive_controls.h"
#include "experiments/drive/drive_state.h"
#include "experiments/view/conversation.h"
#include "experiments/view/run_state.h"

namespace gmapping_spa::drive {

class DriveHub {
 public:
  // `controls` outlives this.
  DriveHub(DriveTitle title, const map::TrinaryMap& truth, DriveControls* controls);

  // The page's. Conversations begun end before this does.
  std::vector<view::Protocol> Protocols();

  // Tell everybody what is new.
  void Apply(int run, view::Snapshot snapshot);  // of the truth, or a variant that there is
  void SetStatus(const DriveStatus& status);
  void AddVariant(int run, const VariantChoice& choice);
  void RemoveVariant(int run);
  void SetVariantState(int run, const std::string& state);
  void SetScore(int run, const MapScore& score);

 private:
  class Page;

  void Tell(const view::Messages& messages) const;
  void TellAll() const;
  view::Messages All() const;

  std::string session_;
  DriveTitle title_;
  DriveControls* controls_;
  std::map<int, view::RunState> runs_;
  VariantStatuses variants_;
  view::MessagePtr status_;  // null before the first
  std::set<Page*> pages_;
};

}  // namespace gmapping_spa::drive

#endif  // GMAPPING_SPA_EXPERIMENTS_DRIVE_DRIVE_HUB_H_
