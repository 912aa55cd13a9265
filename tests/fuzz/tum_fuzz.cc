// SPDX-License-Identifier: BSD-3-Clause
// Trajectories. What was read can be written and read back.
#include <cstddef>
#include <cstdint>
#include <sstream>

#include "backend/graph/trajectory_io.h"
#include "tests/fuzz/contract.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gmapping_spa;
  backend::Trajectory trajectory;
  const bool reads = fuzz::ReadsOrRefuses([&] {
    std::istringstream in(fuzz::TextOf(data, size));
    trajectory = backend::ReadTum(in, "trajectory.tum");
  });
  if (!reads) return 0;
  std::stringstream file;
  backend::WriteTum(trajectory, file);
  const backend::Trajectory again = backend::ReadTum(file, "again");
  bool same = trajectory.size() == again.size();
  for (std::size_t k = 0; same && k < trajectory.size(); ++k) {
    same = trajectory[k].stamp_s == again[k].stamp_s &&
           trajectory[k].world_T_robot == again[k].world_T_robot;
  }
  if (!same) fuzz::Break("expected the trajectory that was written, found another one");
  return 0;
}
