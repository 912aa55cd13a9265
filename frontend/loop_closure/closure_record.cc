#include "frontend/loop_closure/closure_record.h"

namespace gmapping_spa::loop_closure {

const char* VerdictName(Verdict verdict) {
  switch (verdict) {
    case Verdict::kNoMatch:
      return "no_match";
    case Verdict::kAmbiguous:
      return "ambiguous";
    case Verdict::kUnstable:
      return "unstable";
    case Verdict::kOverlap:
      return "overlap";
    case Verdict::kInlierRatio:
      return "inlier_ratio";
    case Verdict::kSeenThrough:
      return "seen_through";
    case Verdict::kMahalanobis:
      return "mahalanobis";
    case Verdict::kUnconfirmed:
      return "unconfirmed";
    case Verdict::kReleased:
      return "released";
    case Verdict::kAccepted:
      return "accepted";
  }
  return "unknown";
}

const char* SourceName(Source source) {
  switch (source) {
    case Source::kNear:
      return "near";
    case Source::kPlace:
      return "place";
    case Source::kFollowed:
      return "followed";
  }
  return "unknown";
}

}  // namespace gmapping_spa::loop_closure
