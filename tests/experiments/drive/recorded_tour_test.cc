// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/drive/recorded_tour.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/simulation/carmen_writer.h"
#include "tests/experiments/drive/driven_room.h"

namespace gmapping_spa::drive {
namespace {

using ::testing::HasSubstr;

std::string LogOf(const RecordedTour& tour) {
  std::ostringstream log;
  simulation::CarmenWriter writer(log);
  tour.Play(0, tour.steps(), &writer);
  return log.str();
}

TEST(RecordedTour, PlaysWhatTheSensorsSaid) {
  DrivenRoom room;
  room.Drive({1.0, 0.2}, 30);
  std::ostringstream direct;
  simulation::CarmenWriter writer(direct);
  DrivenRobot robot(&RoomScene(), {2.0, 3.0, 0.0}, RoomOptions());
  for (int i = 0; i < 30; ++i) robot.Step({{1.0, 0.2}}, &writer);
  EXPECT_EQ(LogOf(room.tour), direct.str());
}

TEST(RecordedTour, CommandsThatWereWrittenGiveTheSameTour) {
  DrivenRoom room;
  room.Drive({1.0 / 3.0, 0.2}, 25);
  room.noise = 4.7;
  room.slips_per_m = 0.3;
  room.Drive({0.0, -0.77}, 25);
  std::stringstream file;
  room.tour.WriteCommands(file);
  DrivenRoom again;
  for (const DriveCommand& command : ReadCommands(file, "commands.csv")) {
    again.tour.Drive(command, &again.robot);
  }
  EXPECT_EQ(LogOf(again.tour), LogOf(room.tour));
  EXPECT_EQ(again.robot.world_T_robot(), room.robot.world_T_robot());
}

TEST(RecordedTour, BadCommandsAreNamedByTheirLine) {
  const std::string header = "linear_m_s,angular_rad_s,odometry_noise,slips_per_m\n";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "commands.csv: expected commands"},
      {"1,2,3,4\n", "commands.csv:1: expected the header"},
      {header + "1,0,1,0\n1,0,1\n", "commands.csv:3: expected four numbers, found '1,0,1'"},
      {header + "1,0,1,0,0\n", "commands.csv:2: expected four numbers"},
      {header + "nan,0,1,0\n", "commands.csv:2: expected four numbers"},
      {header + "1,0,-1,0\n", "commands.csv:2: expected noise and slips from 0"},
      {header + "1,0,1,0\n1,0,1,0.0", "commands.csv:3: expected a line that ends"}};
  for (const auto& [text, message] : cases) {
    std::istringstream in(text);
    try {
      ReadCommands(in, "commands.csv");
      ADD_FAILURE() << text;
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), HasSubstr(message));
    }
  }
}

}  // namespace
}  // namespace gmapping_spa::drive
