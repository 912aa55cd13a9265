// SPDX-License-Identifier: BSD-3-Clause
// Where the scan matching of a particle starts.
#ifndef GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_MATCH_START_H_
#define GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_MATCH_START_H_

#include <cstdint>
#include <memory>

#include "backend/counter_random.h"
#include "backend/se2.h"
#include "frontend/particle_filter/control.h"
#include "frontend/particle_filter/motion_model.h"
#include "frontend/scan_matching/endpoint_model.h"

namespace gmapping_spa::particle_filter {

// Implementations keep no state, so that threads can share one.
class MatchStart {
 public:
  enum class Kind : std::uint8_t {
    kPrediction,  // the odometry's prediction, or a draw from the motion model that fits better
    kDraw         // one draw from the motion model, as in GMapping
  };

  struct Options {
    Kind kind = Kind::kPrediction;
    // Of kPrediction: so many draws from the motion model compete with the prediction. Wheels slip
    // by more than a scan matcher can make good.
    int guesses = 0;
    friend bool operator==(const Options&, const Options&) = default;
  };

  virtual ~MatchStart() = default;

  // The initial pose of eq. (8). `model`: how well the scan fits the particle's map.
  virtual backend::SE2 Choose(const backend::SE2& world_T_previous, const Control& control,
                              scan_matching::EndpointModel* model,
                              backend::CounterRandom* random) const = 0;

  // Eq. (9): a draw from the motion model, for a particle whose match failed that had started at
  // `start`.
  virtual backend::SE2 SampleInstead(const backend::SE2& start,
                                     const backend::SE2& world_T_previous, const Control& control,
                                     backend::CounterRandom* random) const = 0;
};

std::shared_ptr<const MatchStart> MakeMatchStart(const MatchStart::Options& options,
                                                 const MotionModel& motion_model);

}  // namespace gmapping_spa::particle_filter

#endif  // GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_MATCH_START_H_
