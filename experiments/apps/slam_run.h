// A run of SLAM as flags describe it, from the first scan to the files of results.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_SLAM_RUN_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_SLAM_RUN_H_

#include <functional>

#include "experiments/apps/json.h"
#include "experiments/apps/output_files.h"
#include "experiments/apps/run_record.h"
#include "frontend/improved_gmapping.h"
#include "frontend/sensor/laser_scan.h"

namespace gmapping_spa::apps {

// Sets defaults of flags that are other here than in optimize_graph; before flags are parsed.
void SetSlamDefaults();

class SlamRun {
 public:
  // Throws std::runtime_error with one line when a flag makes no sense.
  SlamRun();

  // May throw Interrupted.
  void AddScan(const sensor::LaserScan& scan);

  // After the last scan: writes trajectory.tum, map.pgm, map.yaml, map.png, graph.g2o,
  // loop_closures.csv and run.json. `input` tells for the record what the scans were made of.
  void Finish(const std::function<Json()>& input, OutputFiles* files);

  const frontend::ImprovedGmapping::Counts& counts() const { return gmapping_.counts(); }

 private:
  double occupied_threshold_;
  frontend::ImprovedGmapping gmapping_;
  Stopwatch stopwatch_;
};

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_SLAM_RUN_H_
