// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/closure_record.h"

#include <Eigen/LU>

#include "backend/enum_names.h"

namespace gmapping_spa::loop_closure {
namespace {

constexpr backend::EnumName<Verdict> kVerdicts[] = {
    {"no_match", Verdict::kNoMatch},         {"ambiguous", Verdict::kAmbiguous},
    {"unstable", Verdict::kUnstable},        {"overlap", Verdict::kOverlap},
    {"inlier_ratio", Verdict::kInlierRatio}, {"seen_through", Verdict::kSeenThrough},
    {"mahalanobis", Verdict::kMahalanobis},  {"rival", Verdict::kRival},
    {"unconfirmed", Verdict::kUnconfirmed},  {"released", Verdict::kReleased},
    {"rejected", Verdict::kRejected},        {"accepted", Verdict::kAccepted}};
constexpr backend::EnumName<Source> kSources[] = {{"near", Source::kNear},
                                                  {"place", Source::kPlace},
                                                  {"followed", Source::kFollowed},
                                                  {"localized", Source::kLocalized},
                                                  {"hand", Source::kHand}};

// No map is better than this.
constexpr double kFloor_m = 0.01;
constexpr double kFloor_rad = 0.002;

constexpr double kNextToNothing = 1e-3;  // in 1/m^2 and 1/rad^2

}  // namespace

const char* VerdictName(Verdict verdict) { return NameOf(kVerdicts, verdict); }

std::optional<Verdict> VerdictNamed(std::string_view name) {
  return backend::ValueOf(kVerdicts, name);
}

std::optional<Source> SourceNamed(std::string_view name) {
  return backend::ValueOf(kSources, name);
}

const char* SourceName(Source source) { return NameOf(kSources, source); }

Eigen::Matrix3d WithMapErrors(const Eigen::Matrix3d& information) {
  const Eigen::Matrix3d floor =
      Eigen::Array3d(kFloor_m, kFloor_m, kFloor_rad).square().matrix().asDiagonal();
  const Eigen::Matrix3d regular = information + kNextToNothing * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d floored = (regular.inverse() + floor).inverse();
  return 0.5 * (floored + floored.transpose());
}

}  // namespace gmapping_spa::loop_closure
