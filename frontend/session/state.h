// SPDX-License-Identifier: BSD-3-Clause
// The state of a run as bytes.
#ifndef GMAPPING_SPA_FRONTEND_SESSION_STATE_H_
#define GMAPPING_SPA_FRONTEND_SESSION_STATE_H_

#include <string>
#include <string_view>

#include "frontend/improved_gmapping.h"

namespace gmapping_spa::session {

// All that the scans so far have made of a run: what comes of further scans depends on it, on them
// and on the options, which are not part of it. What a back end keeps between calls is there where
// ImprovedGmapping::KeepStateOf was called. Takes some 10 ms for 10 MB.
std::string SaveState(const frontend::ImprovedGmapping& gmapping);

// Makes `state` that of `gmapping`, which was made with the options of the run that it comes from
// and has no scans yet. From there on both do the same, bit for bit. Throws std::runtime_error with
// one line when the state does not fit: `gmapping` is of no use then.
void LoadState(std::string_view state, frontend::ImprovedGmapping* gmapping);

// The same for what only its map or its scans are wanted of: the run may have had another number of
// particles. `gmapping` takes scans once its BeginSession was called.
void LoadKnown(std::string_view state, frontend::ImprovedGmapping* gmapping);

}  // namespace gmapping_spa::session

#endif  // GMAPPING_SPA_FRONTEND_SESSION_STATE_H_
