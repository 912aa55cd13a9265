// SPDX-License-Identifier: BSD-3-Clause
// Writes databases (.db3) with messages of ROS 2, as rosbag2_storage_sqlite3 reads them.
#ifndef GMAPPING_SPA_EXPERIMENTS_CONVERSION_DB3_WRITER_H_
#define GMAPPING_SPA_EXPERIMENTS_CONVERSION_DB3_WRITER_H_

#include <memory>
#include <string>

#include "experiments/conversion/bag_writer.h"

namespace gmapping_spa::conversion {

// A database that `path` names, which must not be there yet. `ros2 bag reindex` makes the
// metadata.yaml that other tools want beside it. Throws std::runtime_error with one line.
std::unique_ptr<BagWriter> MakeDb3Writer(const std::string& path);

}  // namespace gmapping_spa::conversion

#endif  // GMAPPING_SPA_EXPERIMENTS_CONVERSION_DB3_WRITER_H_
