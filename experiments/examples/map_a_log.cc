// SPDX-License-Identifier: BSD-3-Clause
// From a bag or a CARMEN log to a map: map_a_log LOG MAP writes MAP.pgm and MAP.yaml.
#include <glog/logging.h>
#include <gmapping_spa/map_server_io.h>
#include <gmapping_spa/open_bag.h>
#include <gmapping_spa/open_log.h>
#include <gmapping_spa/slam.h>

#include <exception>
#include <fstream>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace {

std::unique_ptr<gmapping_spa::sensor::LogReader> OpenLog(const std::string& path) {
  if (gmapping_spa::rosbag::IsBag(path)) return gmapping_spa::rosbag::OpenBag(path, {}).reader;
  auto in = std::make_unique<std::ifstream>(path);
  if (!*in) throw std::runtime_error("cannot read " + path);
  return gmapping_spa::sensor::OpenCarmenLog(std::move(in), path, {});
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 3) throw std::runtime_error("usage: map_a_log LOG MAP");
  FLAGS_logtostderr = true;  // what SLAM warns of goes through glog
  google::InitGoogleLogging(argv[0]);
  const auto log = OpenLog(argv[1]);

  gmapping_spa::Slam slam;
  while (const auto scan = log->Next()) slam.AddScan(*scan);
  slam.Finish();

  const auto [x, y, theta] = slam.CurrentPose();
  std::cout << "The robot is at " << x << " m, " << y << " m, " << theta << " rad.\n";
  const std::string name = argv[2];
  std::ofstream image(name + ".pgm", std::ios::binary), yaml(name + ".yaml");
  gmapping_spa::map::WritePgm(slam.CurrentMap(), image);
  gmapping_spa::map::WriteMapYaml(slam.CurrentMap(), name + ".pgm", yaml);
  if (!image.flush() || !yaml.flush()) throw std::runtime_error("cannot write " + name);
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
