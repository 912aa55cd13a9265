// SPDX-License-Identifier: BSD-3-Clause
// Trajectories of KITTI. What was read can be written and read back.
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <vector>

#include "backend/graph/kitti_io.h"
#include "tests/fuzz/contract.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gmapping_spa;
  std::vector<backend::SE2> poses;
  const bool reads = fuzz::ReadsOrRefuses([&] {
    std::istringstream in(fuzz::TextOf(data, size));
    poses = backend::ReadKitti(in, "trajectory.kitti");
  });
  if (!reads) return 0;
  backend::Trajectory trajectory;
  for (const backend::SE2& pose : poses) trajectory.push_back({0.0, pose});
  std::stringstream file;
  backend::WriteKitti(trajectory, file);
  const std::vector<backend::SE2> again = backend::ReadKitti(file, "again");
  bool same = poses.size() == again.size();
  for (std::size_t k = 0; same && k < poses.size(); ++k) {
    same = poses[k].translation() == again[k].translation();
  }
  if (!same) fuzz::Break("expected the positions that were written, found others");
  return 0;
}
