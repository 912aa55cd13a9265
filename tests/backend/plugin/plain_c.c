// SPDX-License-Identifier: BSD-3-Clause
/* A back end in C: what crosses the boundary is no C++. It moves the node that the last edge ends at. */
#include <stdlib.h>

#include "backend/plugin/plugin_abi.h"

static int dummy;

static void* Create(const struct GmappingSpaReport* report) {
  (void)report;
  return &dummy;
}

static void Destroy(void* optimizer) { (void)optimizer; }

static void Optimize(void* optimizer, const struct GmappingSpaOptions* options,
                     const struct GmappingSpaGraph* graph, const struct GmappingSpaReport* report) {
  const struct GmappingSpaIteration iteration = {7.0, 0.0, 0.0, 0.0, 0.0};
  size_t k;
  (void)optimizer;
  for (k = 0; k < graph->node_count; ++k) {
    if (graph->nodes[k].id == (int64_t)graph->node_count - 1) {
      graph->nodes[k].x_m = atof(options->settings[0].value);
    }
  }
  report->add_iteration(report->context, &iteration);
  report->set_outcome(report->context, GMAPPING_SPA_NO_CONVERGENCE, "moved the last node", 7.0, 7.0);
}

static const struct GmappingSpaSettingDescription kSettings[] = {
    {"x_m", GMAPPING_SPA_SETTING_NUMBER, "0", -10.0, 10.0, NULL, "where the node goes, in m"}};

static const struct GmappingSpaPlugin kPlugin = {GMAPPING_SPA_PLUGIN_ABI_VERSION,
                                                 "plain_c",
                                                 "moves one node",
                                                 kSettings,
                                                 1,
                                                 1U << GMAPPING_SPA_LOSS_NONE,
                                                 &Create,
                                                 &Destroy,
                                                 &Optimize};

__attribute__((visibility("default"))) const struct GmappingSpaPlugin* gmapping_spa_backend_plugin(
    void) {
  return &kPlugin;
}
