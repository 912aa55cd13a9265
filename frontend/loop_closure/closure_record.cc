// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/closure_record.h"

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
                                                  {"hand", Source::kHand}};

}  // namespace

const char* VerdictName(Verdict verdict) { return NameOf(kVerdicts, verdict); }

std::optional<Verdict> VerdictNamed(std::string_view name) {
  return backend::ValueOf(kVerdicts, name);
}

std::optional<Source> SourceNamed(std::string_view name) {
  return backend::ValueOf(kSources, name);
}

const char* SourceName(Source source) { return NameOf(kSources, source); }

}  // namespace gmapping_spa::loop_closure
