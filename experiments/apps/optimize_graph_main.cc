// SPDX-License-Identifier: BSD-3-Clause
// Optimizes a pose graph with any back end and prints the summary as JSON.
#include <gflags/gflags.h>
#include <glog/logging.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "backend/graph/g2o_io.h"
#include "backend/graph/stamps_io.h"
#include "backend/out_of_memory.h"
#include "backend/plugin/plugin_loader.h"
#include "backend/scheduling/certify_result.h"
#include "backend/scheduling/optimize.h"
#include "experiments/apps/app.h"
#include "experiments/apps/backend_flags.h"
#include "experiments/apps/certificate_record.h"
#include "experiments/apps/covariance_table.h"
#include "experiments/apps/graph_picture.h"
#include "experiments/apps/graph_stamps.h"
#include "experiments/apps/input_file.h"
#include "experiments/apps/interruptible.h"
#include "experiments/apps/json.h"
#include "experiments/apps/optimization_record.h"
#include "experiments/apps/output_files.h"

DEFINE_string(input, "", "File of the pose graph, .g2o or TORO's .graph, plain or gzipped.");
DEFINE_string(
    output, "",
    "File that gets the optimized graph as .g2o, and the one of its stamps beside it where "
    "the input has stamps. Empty: none.");
DEFINE_string(png, "", "PNG file that gets a picture of the graph before and after. Empty: none.");
DEFINE_bool(certify, false,
            "Prove that the optimized poses are the global optimum of least squares; `certificate` "
            "in the JSON says of which edges, and how near. Exit status 2 when that fails.");
DEFINE_bool(certify_descend, true,
            "With --certify, leave poses that are not proved to be optimal for better ones. "
            "Without it, the poses of the back end are certified as they are.");
DEFINE_string(covariances, "",
              "CSV file that gets covariances of the optimized poses, in m and rad; its first line "
              "says of what, in which frame and from which edges. Empty: none.");
DEFINE_string(covariances_of, "all",
              "What --covariances has: all (each node, relative to the held node of its "
              "component), ids of nodes (3,7,12), or pairs of ids (3:7,12:40: the pose of the "
              "second node in the frame of the first).");
DEFINE_bool(strict, false,
            "Refuse an input with records that would be left out or taken for something else, such "
            "as edges from a vertex to itself. Without it, they are counted and said.");
DEFINE_bool(verbose, false, "Print a table of the iterations of the optimization to stderr.");
DEFINE_bool(list_backends, false, "List the back ends that --backend finds, and exit.");

namespace gmapping_spa::apps {
namespace {

namespace fs = std::filesystem;
using backend::PoseGraph;
using backend::Summary;

void ListBackends() {
  for (const backend::BackendDescription& found :
       backend::ListBackends(backend::PluginSearchPath())) {
    std::cout << found.name << (found.loadable ? "" : " (unusable)") << "\n    " << found.path
              << "\n    " << found.description << '\n';
    if (found.loadable) {
      std::cout << "    losses: " << found.losses << "\n    covariances: "
                << (found.has_covariances ? "its own" : "left to the program") << '\n';
    }
    for (const backend::SettingDescription& setting : found.settings) {
      std::cout << "    " << setting.name << " (" << backend::RangeOf(setting) << ", default "
                << setting.default_value << "): " << setting.help << '\n';
    }
  }
}

void PrintTable(const Summary& summary) {
  std::cerr << "iteration            cost       step    damping  solver_ms   total_ms\n";
  int number = 0;
  for (const backend::IterationRecord& record : summary.iterations) {
    std::cerr << std::setw(9) << ++number << std::setprecision(10) << std::setw(16) << record.cost
              << std::setprecision(3) << std::setw(11) << record.step_norm << std::setw(11)
              << record.damping << std::setw(11) << 1e3 * record.linear_solver_s << std::setw(11)
              << 1e3 * record.total_s << '\n';
  }
}

std::string NameOf(const std::string& path) {
  std::string name = fs::path(path).filename().string();
  if (name.empty()) throw std::runtime_error(path + ": expected the name of a file");
  return name;
}

// Files that appear whole or not at all: those of one folder together.
class Outputs {
 public:
  // The set of the folder of a file that will be written. An empty path: none. Throws when that
  // file is added already.
  void Add(const std::string& path) {
    if (path.empty()) return;
    const fs::path file = fs::path(FolderOf(path)) / NameOf(path);
    if (!files_.insert(fs::weakly_canonical(file)).second) {
      throw std::runtime_error(path + ": is the file of two outputs");
    }
    sets_.try_emplace(FolderOf(path), FolderOf(path));
  }
  OutputFiles& Of(const std::string& path) { return sets_.at(FolderOf(path)); }
  void Commit() {
    for (auto& [folder, files] : sets_) files.Commit();
  }

 private:
  static std::string FolderOf(const std::string& path) {
    const fs::path folder = fs::path(path).parent_path();
    return folder.empty() ? "." : folder.lexically_normal().string();
  }
  std::map<std::string, OutputFiles> sets_;
  std::set<fs::path> files_;
};

// Of this process, and of a back end's own once it has ended.
std::int64_t CpuTime_us() {
  std::int64_t time_us = 0;
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    getrusage(who, &usage);
    for (const timeval& time : {usage.ru_utime, usage.ru_stime}) {
      time_us += 1'000'000 * std::int64_t{time.tv_sec} + time.tv_usec;
    }
  }
  return time_us;
}

using Optimized = std::tuple<PoseGraph, Summary>;

Optimized Optimize(std::shared_ptr<backend::Optimizer> optimizer, PoseGraph graph) {
  return RunInterruptibly<Optimized>(
      [optimizer = std::move(optimizer), graph = std::move(graph)]() mutable {
        Summary summary = OptimizeAsFlagsSay(optimizer.get(), &graph);
        return Optimized{std::move(graph), std::move(summary)};
      },
      "interrupted: the back end " + BackendFromFlags() + " was still at work; nothing is written");
}

void Run() {
  if (FLAGS_list_backends) {
    ListBackends();
    return;
  }
  if (FLAGS_input.empty()) throw std::runtime_error("--input=FILE is missing");
  OptionsFromFlags();  // mistakes in flags come before work
  const CovarianceChoice choice = ParseCovarianceChoice("--covariances_of", FLAGS_covariances_of);
  Outputs outputs;
  for (const std::string& path : {FLAGS_output, FLAGS_png, FLAGS_covariances}) outputs.Add(path);
  const bool has_stamps = fs::exists(StampsPathOf(FLAGS_input));
  const std::string stamps_path = StampsPathOf(FLAGS_output);
  if (has_stamps) {
    outputs.Add(stamps_path);
  } else if (fs::exists(stamps_path)) {
    throw std::runtime_error(stamps_path +
                             ": expected no such file, which would be taken for the "
                             "stamps of " +
                             FLAGS_output + ": " + FLAGS_input + " has none");
  }
  for (const std::string& path : {FLAGS_png, FLAGS_covariances}) {
    std::error_code unknown;
    if (fs::equivalent(path, FLAGS_input, unknown)) {
      throw std::runtime_error(path + ": is the input, which would be replaced by something else");
    }
  }
  const std::shared_ptr<backend::Optimizer> optimizer = LoadOptimizerFromFlags();
  const std::unique_ptr<backend::Optimizer> minimizer =
      FLAGS_certify ? backend::LoadOptimizer("spa") : nullptr;
  backend::G2oRemarks remarks;
  PoseGraph graph = backend::WithMemory("while reading " + FLAGS_input, [&] {
    return backend::ReadG2o(*OpenInput(FLAGS_input), FLAGS_input, {.strict = FLAGS_strict},
                            &remarks);
  });
  for (const auto& [remark, count] : remarks) {
    LOG(WARNING) << FLAGS_input << ": " << remark << " (" << count << ")";
  }
  ReadStampsBeside(FLAGS_input, &graph);
  if (graph.nodes.empty()) LOG(WARNING) << FLAGS_input << ": holds no vertices and no edges";
  ThrowIfInterrupted();
  std::optional<PoseGraph> before;
  if (!FLAGS_png.empty()) before = graph;

  ReleaseFreedMemory();
  const std::int64_t start_us = CpuTime_us();
  Summary summary;
  std::tie(graph, summary) =
      backend::WithMemory("while optimizing a graph of " + std::to_string(graph.nodes.size()) +
                              " nodes and " + std::to_string(graph.edges.size()) + " edges",
                          [&] { return Optimize(optimizer, std::move(graph)); });
  const double cpu_s = 1e-6 * static_cast<double>(CpuTime_us() - start_us);
  if (summary.termination == backend::Termination::kFailure) {
    throw std::runtime_error("the back end " + BackendFromFlags() + " failed: " + summary.message);
  }
  ThrowIfInterrupted();
  std::optional<backend::CertifiedResult> certified;
  double certificate_cpu_s = 0.0;
  if (FLAGS_certify) {
    const std::clock_t certificate_start = std::clock();
    certified = backend::CertifyResult(OptionsFromFlags().loss, FLAGS_certify_descend,
                                       minimizer.get(), &graph, &summary);
    certificate_cpu_s = static_cast<double>(std::clock() - certificate_start) / CLOCKS_PER_SEC;
    ThrowIfInterrupted();
  }
  if (FLAGS_verbose) PrintTable(summary);
  if (!FLAGS_output.empty()) {
    outputs.Of(FLAGS_output).Write(NameOf(FLAGS_output), [&](std::ostream& out) {
      backend::WriteG2o(graph, out);
    });
    if (has_stamps) {
      outputs.Of(stamps_path).Write(NameOf(stamps_path), [&](std::ostream& out) {
        backend::WriteStamps(graph, out);
      });
    }
  }
  Json record = OptimizationRecord(FLAGS_input, graph, remarks, summary, cpu_s);
  record["has_stamps"] = has_stamps;
  if (!FLAGS_covariances.empty()) {
    const CovarianceTable table =
        MakeCovarianceTable(graph, choice, OptionsFromFlags().loss, summary, optimizer.get());
    outputs.Of(FLAGS_covariances).Write(NameOf(FLAGS_covariances), [&](std::ostream& out) {
      WriteCovariances(table, out);
    });
    record["covariances"] = ToJson(table);
  }
  if (before) {
    WriteGraphPicture(*before, graph, outputs.Of(FLAGS_png).TemporaryPath(NameOf(FLAGS_png)));
  }
  outputs.Commit();
  if (certified) {
    record["certificate"] = CertificateRecord(*certified);
    record["certificate"]["cpu_s"] = certificate_cpu_s;
  }
  std::cout << TextOf(record) << '\n';
  if (certified && !certified->proved()) throw NegativeAnswer(certified->message);
}

FlagGroups AllFlagGroups() {
  const FlagGroups output = {{"output",
                              "Input and output",
                              {"input", "output", "png", "covariances", "covariances_of", "strict",
                               "verbose", "list_backends"}}};
  const FlagGroups certificate = {{"certificate", "Certificate", {"certify", "certify_descend"}}};
  return Join({output, certificate, BackendFlagGroups()});
}

}  // namespace
}  // namespace gmapping_spa::apps

int main(int argc, char** argv) {
  return gmapping_spa::apps::RunApp(
      argc, argv,
      "optimizes a pose graph and prints a summary as JSON.\n"
      "Usage: optimize_graph --input=FILE [--backend=NAME|PATH] [--output=FILE]\n"
      "       optimize_graph --list_backends",
      gmapping_spa::apps::AllFlagGroups(), gmapping_spa::apps::Run);
}
