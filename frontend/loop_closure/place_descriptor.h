// SPDX-License-Identifier: BSD-3-Clause
// What the surroundings of a place look like, whatever the heading.
#ifndef GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_PLACE_DESCRIPTOR_H_
#define GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_PLACE_DESCRIPTOR_H_

#include <Eigen/Core>
#include <vector>

namespace gmapping_spa::loop_closure {

// A unit vector, or zero where there is nothing to describe.
using PlaceDescriptor = Eigen::VectorXf;

// Points farther away from the place than this describe others.
inline constexpr double kDescriptorRadius_m = 20.0;

// Of points around a place, in its frame and in metres. They are counted in rings around it; the
// spectrum of each ring over the direction does not change when the place is turned. Roots of the
// counts: a wall that is near has many points and would drown the others.
PlaceDescriptor ComputeDescriptor(const std::vector<Eigen::Vector2d>& points);

// From 0, the same, to 1, nothing in common.
double Dissimilarity(const PlaceDescriptor& a, const PlaceDescriptor& b);

}  // namespace gmapping_spa::loop_closure

#endif  // GMAPPING_SPA_FRONTEND_LOOP_CLOSURE_PLACE_DESCRIPTOR_H_
