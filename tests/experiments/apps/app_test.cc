// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/app.h"

#include <gflags/gflags.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/temporary_folder.h"

DEFINE_int32(particles, 30, "A flag of this program.");
DEFINE_bool(verbose_map, true, "A switch of this program.");

namespace gmapping_spa::apps {
namespace {

// Ends this process as an executable would whose main is RunApp. For death tests, since flags and
// logging start once in a process.
[[noreturn]] void Main(std::vector<std::string> words, const std::function<void()>& run) {
  words.insert(words.begin(), "/some/where/tool");
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const FlagGroups groups = {{"map", "Map", {"particles", "verbose_map"}}};
  std::exit(RunApp(static_cast<int>(words.size()), argv.data(), "tests itself.", groups, run));
}

void Nothing() {}

using testing::ExitedWithCode;

TEST(RunApp, SucceedsSilently) { EXPECT_EXIT(Main({}, Nothing), ExitedWithCode(0), "^$"); }

TEST(RunApp, ReportsAnExceptionOnOneLine) {
  EXPECT_EXIT(Main({}, [] { throw std::runtime_error("log.clf:3: broken"); }), ExitedWithCode(1),
              "^tool: error: log.clf:3: broken\n$");
}

TEST(RunApp, TellsANegativeAnswerFromAnError) {
  EXPECT_EXIT(Main({}, [] { throw NegativeAnswer("undecided"); }), ExitedWithCode(2),
              "^tool: undecided\n$");
}

TEST(RunApp, ParsesFlagsBeforeItRuns) {
  EXPECT_EXIT(Main({"--particles=7", "--noverbose_map"},
                   [] { std::exit(FLAGS_particles + (FLAGS_verbose_map ? 100 : 0)); }),
              ExitedWithCode(7), "^$");
}

TEST(RunApp, TakesTheNextWordAsAValueUnlessTheFlagIsASwitch) {
  EXPECT_EXIT(Main(
                  {
                      "-particles",
                      "7",
                      "-verbose-map",
                      "--logtostderr",
                      "--",
                  },
                  [] { std::exit(FLAGS_particles); }),
              ExitedWithCode(7), "^$");
  EXPECT_EXIT(Main({"--verbose_map", "false"}, Nothing), ExitedWithCode(1),
              "expected flags only, found 'false'");
}

TEST(RunApp, RefusesWordsLeftOver) {
  EXPECT_EXIT(Main({"--", "--particles=7"}, [] { std::exit(0); }), ExitedWithCode(1),
              "expected flags only, found '--particles=7'");
  EXPECT_EXIT(Main({"--particles=7", "log.clf"}, [] { std::exit(0); }), ExitedWithCode(1),
              "^tool: error: expected flags only, found 'log.clf'[^\n]*\n$");
}

TEST(RunApp, RefusesUnknownFlagsAndBadValues) {
  EXPECT_EXIT(Main({"--particels=7"}, Nothing), ExitedWithCode(1),
              "^tool: error: unknown flag '--particels' [^\n]*\n$");
  EXPECT_EXIT(Main({"--noparticles"}, Nothing), ExitedWithCode(1),
              "^tool: error: unknown flag '--noparticles' [^\n]*\n$");
  EXPECT_EXIT(Main({"--particles"}, Nothing), ExitedWithCode(1),
              "^tool: error: --particles: expected a value\n$");
  EXPECT_EXIT(Main({"--particles=many"}, Nothing), ExitedWithCode(1),
              "^tool: error: command line: --particles: expected a value of type int32, found "
              "'many'\n$");
}

TEST(RunApp, BadLoggingFlagsDoNotStopIt) {
  EXPECT_EXIT(Main({"--log_dir=/nowhere/at/all", "--v=-3", "--minloglevel=99"}, Nothing),
              ExitedWithCode(0), "^$");
}

TEST(RunApp, TakesFlagsFromAFlagFile) {
  const TemporaryFolder folder;
  const std::string inner = folder.FileWith("inner.flags", "--noverbose_map\n");
  const std::string outer =
      folder.FileWith("good.flags", "# comment\n\n  -particles=7\n--flagfile=" + inner + "\n");
  EXPECT_EXIT(Main({"--flagfile=" + outer},
                   [] { std::exit(FLAGS_particles + (FLAGS_verbose_map ? 100 : 0)); }),
              ExitedWithCode(7), "^$");
}

[[noreturn]] void ExitWithParticles() { std::exit(FLAGS_particles); }

TEST(RunApp, TheCommandLineWinsOverAFlagFileBeforeAndBehindItAndSaysSo) {
  const TemporaryFolder folder;
  const std::string path = folder.FileWith("many.flags", "--particles=40\n--noverbose_map\n");
  const std::string said = "^tool: --particles=5 \\(command line\\) wins over 40 of many.flags\n$";
  const std::string file = "--flagfile=" + path;
  EXPECT_EXIT(Main({"--particles=5", file}, ExitWithParticles), ExitedWithCode(5), said);
  EXPECT_EXIT(Main({"--particles=5", "-flagfile", path}, ExitWithParticles), ExitedWithCode(5),
              said);
  EXPECT_EXIT(Main({file, "--particles", "5"}, ExitWithParticles), ExitedWithCode(5), said);
  EXPECT_EXIT(Main({"--verbose_map", file}, [] { std::exit(FLAGS_verbose_map ? 3 : 4); }),
              ExitedWithCode(3), "--verbose_map=true [^\n]* wins over false of many.flags");
  EXPECT_EXIT(
      Main({"--particles=5", file}, [] { std::exit(static_cast<int>(FlagOverrides().size())); }),
      ExitedWithCode(1), said);
}

TEST(RunApp, AFlagThatAgreesWithTheFlagFileOverridesNothing) {
  const TemporaryFolder folder;
  const std::string path = folder.FileWith("many.flags", "--particles=40\n--noverbose_map\n");
  EXPECT_EXIT(
      Main({"--verbose_map=false", "--particles=40", "--flagfile=" + path}, ExitWithParticles),
      ExitedWithCode(40), "^$");
}

TEST(RunApp, TheLaterFlagFileWins) {
  const TemporaryFolder folder;
  const std::string few = folder.FileWith("few.flags", "--particles=4\n");
  const std::string many = folder.FileWith("many.flags", "--particles=40\n");
  const std::string nested =
      folder.FileWith("nested.flags", "--flagfile=" + many + "\n--particles=9\n");
  EXPECT_EXIT(Main({"--flagfile=" + few, "--flagfile=" + many}, ExitWithParticles),
              ExitedWithCode(40), "^$");
  EXPECT_EXIT(Main({"--flagfile=" + many, "--flagfile=" + few}, ExitWithParticles),
              ExitedWithCode(4), "^$");
  EXPECT_EXIT(Main({"--flagfile=" + nested}, ExitWithParticles), ExitedWithCode(9), "^$");
  EXPECT_EXIT(
      Main({"--particles=5", "--flagfile=" + few, "--flagfile=" + nested}, ExitWithParticles),
      ExitedWithCode(5), "^tool: --particles=5 [^\n]* 9 of nested.flags\n$");
}

TEST(RunApp, RefusesMistakesInFlagFiles) {
  const TemporaryFolder folder;
  for (const std::string line : {"--particels=7", "particles=7", "--particles", "---particles=7",
                                 "--noparticles", "--noverbose_map=1"}) {
    const std::string path = folder.FileWith("bad.flags", "--particles=8\n" + line + "\n");
    const std::string error = "^tool: error: [^\n]*bad.flags:2: expected [^\n]*'" + line + "'\n$";
    EXPECT_EXIT(Main({"--flagfile=" + path}, Nothing), ExitedWithCode(1), error);
    EXPECT_EXIT(Main({"-flagfile", path}, Nothing), ExitedWithCode(1), error);
    const std::string outer = folder.FileWith("outer.flags", "--flagfile=" + path + "\n");
    EXPECT_EXIT(Main({"--flagfile=" + outer}, Nothing), ExitedWithCode(1), error);
  }
}

TEST(RunApp, ReadsFlagFilesThatOtherSystemsWrote) {
  const TemporaryFolder folder;
  const std::string path = folder.FileWith(
      "windows.flags", "\xEF\xBB\xBF# Windows\r\n--particles=7 \r\n--noverbose-map\r\n");
  EXPECT_EXIT(Main({"--flagfile=" + path},
                   [] { std::exit(FLAGS_particles + (FLAGS_verbose_map ? 100 : 0)); }),
              ExitedWithCode(7), "^$");
}

TEST(RunApp, RefusesBadValuesInFlagFilesWithTheirLine) {
  const TemporaryFolder folder;
  const std::string path = folder.FileWith("bad.flags", "\n--particles=many\n");
  EXPECT_EXIT(Main({"--flagfile=" + path}, Nothing), ExitedWithCode(1),
              "^tool: error: [^\n]*bad.flags:2: --particles: expected a value of type int32, found "
              "'many'\n$");
}

TEST(RunApp, RefusesWhatIsNoFlagFile) {
  const TemporaryFolder folder;
  for (const std::string path : {"/nowhere/at.all", ".", "", "/dev/null"}) {
    EXPECT_EXIT(Main({"--flagfile=" + path}, Nothing), ExitedWithCode(1),
                "^tool: error: --flagfile: expected the path of a file, found '" + path + "'\n$");
  }
}

TEST(RunApp, RefusesFlagFilesThatNameThemselves) {
  const TemporaryFolder folder;
  const std::string path = folder.FileWith("a.flags", "");
  const std::string other = folder.FileWith("b.flags", "--flagfile=" + path + "\n");
  folder.FileWith("a.flags", "--particles=4\n--flagfile=" + other + "\n");
  EXPECT_EXIT(Main({"--flagfile=" + path}, Nothing), ExitedWithCode(1),
              "^tool: error: [^\n]*b.flags:1: expected a file that does not name itself, found "
              "[^\n]*\n$");
}

TEST(RunApp, SignalsInterruptAtTheNextItem) {
  for (const int signal : {SIGINT, SIGTERM}) {
    EXPECT_EXIT(Main({},
                     [signal] {
                       ThrowIfInterrupted();
                       std::raise(signal);
                       ThrowIfInterrupted();
                     }),
                ExitedWithCode(128 + signal), "^tool: interrupted\n$");
  }
}

TEST(RunApp, ASecondSignalEndsWorkThatDoesNotListen) {
  EXPECT_EXIT(Main({},
                   [] {
                     std::raise(SIGINT);
                     std::raise(SIGINT);
                   }),
              testing::KilledBySignal(SIGINT), "^$");
}

}  // namespace
}  // namespace gmapping_spa::apps
