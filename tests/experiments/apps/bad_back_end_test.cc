// SPDX-License-Identifier: BSD-3-Clause
// Back ends that hang or crash, seen from the command line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/command_error.h"
#include "tests/experiments/apps/gmapping_spa_tour.h"
#include "tests/experiments/apps/signal_command.h"

namespace gmapping_spa::apps {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr double kSomeSeconds = 20.0;  // on a busy machine, under a sanitizer

std::string BackEnd(const std::string& fault) {
  return "--backend=" TEST_PLUGIN_FOLDER "/libgmapping_spa_" + fault + ".so";
}

class BadBackEnd : public GmappingSpaTour {
 protected:
  std::vector<std::string> OptimizeGraph(const std::vector<std::string>& more) const {
    std::vector<std::string> words = {OPTIMIZE_GRAPH, "--input=" + graph_,
                                      "--output=" + folder_.Path("out/graph.g2o"), "--loss=none"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  std::string graph_ = folder_.FileWith("graph.g2o", "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n");
};

TEST_F(BadBackEnd, SignalsEndARunWithinSecondsWithWhatItHas) {
  for (const int signal : {SIGINT, SIGTERM}) {
    for (const std::string timeout_s : {"0", "1000"}) {
      const std::string output_dir = folder_.Path("out" + std::to_string(signal) + timeout_s);
      const EndOfCommand end = SignalCommand(
          Command(output_dir,
                  {BackEnd("hanging"), "--loss=none", "--optimize_every=2", "--lockstep_scans=1",
                   "--graph_timeout_s=1000", "--particles=3", "--backend_timeout_s=" + timeout_s}),
          output_dir, signal);
      EXPECT_EQ(end.status, 128 + signal);
      EXPECT_LT(end.seconds, kSomeSeconds);
      EXPECT_THAT(FilesIn(output_dir), SizeIs(kByteIdentical.size() + 1));
      EXPECT_EQ(ReadRunRecord(output_dir)["interrupted"]["signal"], signal);
    }
  }
}

TEST_F(BadBackEnd, SignalsEndOptimizeGraphWithinSeconds) {
  for (const int signal : {SIGINT, SIGTERM}) {
    for (const std::string timeout_s : {"0", "1000"}) {
      const std::string err = folder_.Path("err");
      // Not before it hangs, which may be long after the output folder is made.
      const std::string hangs = folder_.Path("hangs" + std::to_string(signal) + timeout_s);
      setenv("GMAPPING_SPA_TEST_HANGS", hangs.c_str(), 1);
      const EndOfCommand end =
          SignalCommand(OptimizeGraph({BackEnd("hanging"), "--backend_timeout_s=" + timeout_s}),
                        hangs, signal, err);
      unsetenv("GMAPPING_SPA_TEST_HANGS");
      EXPECT_EQ(end.status, 128 + signal);
      EXPECT_LT(end.seconds, kSomeSeconds);
      EXPECT_THAT(Contents(err), EndsWith("was still at work; nothing is written\n"));
      EXPECT_FALSE(std::filesystem::exists(folder_.Path("out")));
    }
  }
}

TEST_F(BadBackEnd, WhatHangsOrCrashesCostsItsOptimizationsAndNoMore) {
  for (const char* fault : {"hanging", "crashing"}) {
    const std::string output_dir = folder_.Path(fault);
    Run(output_dir, {BackEnd(fault), "--loss=none", "--optimize_every=20", "--particles=3",
                     "--backend_timeout_s=0.3"});
    const Json record = ReadRunRecord(output_dir);
    EXPECT_GE(record["graph_thread"]["failed"], 2) << fault;
    EXPECT_EQ(record["graph_thread"]["failed"], record["graph_thread"]["started"]) << fault;
    EXPECT_TRUE(record["health"].contains("backend_failed")) << fault;
  }
}

TEST_F(BadBackEnd, IsOneLineOfOptimizeGraph) {
  EXPECT_THAT(ErrorOf(OptimizeGraph({BackEnd("crashing"), "--backend_timeout_s=100"})),
              HasSubstr("failed: the back end crashed with signal 11 (Segmentation fault)"));
  EXPECT_THAT(ErrorOf(OptimizeGraph({BackEnd("hanging"), "--backend_timeout_s=0.3"})),
              HasSubstr("failed: the back end took longer than 0.3 s and was stopped"));
  EXPECT_THAT(ErrorOf(OptimizeGraph({"--backend_timeout_s=-1"})), HasSubstr("backend_timeout_s"));
  EXPECT_FALSE(std::filesystem::exists(folder_.Path("out")));
}

TEST_F(BadBackEnd, AGoodOneGivesTheSameBytesInAProcessOfItsOwn) {
  const std::string output_dir = folder_.Path("apart");
  Run(output_dir, {"--backend_timeout_s=1000"});
  for (const std::string& name : kByteIdentical) {
    EXPECT_TRUE(Contents(Result(name)) == Contents(output_dir + "/" + name)) << name;
  }
}

}  // namespace
}  // namespace gmapping_spa::apps
