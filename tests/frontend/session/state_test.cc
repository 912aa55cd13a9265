// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/session/state.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "backend/counter_random.h"
#include "tests/frontend/drifting_scans.h"
#include "tests/frontend/session/resumed_run.h"
#include "tests/message_of.h"

namespace gmapping_spa::session {
namespace {

using ::testing::HasSubstr;

// A drive of one round and a third.
class SessionState : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    scans_ = synthetic::DriftingScans(synthetic::DriveOnRing(0, 64, 0.25));
  }

  // Of the maps of all particles, those that no other one has.
  static std::size_t OwnTiles(const frontend::ImprovedGmapping& gmapping) {
    std::size_t tiles = 0;
    for (const auto& particle : gmapping.filter().particles()) {
      tiles += particle.map.CountOwnTiles();
    }
    return tiles;
  }

  inline static Scans scans_;
};

TEST_F(SessionState, ARunGoesOnToTheSameBytesFromBeforeAndBehindLoopClosures) {
  const auto whole = ExpectSameWhenResumed(QuickOptions(), scans_, {120, 221, 250});
  EXPECT_GT(whole->counts().corrections, 0);
  EXPECT_FALSE(whole->loop_closer().closures().empty());
}

TEST_F(SessionState, ARunGoesOnToTheSameBytesFromAnyUpdateAroundALoopClosure) {
  ExpectSameWhenResumed(QuickOptions(), scans_, {215, 218, 224});
}

TEST_F(SessionState, ARunGoesOnToTheSameBytesFromItsBegin) {
  ExpectSameWhenResumed(QuickOptions(), {scans_.begin(), scans_.begin() + 40}, {0, 1, 20});
}

TEST_F(SessionState, MapsShareTheTilesThatTheyShared) {
  const auto saved = MakeGmapping(QuickOptions()), loaded = MakeGmapping(QuickOptions());
  for (std::size_t k = 0; k < 100; ++k) saved->AddScan(scans_[k]);
  LoadState(SaveState(*saved), loaded.get());
  EXPECT_EQ(OwnTiles(*loaded), OwnTiles(*saved));
  EXPECT_LT(OwnTiles(*saved), 3 * saved->CurrentMap().CountTiles());
}

TEST_F(SessionState, TellsWhichScansItHasTaken) {
  const auto saved = MakeGmapping(QuickOptions()), loaded = MakeGmapping(QuickOptions());
  for (std::size_t k = 0; k < 20; ++k) saved->AddScan(scans_[k]);
  LoadState(SaveState(*saved), loaded.get());
  ASSERT_EQ(loaded->scans().size(), 20);
  for (int k = 0; k < 20; ++k) EXPECT_TRUE(loaded->scans().Holds(k, scans_[k]));
  sensor::LaserScan other = scans_[7];
  other.beams[40].range_m += 0.01;
  EXPECT_FALSE(loaded->scans().Holds(7, other));
}

TEST_F(SessionState, AnotherNumberOfParticlesIsRefused) {
  const auto saved = MakeGmapping(QuickOptions());
  saved->AddScan(scans_[0]);
  SlamOptions options = QuickOptions();
  options.particles = 5;
  const auto other = MakeGmapping(options);
  EXPECT_THAT(MessageOf([&] { LoadState(SaveState(*saved), other.get()); }),
              HasSubstr("expected 5 particles, found 3"));
}

TEST_F(SessionState, TheMapOfARunWithAnotherNumberOfParticlesIsGoneOnIn) {
  const auto saved = MakeGmapping(QuickOptions());
  saved->AddScan(scans_[0]);
  SlamOptions options = QuickOptions();
  options.particles = 5;
  const auto other = MakeGmapping(options);
  LoadKnown(SaveState(*saved), other.get());
  other->BeginSession(frontend::MapSession::Use::kMapOn);
  EXPECT_EQ(other->filter().particles().size(), 5u);
  other->AddScan(scans_[0]);
  other->AddScan(scans_[1]);
  EXPECT_EQ(other->Finish().trajectory.size(), 3u);
}

// What has a right checksum may still be nonsense.
TEST_F(SessionState, BytesThatAreNoStateAreRefusedOrLoadedButNeverAskForAbsurdMemory) {
  const auto saved = MakeGmapping(QuickOptions());
  for (std::size_t k = 0; k < 30; ++k) saved->AddScan(scans_[k]);
  const std::string state = SaveState(*saved);
  for (std::size_t size = 0; size < state.size(); size += 1 + state.size() / 40) {
    const auto loaded = MakeGmapping(QuickOptions());
    EXPECT_THROW(LoadState(state.substr(0, size), loaded.get()), std::runtime_error) << size;
  }
  EXPECT_THROW(LoadState(state + "x", MakeGmapping(QuickOptions()).get()), std::runtime_error);
  backend::CounterRandom random(1, 2, 3, 4);
  for (int times = 0; times < 100; ++times) {
    std::string damaged = state;
    damaged[static_cast<std::size_t>(random.Uniform() * static_cast<double>(state.size()))] ^= 0x80;
    const auto loaded = MakeGmapping(QuickOptions());
    try {
      LoadState(damaged, loaded.get());
    } catch (const std::runtime_error&) {
    }
  }
}

}  // namespace
}  // namespace gmapping_spa::session
