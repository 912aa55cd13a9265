// SPDX-License-Identifier: BSD-3-Clause
// The files of a tour that somebody drove.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_DRIVE_RECORD_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_DRIVE_RECORD_H_

#include <string>

#include "experiments/apps/simulation_flags.h"
#include "experiments/drive/drive_session.h"

namespace gmapping_spa::apps {

// Writes what simulate writes of the tour, commands.csv, and of each result variant_<run>.tum,
// variant_<run>.pgm and .yaml; drive.json says which is which. Those of an earlier save with more
// results go. Throws std::runtime_error with one line. Returns one line for people.
std::string WriteDrive(const SimulationSetup& setup, const drive::DriveSession& session,
                       const drive::VariantResults& results, double occupied_threshold,
                       const std::string& folder);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_DRIVE_RECORD_H_
