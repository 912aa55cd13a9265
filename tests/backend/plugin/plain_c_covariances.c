// SPDX-License-Identifier: BSD-3-Clause
/* The back end of plain_c.c, with the ability to tell covariances: numbers that say where they are. */
#include "tests/backend/plugin/plain_c.c"

__attribute__((visibility("default"))) void gmapping_spa_backend_covariances(
    void* optimizer, const struct GmappingSpaGraph* graph, const struct GmappingSpaNodePair* pairs,
    size_t pair_count, double* covariances, const struct GmappingSpaReport* report) {
  size_t k;
  int a, b;
  (void)optimizer;
  if (graph->node_count == 0) {
    report->set_outcome(report->context, GMAPPING_SPA_FAILURE, "no graph, no covariances", 0.0, 0.0);
    return;
  }
  for (k = 0; k < pair_count; ++k) {
    for (a = 0; a < 3; ++a) {
      for (b = 0; b < 3; ++b) {
        covariances[9 * k + 3 * a + b] = (10000 * pairs[k].i + 100 * pairs[k].j + 10 * a + b) / 1e4;
      }
    }
  }
  report->set_outcome(report->context, GMAPPING_SPA_CONVERGED, "", 0.0, 0.0);
}
