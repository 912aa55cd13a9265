// SPDX-License-Identifier: BSD-3-Clause
// Benchmarks of all back ends on the public pose graphs; backends.py makes the table of README.md
// of it. Every run is a new optimizer from the odometry start: ordering, symbolic analysis and
// initialization included, loading the graph and the plugin excluded.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "backend/cost/graph_cost.h"
#include "backend/graph/g2o_io.h"
#include "backend/graph/initial_guess.h"
#include "backend/plugin/plugin_loader.h"

namespace gmapping_spa::backend {
namespace {

struct Contestant {
  const char* name;
  const char* backend;
  Options options;
};

std::vector<Contestant> Contestants() {
  Contestant spa{"spa", "spa", {}};
  Contestant cholmod{"spa_cholmod", "spa", {}};
  cholmod.options.settings = {{"solver", "cholmod"}};
  // The best we could make of Ceres: our chordal start, and a trust region that never binds.
  Contestant ceres{"ceres_best", "ceres", {}};
  ceres.options.initialization = Initialization::kChordal;
  ceres.options.settings = {{"initial_radius", "1e16"}};
  Contestant defaults{"ceres_lm_defaults", "ceres", {}};
  return {spa, cholmod, ceres, defaults};
}

PoseGraph ReadGraph(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot open " + path);
  boost::iostreams::filtering_istream in;
  in.push(boost::iostreams::gzip_decompressor());
  in.push(file);
  return ReadG2o(in, path);
}

void SetPoses(const std::vector<SE2>& poses, PoseGraph* graph) {
  for (std::size_t k = 0; k < poses.size(); ++k) graph->nodes[k].world_T_node = poses[k];
}

// Options for a graph that has the poses of the initialization.
Options OnceInitialized(Options options) {
  if (options.initialization != Initialization::kAuto) {
    options.initialization = Initialization::kKeep;
  }
  return options;
}

void Batch(benchmark::State& state, const std::string& path, const Contestant& contestant) {
  PoseGraph graph = ReadGraph(path);
  std::vector<SE2> start = PosesOf(graph);
  InitializeFromOdometry(graph, IndexGraph(graph), &start);
  Summary summary;
  for (auto _ : state) {
    state.PauseTiming();
    SetPoses(start, &graph);
    std::unique_ptr<Optimizer> optimizer = LoadOptimizer(contestant.backend);
    state.ResumeTiming();
    SetPoses(*InitialPoses(contestant.options.initialization, graph, IndexGraph(graph)), &graph);
    summary = optimizer->Optimize(OnceInitialized(contestant.options), graph.edges, graph.nodes);
    state.PauseTiming();
    optimizer.reset();
    state.ResumeTiming();
  }
  state.counters["iterations_taken"] = static_cast<double>(summary.iterations.size());
  state.counters["cost"] = GraphCost(graph);
}

// The graph arrives node by node; the optimizer takes one iteration after every node with a loop
// closure. Time outside the optimizer is left out.
void Online(benchmark::State& state, const std::string& path, const Contestant& contestant) {
  const PoseGraph whole = ReadGraph(path);
  std::map<std::int64_t, std::vector<Edge>> edges_of_node;
  for (const Edge& edge : whole.edges) edges_of_node[std::max(edge.i, edge.j)].push_back(edge);
  Options options = OnceInitialized(contestant.options);
  options.max_iterations = 1;
  PoseGraph graph;
  for (auto _ : state) {
    state.PauseTiming();
    const std::unique_ptr<Optimizer> optimizer = LoadOptimizer(contestant.backend);
    for (Node node : whole.nodes) {
      bool closure = false;
      for (const Edge& edge : edges_of_node[node.id]) {
        closure = closure || edge.kind == EdgeKind::kLoopClosure;
        if (edge.kind == EdgeKind::kLoopClosure || graph.nodes.empty()) continue;
        node.world_T_node = graph.nodes.back().world_T_node *
                            (edge.j == node.id ? edge.i_T_j : Inverse(edge.i_T_j));
      }
      graph.nodes.push_back(node);
      graph.edges.insert(graph.edges.end(), edges_of_node[node.id].begin(),
                         edges_of_node[node.id].end());
      if (!closure) continue;
      state.ResumeTiming();
      optimizer->Optimize(options, graph.edges, graph.nodes);
      state.PauseTiming();
    }
    state.ResumeTiming();
  }
  state.counters["cost"] = GraphCost(graph);
}

void RegisterAll(const std::string& folder) {
  for (const char* name : {"intel", "MIT", "CSAIL", "manhattan", "kitti_00", "city10000", "M3500a",
                           "M3500b", "M3500c"}) {
    for (const Contestant& contestant : Contestants()) {
      const std::string path = folder + "/" + name + ".g2o.gz";
      benchmark::RegisterBenchmark((std::string(name) + "/" + contestant.name).c_str(),
                                   [=](benchmark::State& state) { Batch(state, path, contestant); })
          ->MeasureProcessCPUTime()
          ->Unit(benchmark::kMillisecond)
          ->Iterations(1);
    }
  }
  for (const Contestant& contestant : Contestants()) {
    benchmark::RegisterBenchmark(
        (std::string("online_manhattan/") + contestant.name).c_str(),
        [=](benchmark::State& state) { Online(state, folder + "/manhattan.g2o.gz", contestant); })
        ->MeasureProcessCPUTime()
        ->Unit(benchmark::kMillisecond)
        ->Iterations(1);
  }
}

}  // namespace
}  // namespace gmapping_spa::backend

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (argc != 2) {
    std::cerr << "Usage: backends_bench FOLDER_OF_GRAPHS [--benchmark_...]\n";
    return 1;
  }
  gmapping_spa::backend::RegisterAll(argv[1]);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
