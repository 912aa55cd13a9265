// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/wheel_trust.h"

#include <gtest/gtest.h>

#include <optional>

#include "backend/counter_random.h"

namespace gmapping_spa::frontend {
namespace {

using backend::SE2;
using sensor::OdometryFault;
using Wheels = sensor::OdometryCheck::Step;

const SE2 kStep{0.1, 0, 0.05};          // of the robot, at every scan
const SE2 kVelocity{0.09, 0.01, 0.02};  // where it would be if it went on as before
constexpr Wheels kUnchanged{{}, OdometryFault::kUnchanged};

class WheelTrustOnADrive : public testing::Test {
 protected:
  // One scan: what the wheels say, and what the motion was after all.
  std::optional<WheelMotion> Take(const Wheels& wheels, const SE2& motion,
                                  bool tells_position = true) {
    const std::optional<WheelMotion> guess = Hear(wheels);
    if (guess) {
      trust_.Learn(motion, MotionPrior({}, guess, kVelocity, 0.1).hypotheses().front(),
                   tells_position);
    } else {
      trust_.Learn(motion);
    }
    return guess;
  }

  std::optional<WheelMotion> Hear(const Wheels& wheels) {
    return trust_.Guess(wheels, kVelocity, 0.2);
  }

  void DriveWell(int scans) {
    for (int i = 0; i < scans; ++i) Take({kStep}, kStep);
  }

  WheelTrust trust_;
};

TEST_F(WheelTrustOnADrive, GoodWheelsAreTakenAtTheirWord) {
  DriveWell(100);
  const std::optional<WheelMotion> guess = Hear({kStep});
  ASSERT_TRUE(guess);
  EXPECT_TRUE((guess->motion == kStep));
  EXPECT_DOUBLE_EQ(guess->sigma_factor_m, 1.0);
  EXPECT_DOUBLE_EQ(guess->sigma_factor_rad, 1.0);
  EXPECT_NEAR(guess->wrong, 0.01, 1e-9);
  EXPECT_FALSE(trust_.late());
  EXPECT_FALSE(trust_.silent());
}

TEST_F(WheelTrustOnADrive, WheelsThatProveExactAreTrustedMore) {
  DriveWell(19);
  EXPECT_DOUBLE_EQ(Hear({kStep})->gain_m, 1.0);
  DriveWell(100);
  EXPECT_GT(Hear({kStep})->gain_m, 5.0);
  EXPECT_GT(Hear({kStep})->gain_rad, 5.0);
  DriveWell(5000);
  EXPECT_DOUBLE_EQ(Hear({kStep})->gain_m, 100.0);
}

TEST_F(WheelTrustOnADrive, NoiseOfScanMatchingIsNotHeldAgainstTheWheels) {
  backend::CounterRandom random(1, 2, 3, 4);
  SE2 noise;
  for (int i = 0; i < 400; ++i) {
    const SE2 before = noise;
    noise = {0.01 * random.Gaussian(), 0.01 * random.Gaussian(), 0.005 * random.Gaussian()};
    Take({kStep}, Inverse(before) * kStep * noise);
  }
  EXPECT_GT(Hear({kStep})->gain_m, 3.0);
  EXPECT_GT(Hear({kStep})->gain_rad, 3.0);
}

TEST_F(WheelTrustOnADrive, WheelsOfTheWrongScaleAreNotTrustedMore) {
  const SE2 motion{1.1 * kStep.x, 0, 1.1 * kStep.theta};
  for (int i = 0; i < 400; ++i) Take({kStep}, motion);
  EXPECT_DOUBLE_EQ(Hear({kStep})->gain_m, 1.0);
  EXPECT_LT(Hear({kStep})->gain_rad, 2.0);
}

TEST_F(WheelTrustOnADrive, OneSlipCostsTheExtraTrust) {
  DriveWell(1000);
  ASSERT_GT(Hear({kStep})->gain_m, 20.0);
  Take({kStep}, {0.5, 0, 0.5});
  DriveWell(20);
  EXPECT_DOUBLE_EQ(Hear({kStep})->gain_m, 1.0);
  EXPECT_DOUBLE_EQ(Hear({kStep})->gain_rad, 1.0);
}

TEST_F(WheelTrustOnADrive, ScansThatMayNotTellTheWayAreNoJudgesOfIt) {
  const SE2 shortened{0.5 * kStep.x, 0, kStep.theta};
  for (int i = 0; i < 400; ++i) {
    const bool is_corridor = i % 4 != 0;
    Take({kStep}, is_corridor ? shortened : kStep, !is_corridor);
  }
  EXPECT_GT(Hear({kStep})->gain_m, 5.0);
  EXPECT_GT(Hear({kStep})->gain_rad, 5.0);
}

TEST_F(WheelTrustOnADrive, FaultyReadingsSayNothing) {
  DriveWell(10);
  for (const OdometryFault fault : {OdometryFault::kFirst, OdometryFault::kImpossible,
                                    OdometryFault::kRestart, OdometryFault::kMissing}) {
    EXPECT_FALSE(Take({{}, fault}, kStep));
    EXPECT_FALSE(trust_.silent());
  }
  EXPECT_TRUE(Hear({kStep}));
}

TEST_F(WheelTrustOnADrive, WheelsThatHaveNeverMovedSayNothing) {
  for (int i = 0; i < 20; ++i) {
    EXPECT_FALSE(Take(kUnchanged, kStep)) << i;
    EXPECT_TRUE(trust_.silent());
  }
}

TEST_F(WheelTrustOnADrive, WheelsThatStandStillWithTheRobotAreHeard) {
  DriveWell(10);
  for (int i = 0; i < 20; ++i) {
    const std::optional<WheelMotion> guess = Take(kUnchanged, {});
    ASSERT_TRUE(guess) << i;
    EXPECT_TRUE((guess->motion == SE2{}));
  }
}

TEST_F(WheelTrustOnADrive, WheelsThatStandStillWhileTheRobotMovesFallSilentUntilTheyMove) {
  DriveWell(10);
  int heard = 0;
  for (int i = 0; i < 20; ++i) heard += Take(kUnchanged, kStep) ? 1 : 0;
  EXPECT_EQ(heard, 3);
  EXPECT_TRUE(trust_.silent());
  EXPECT_TRUE(Hear({kStep}));
  EXPECT_FALSE(trust_.silent());
}

TEST_F(WheelTrustOnADrive, WheelsThatStopSoonerThanARobotCanAreSilentAtOnce) {
  DriveWell(10);
  const SE2 fast{0.2, 0, 0}, slow{0.1, 0, 0};  // in 0.2 s
  EXPECT_FALSE(trust_.Guess(kUnchanged, fast, 0.2));
  EXPECT_TRUE(trust_.silent());
  EXPECT_TRUE(trust_.Guess(kUnchanged, slow, 0.2));
  EXPECT_FALSE(trust_.silent());
  EXPECT_TRUE(trust_.Guess({SE2{0.01, 0, 0}}, fast, 0.2));
}

TEST_F(WheelTrustOnADrive, NoisyWheelsAreBelievedAsFarAsTheirNoiseAllows) {
  backend::CounterRandom random(2, 0);
  const MotionHypothesis usual = MotionPrior({}, WheelMotion{kStep}, {}, 0.1).hypotheses().front();
  for (int i = 0; i < 400; ++i) {
    const SE2 noise{3.0 * usual.sigma_m * random.Gaussian(),
                    3.0 * usual.sigma_m * random.Gaussian(),
                    3.0 * usual.sigma_rad * random.Gaussian()};
    Take({kStep * noise}, kStep);
  }
  EXPECT_NEAR(Hear({kStep})->sigma_factor_m, 3.0, 1.0);
  EXPECT_NEAR(Hear({kStep})->sigma_factor_rad, 3.0, 1.0);
  EXPECT_FALSE(trust_.late());
}

TEST_F(WheelTrustOnADrive, WheelsThatSlipAsTheyTurnStillTellTheWay) {
  backend::CounterRandom random(3, 0);
  const MotionHypothesis usual = MotionPrior({}, WheelMotion{kStep}, {}, 0.1).hypotheses().front();
  for (int i = 0; i < 400; ++i) {
    Take({kStep * SE2{0, 0, 4.0 * usual.sigma_rad * random.Gaussian()}}, kStep);
  }
  EXPECT_DOUBLE_EQ(Hear({kStep})->sigma_factor_m, 1.0);
  EXPECT_NEAR(Hear({kStep})->sigma_factor_rad, 4.0, 1.5);
}

TEST_F(WheelTrustOnADrive, WheelsThatTurnTheOtherWayAreMirrored) {
  const SE2 turn{0.05, 0.0, 0.1};
  for (int i = 0; i < 70; ++i) Take({{turn.x, turn.y, -turn.theta}}, turn);
  EXPECT_TRUE(trust_.mirrored());
}

TEST_F(WheelTrustOnADrive, WheelsThatTurnAsTheRobotDoesAreNotMirrored) {
  const SE2 turn{0.05, 0.0, 0.1};
  for (int i = 0; i < 70; ++i) Take({turn}, turn);
  EXPECT_FALSE(trust_.mirrored());
}

TEST_F(WheelTrustOnADrive, OneSlipIsForgotten) {
  DriveWell(50);
  Take({kStep * SE2{1.0, 0, 1.0}}, kStep);
  EXPECT_GT(Hear({kStep})->sigma_factor_rad, 1.1);
  EXPECT_GT(Hear({kStep})->wrong, 0.03);
  DriveWell(150);
  EXPECT_NEAR(Hear({kStep})->sigma_factor_rad, 1.0, 0.1);
  EXPECT_LT(Hear({kStep})->wrong, 0.02);
}

TEST_F(WheelTrustOnADrive, WheelsThatAreAlwaysWrongAreNotGivenUpAltogether) {
  backend::CounterRandom random(4, 0);
  for (int i = 0; i < 300; ++i) {
    Take({{random.Gaussian(), random.Gaussian(), random.Gaussian()}}, kStep);
  }
  EXPECT_LE(Hear({kStep})->wrong, 0.5);
  EXPECT_LE(Hear({kStep})->sigma_factor_m, 10.0);
  EXPECT_LE(Hear({kStep})->sigma_factor_rad, 10.0);
}

TEST_F(WheelTrustOnADrive, TurnsThatAreMissingAllTheTimeAreMadeUpFor) {
  const SE2 said{kStep.x, 0.0, kStep.theta - 0.01};
  for (int i = 0; i < 1000; ++i) Take({said}, kStep);
  EXPECT_TRUE(trust_.calibration().corrects());
  EXPECT_NEAR(Hear({said})->motion.theta, kStep.theta, 0.001);
  EXPECT_GT(Hear({said})->gain_rad, 2.0);
}

TEST_F(WheelTrustOnADrive, TheWayOfWheelsThatTellTurnsOnlyIsThatOfTheSameVelocity) {
  for (int i = 0; i < 100; ++i) {
    const std::optional<WheelMotion> guess = Take({{0.0, 0.0, kStep.theta}}, kStep);
    ASSERT_TRUE(guess);
    EXPECT_TRUE((guess->motion == SE2{kVelocity.x, kVelocity.y, kStep.theta}));
    EXPECT_FALSE(guess->tells_way);
    EXPECT_EQ(guess->gain_m, 1.0);
  }
  EXPECT_TRUE(trust_.tells_turns_only());
  EXPECT_GT(Hear({{0.0, 0.0, kStep.theta}})->gain_rad, 2.0);
}

TEST_F(WheelTrustOnADrive, WheelsThatHaveToldAWayOnceAreBelievedThatThereIsNone) {
  DriveWell(1);
  const std::optional<WheelMotion> guess = Hear({{0.0, 0.0, kStep.theta}});
  EXPECT_TRUE((guess->motion == SE2{0.0, 0.0, kStep.theta}));
  EXPECT_TRUE(guess->tells_way);
  EXPECT_FALSE(trust_.tells_turns_only());
}

// Readings that come every second scan: nothing, then two steps at once.
TEST_F(WheelTrustOnADrive, ReadingsThatLagBehindAreNoticedAndMadeUpFor) {
  SE2 held_back;
  double said_off = 0.0, guess_off = 0.0;
  for (int scan = 0; scan < 300; ++scan) {
    held_back = held_back * kStep;
    const bool told = scan % 2 == 1;
    const std::optional<WheelMotion> guess = Take(told ? Wheels{held_back} : kUnchanged, kStep);
    if (guess && scan >= 100) {
      said_off += Log(Between(kStep, told ? held_back : SE2{})).squaredNorm();
      guess_off += Log(Between(kStep, guess->motion)).squaredNorm();
    }
    if (told) held_back = {};
  }
  EXPECT_TRUE(trust_.late());
  EXPECT_LT(guess_off, 0.5 * said_off);
}

}  // namespace
}  // namespace gmapping_spa::frontend
