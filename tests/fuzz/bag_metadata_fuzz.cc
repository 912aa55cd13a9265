// SPDX-License-Identifier: BSD-3-Clause
// metadata.yaml of a folder, beside a bag that is whole.
#include <cstddef>
#include <cstdint>
#include <sstream>

#include "experiments/conversion/mcap_writer.h"
#include "tests/frontend/rosbag/small_bag.h"
#include "tests/fuzz/input_folder.h"
#include "tests/fuzz/read_bag.h"

namespace gmapping_spa::fuzz {
namespace {

class Folder : public InputFolder {
 public:
  Folder() {
    rosbag::SmallBag bag(FileWith("bag_0.mcap", ""), "mcap");
    rosbag::WriteDrive(&bag);
    bag.Finish();
  }
};

}  // namespace
}  // namespace gmapping_spa::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gmapping_spa;
  static const fuzz::Folder folder;
  folder.FileWith("metadata.yaml", fuzz::TextOf(data, size));
  fuzz::ReadBag(folder.path());
  return 0;
}
