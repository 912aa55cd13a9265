// SPDX-License-Identifier: BSD-3-Clause
// What the page is told, as JSON, besides the runs, which are those of the live view.
#ifndef GMAPPING_SPA_EXPERIMENTS_DRIVE_DRIVE_MESSAGES_H_
#define GMAPPING_SPA_EXPERIMENTS_DRIVE_DRIVE_MESSAGES_H_

#include <string>
#include <string_view>

#include "experiments/drive/drive_controls.h"
#include "experiments/drive/drive_state.h"
#include "experiments/view/message.h"

namespace gmapping_spa::drive {

// All that was before is void. `session` is another text for each start of the program.
view::MessagePtr HelloMessage(const std::string& session, const DriveTitle& title,
                              const VariantStatuses& variants);
view::MessagePtr StatusMessage(const DriveStatus& status);
view::MessagePtr VariantsMessage(const VariantStatuses& variants);
// Stamp, ATE and IoU of a variant so far.
view::MessagePtr ScoresMessage(int run, const VariantStatus& variant);

std::string NameOf(const VariantChoice& choice);

// Takes over what a page says; README.md lists it. Throws std::runtime_error with one line on
// anything else.
void TakeWish(std::string_view data, bool is_binary, const DriveTitle& title,
              DriveControls* controls);

}  // namespace gmapping_spa::drive

#endif  // GMAPPING_SPA_EXPERIMENTS_DRIVE_DRIVE_MESSAGES_H_
