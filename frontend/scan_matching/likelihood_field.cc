// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/likelihood_field.h"

#include <glog/logging.h>

#include <cmath>

namespace gmapping_spa::scan_matching {

using map::CellIndex;
using map::FloorToCell;

namespace {

constexpr double kScale = 255.0;
constexpr float kHalf = 0.5f;

// The one-dimensional Gaussian around `coordinate`, in cells, at the middles of the cells from
// `first` on.
void FillGaussian(double coordinate, int first, double exponent_per_square,
                  std::vector<float>* values) {
  for (std::size_t i = 0; i < values->size(); ++i) {
    const double d = first + static_cast<int>(i) + 0.5 - coordinate;
    (*values)[i] = static_cast<float>(std::exp(exponent_per_square * d * d));
  }
}

}  // namespace

ByteGrid MakeLikelihoodField(const LikelihoodFieldOptions& options,
                             const std::vector<Eigen::Vector2d>& points) {
  CHECK_GT(options.resolution_m, 0.0);
  CHECK_GT(options.sigma_m, 0.0);
  ByteGrid field;
  if (points.empty()) return field;

  const double cells_per_m = 1.0 / options.resolution_m;
  Eigen::Array2d low = points.front(), high = low;
  for (const Eigen::Vector2d& point : points) {
    CHECK(point.allFinite());
    low = low.min(point.array());
    high = high.max(point.array());
  }
  low *= cells_per_m;
  high *= cells_per_m;
  CHECK_LT(low.abs().maxCoeff(), map::kMaxCellIndex) << "a point far away from all maps";
  CHECK_LT(high.abs().maxCoeff(), map::kMaxCellIndex) << "a point far away from all maps";

  // Farther away than this, the value is rounded to 0.
  const double sigma_cells = options.sigma_m * cells_per_m;
  const int radius =
      static_cast<int>(std::ceil(sigma_cells * std::sqrt(2.0 * std::log(2.0 * kScale))));
  const int width = 2 * radius + 1;
  field.min = {FloorToCell(low.x()) - radius, FloorToCell(low.y()) - radius};
  field.columns = static_cast<unsigned>(FloorToCell(high.x()) + radius - field.min.x + 2);
  field.rows = static_cast<unsigned>(FloorToCell(high.y()) + radius - field.min.y + 2);
  field.values.assign(static_cast<std::size_t>(field.columns) * field.rows, 0);

  // A Gaussian in the plane is the product of those in x and y: few calls of exp.
  const double exponent = -0.5 / (sigma_cells * sigma_cells);
  std::vector<float> along_x(static_cast<std::size_t>(width)), along_y(along_x.size());
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2d cells = cells_per_m * point;
    const CellIndex first{FloorToCell(cells.x()) - radius, FloorToCell(cells.y()) - radius};
    FillGaussian(cells.x(), first.x, exponent, &along_x);
    FillGaussian(cells.y(), first.y, exponent, &along_y);
    for (int row = 0; row < width; ++row) {
      std::uint8_t* values = field.RowValues(field.Row(first.y + row)) + field.Column(first.x);
      const float scale = static_cast<float>(kScale) * along_y[static_cast<std::size_t>(row)];
      for (std::size_t i = 0; i < along_x.size(); ++i) {
        // Rounded half up: std::lround is a function call.
        const auto value = static_cast<std::uint8_t>(static_cast<int>(scale * along_x[i] + kHalf));
        values[i] = std::max(values[i], value);
      }
    }
  }
  return field;
}

}  // namespace gmapping_spa::scan_matching
