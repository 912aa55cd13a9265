// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/pause_gate.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace gmapping_spa::view {
namespace {

constexpr auto kShort = std::chrono::milliseconds(50);

// Passes the gate again and again in a thread of its own.
class Passing {
 public:
  explicit Passing(PauseGate* gate)
      : thread_([this, gate] {
          while (!ends_) {
            gate->Pass([this] { return ends_.load(); });
            ++passed_;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
          }
        }) {}
  ~Passing() {
    ends_ = true;
    thread_.join();
  }
  int passed() const { return passed_; }
  void WaitFor(int passed) const {
    while (passed_ < passed) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

 private:
  std::atomic<int> passed_ = 0;
  std::atomic<bool> ends_ = false;
  std::thread thread_;
};

TEST(PauseGate, IsOpenAndHoldsWhilePaused) {
  PauseGate gate;
  const Passing passing(&gate);
  passing.WaitFor(3);
  gate.Pause();
  std::this_thread::sleep_for(kShort);
  const int held = passing.passed();
  std::this_thread::sleep_for(kShort);
  EXPECT_EQ(passing.passed(), held);
  gate.Resume();
  passing.WaitFor(held + 3);
}

TEST(PauseGate, StepsLetOneThroughEach) {
  PauseGate gate;
  gate.Pause();
  const Passing passing(&gate);
  gate.Step();
  gate.Step();
  passing.WaitFor(2);
  std::this_thread::sleep_for(kShort);
  EXPECT_EQ(passing.passed(), 2);
  EXPECT_TRUE(gate.is_paused());
}

TEST(PauseGate, StepWhereNobodyPausedPauses) {
  PauseGate gate;
  gate.Step();
  EXPECT_TRUE(gate.is_paused());
}

TEST(PauseGate, GivesUpWhenAsked) {
  PauseGate gate;
  gate.Pause();
  int asked = 0;
  gate.Pass([&] { return ++asked == 2; });
  EXPECT_EQ(asked, 2);
}

}  // namespace
}  // namespace gmapping_spa::view
