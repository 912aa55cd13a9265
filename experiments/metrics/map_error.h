// SPDX-License-Identifier: BSD-3-Clause
// The errors of a map as numbers; experiments/metrics/README.md defines them.
#ifndef GMAPPING_SPA_EXPERIMENTS_METRICS_MAP_ERROR_H_
#define GMAPPING_SPA_EXPERIMENTS_METRICS_MAP_ERROR_H_

#include <optional>

#include "experiments/metrics/map_comparison.h"
#include "experiments/metrics/statistics.h"

namespace gmapping_spa::metrics {

// A map that overlaps less than this with the truth is broken.
inline constexpr double kBrokenIou = 0.5;

// Without a value is what has nothing to be taken of.
struct MapErrors {
  // Of the occupied cells of the map.
  int occupied_cells = 0;
  std::optional<MeanAndP95> map_to_truth_m;
  std::optional<double> precision;  // part of them within one cell of the true surface
  std::optional<double> extra;      // part of them in seen free space, off every surface
  std::optional<double> outside;    // part of them where nothing could have been seen

  // Of the true surface that was in sight, by its length.
  int surface_elements = 0;
  std::optional<MeanAndP95> truth_to_map_m;
  std::optional<double> recall;   // part of it within one cell of an occupied cell
  std::optional<double> missing;  // part of it without an occupied cell within the tolerance

  // Of the bands across straight surface.
  int straight_elements = 0;
  int matched_elements = 0;  // those that have a band
  std::optional<MeanAndP95> blur_m;
  std::optional<MeanAndP95> shift_m;

  std::optional<bool> broken;   // overlaps less than kBrokenIou, or without any occupied cell
  std::optional<double> iou;    // of occupied cells and surface within one cell
  std::optional<double> known;  // part of the seen free cells
};

MapErrors SummarizeErrors(const MapComparison& comparison, double tolerance_m);

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_EXPERIMENTS_METRICS_MAP_ERROR_H_
