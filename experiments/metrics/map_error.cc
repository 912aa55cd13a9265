// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/map_error.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace gmapping_spa::metrics {
namespace {

std::optional<double> Part(std::ptrdiff_t part, std::size_t whole) {
  if (whole == 0) return std::nullopt;
  return static_cast<double>(part) / static_cast<double>(whole);
}

// Part of the items with distance_m up to `limit_m`.
template <typename Item>
std::optional<double> PartWithin(const std::vector<Item>& items, double limit_m) {
  return Part(std::count_if(items.begin(), items.end(),
                            [&](const Item& item) { return IsWithin(item.distance_m, limit_m); }),
              items.size());
}

template <typename Item>
std::optional<MeanAndP95> Distances(const std::vector<Item>& items) {
  std::vector<double> distances;
  for (const Item& item : items) distances.push_back(item.distance_m);
  return ComputeMeanAndP95(std::move(distances));
}

// With p = tp / (tp + fp) and r = tp / (tp + fn), 1 / p + 1 / r - 1 = (tp + fp + fn) / tp. So cells
// of one map and edges of another, of which there are different numbers, make one ratio.
std::optional<double> Iou(const std::optional<double>& precision,
                          const std::optional<double>& recall) {
  if (!precision || !recall) return std::nullopt;
  if (*precision == 0.0 || *recall == 0.0) return 0.0;
  return 1.0 / (1.0 / *precision + 1.0 / *recall - 1.0);
}

}  // namespace

MapErrors SummarizeErrors(const MapComparison& comparison, double tolerance_m) {
  const std::vector<ComparedCell>& cells = comparison.cells;
  const std::vector<ComparedElement>& elements = comparison.elements;
  const double cell_m = std::max(comparison.truth_resolution_m, comparison.map_resolution_m);
  MapErrors errors;
  errors.occupied_cells = static_cast<int>(cells.size());
  errors.map_to_truth_m = Distances(cells);
  errors.precision = PartWithin(cells, cell_m);
  errors.extra =
      Part(std::count_if(cells.begin(), cells.end(),
                         [&](const ComparedCell& cell) {
                           return cell.in_seen_space && !IsWithin(cell.distance_m, tolerance_m);
                         }),
           cells.size());
  errors.outside =
      Part(std::count_if(cells.begin(), cells.end(),
                         [&](const ComparedCell& cell) {
                           return !cell.in_seen_space && !IsWithin(cell.distance_m, kReach_m);
                         }),
           cells.size());

  errors.surface_elements = static_cast<int>(elements.size());
  errors.truth_to_map_m = Distances(elements);
  errors.recall = PartWithin(elements, cell_m);
  if (const auto found = PartWithin(elements, tolerance_m)) errors.missing = 1.0 - *found;

  std::vector<double> widths, shifts;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    errors.straight_elements += comparison.surface[i].across.has_value();
    if (elements[i].bands.empty()) continue;
    widths.push_back(elements[i].bands.front().width_m());
    shifts.push_back(elements[i].bands.front().distance_m());
  }
  errors.matched_elements = static_cast<int>(widths.size());
  errors.blur_m = ComputeMeanAndP95(std::move(widths));
  errors.shift_m = ComputeMeanAndP95(std::move(shifts));

  errors.iou = Iou(errors.precision, errors.recall);
  if (errors.recall) errors.broken = errors.iou.value_or(0.0) < kBrokenIou;
  errors.known = Part(comparison.known_cells, static_cast<std::size_t>(comparison.seen_cells));
  return errors;
}

}  // namespace gmapping_spa::metrics
