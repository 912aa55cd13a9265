// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/world_file.h"

#include "backend/text.h"

namespace gmapping_spa::apps {

void WriteWorldFile(const PicturePlace& place, std::ostream& out) {
  const double half_m = 0.5 * place.pixel_m;
  for (const double number :
       {place.pixel_m, 0.0, 0.0, -place.pixel_m, place.left_x_m + half_m, place.top_y_m - half_m}) {
    out << backend::ShortestFixedText(number) << '\n';
  }
}

}  // namespace gmapping_spa::apps
