// SPDX-License-Identifier: BSD-3-Clause
// Ways that the odometry alone tells.
#ifndef GMAPPING_SPA_FRONTEND_UNCHECKED_WAY_H_
#define GMAPPING_SPA_FRONTEND_UNCHECKED_WAY_H_

namespace gmapping_spa::frontend {

// Adds up how far the robot goes, and how much of it no scan can check. Doors go by in any
// corridor: some meters without a check are nothing to be said.
class UncheckedWay {
 public:
  // Whether that makes another stretch full of which most is unchecked.
  bool Add(double way_m, bool is_unchecked) {
    way_m_ += way_m;
    if (is_unchecked) unchecked_m_ += way_m;
    if (way_m_ < kStretch_m) return false;
    const bool is_most = unchecked_m_ > kMost * way_m_;
    way_m_ = unchecked_m_ = 0.0;
    return is_most;
  }

  // For sessions (frontend/session).
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(way_m_, unchecked_m_);
  }

 private:
  static constexpr double kStretch_m = 10.0;
  static constexpr double kMost = 0.6;  // recorded corridors with doors: up to 0.35

  double way_m_ = 0.0;
  double unchecked_m_ = 0.0;
};

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_FRONTEND_UNCHECKED_WAY_H_
