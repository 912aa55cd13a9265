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
    case Verdict::kFit:
      return "fit";
    case Verdict::kGate:
      return "gate";
    case Verdict::kUnconfirmed:
      return "unconfirmed";
    case Verdict::kAccepted:
      return "accepted";
  }
  return "unknown";
}

}  // namespace gmapping_spa::loop_closure
