// SPDX-License-Identifier: BSD-3-Clause
/* What crosses the boundary between this software and a back end in a shared library: plain C, so
 * that the two may come from different compilers, languages and settings. Authors in C++ use
 * plugin.h instead. All strings end with a zero byte; they and all arrays belong to the side that
 * made them, and are there until the call returns (those of a GmappingSpaPlugin: for ever). */
#ifndef GMAPPING_SPA_BACKEND_PLUGIN_PLUGIN_ABI_H_
#define GMAPPING_SPA_BACKEND_PLUGIN_PLUGIN_ABI_H_

/* The modern C++ of the same would be no C. NOLINTBEGIN(modernize-*) */
#include <stddef.h>
#include <stdint.h>

/* Raised with every change of what follows but abilities, at the end. */
#define GMAPPING_SPA_PLUGIN_ABI_VERSION 2

/* The one symbol of a plugin: a function without arguments that returns a
 * `const struct GmappingSpaPlugin*`. */
#define GMAPPING_SPA_PLUGIN_ENTRY_POINT "gmapping_spa_backend_plugin"

/* A robot pose in the world frame. An optimizer changes x_m, y_m and theta_rad of nodes that are
 * not held: `fixed` ones are, and the first node of each connected component without one. */
struct GmappingSpaNode {
  int64_t id;
  double stamp_s;
  double x_m;
  double y_m;
  double theta_rad;
  uint8_t fixed;
};

enum GmappingSpaEdgeKind {
  GMAPPING_SPA_EDGE_ODOMETRY = 0,
  GMAPPING_SPA_EDGE_SCAN_MATCH = 1,
  GMAPPING_SPA_EDGE_LOOP_CLOSURE = 2
};

/* The measured pose of node j in the frame of node i, and its 3 x 3 information matrix, the inverse
 * covariance of (x, y, theta), symmetric. */
struct GmappingSpaEdge {
  int64_t i;
  int64_t j;
  double x_m;
  double y_m;
  double theta_rad;
  double information[9];
  uint8_t kind;
};

/* Losses of loop closures: robust_loss.h defines them. */
enum GmappingSpaLossKind {
  GMAPPING_SPA_LOSS_NONE = 0,
  GMAPPING_SPA_LOSS_HUBER = 1,
  GMAPPING_SPA_LOSS_CAUCHY = 2,
  GMAPPING_SPA_LOSS_DCS = 3,
  GMAPPING_SPA_LOSS_TRUNCATED = 4
};

struct GmappingSpaLoss {
  int32_t kind;
  double scale;
  double control;
};

enum GmappingSpaSettingType {
  GMAPPING_SPA_SETTING_NUMBER = 0,
  GMAPPING_SPA_SETTING_INTEGER = 1,
  GMAPPING_SPA_SETTING_BOOLEAN = 2, /* true or false */
  GMAPPING_SPA_SETTING_CHOICE = 3   /* one of several words */
};

/* A setting that a back end has beside the options of all. The program refuses settings that are
 * not described, or whose value does not fit, before it calls the back end. */
struct GmappingSpaSettingDescription {
  const char* name;
  int32_t type;              /* a GmappingSpaSettingType */
  const char* default_value; /* as a user would write it */
  double minimum;            /* of numbers and integers; may be infinite */
  double maximum;
  const char* choices; /* words separated by commas; null for other types */
  const char* help;    /* one line: quantity, unit, meaning */
};

/* A setting that the user gave: checked, not parsed. */
struct GmappingSpaSetting {
  const char* name;
  const char* value;
};

struct GmappingSpaOptions {
  int32_t max_iterations;
  uint8_t keep_start;          /* 1: start from the given poses; 0: from where the back end likes */
  double cost_tolerance;       /* converged when a step would lower the cost by a smaller part */
  double max_solver_time_s;    /* return the best poses so far after this time; may be infinite */
  struct GmappingSpaLoss loss; /* of loop closures; one of those that the table says */
  const struct GmappingSpaSetting* settings;
  size_t setting_count;
};

struct GmappingSpaGraph {
  struct GmappingSpaNode* nodes;
  size_t node_count;
  const struct GmappingSpaEdge* edges;
  size_t edge_count;
};

enum GmappingSpaTermination {
  GMAPPING_SPA_CONVERGED = 0,
  GMAPPING_SPA_NO_CONVERGENCE = 1, /* out of iterations or time */
  GMAPPING_SPA_FAILURE = 2         /* the poses are as they were */
};

struct GmappingSpaIteration {
  double cost;
  double step_norm;
  double damping;
  double linear_solver_s;
  double total_s;
};

/* Where a plugin reports. The functions take `context` as it is. */
struct GmappingSpaReport {
  void* context;
  void (*set_outcome)(void* context, int32_t termination, const char* message, double initial_cost,
                      double final_cost);
  void (*add_iteration)(void* context, const struct GmappingSpaIteration* iteration);
};

/* What a plugin is. */
struct GmappingSpaPlugin {
  uint32_t abi_version; /* GMAPPING_SPA_PLUGIN_ABI_VERSION; stays the first member for ever */
  const char* name;
  const char* description; /* one line */
  const struct GmappingSpaSettingDescription* settings;
  size_t setting_count;
  uint32_t losses; /* bit 1 << kind for each GmappingSpaLossKind that it supports */
  /* Makes an optimizer; on failure reports it and returns null. */
  void* (*create)(const struct GmappingSpaReport* report);
  void (*destroy)(void* optimizer);
  /* Improves the poses of the graph: the contract is that of backend::Optimizer, optimizer.h. */
  void (*optimize)(void* optimizer, const struct GmappingSpaOptions* options,
                   const struct GmappingSpaGraph* graph, const struct GmappingSpaReport* report);
};

/* What follows are abilities that a plugin may have: each is a symbol of its own beside the entry
 * point, and a plugin without it has not the ability. They come and go without a new version. */

/* Two nodes by their positions among those of a graph. */
struct GmappingSpaNodePair {
  int32_t i;
  int32_t j;
};

/* The ability to tell covariances: a GmappingSpaCovariancesFunction. */
#define GMAPPING_SPA_COVARIANCES_ENTRY_POINT "gmapping_spa_backend_covariances"

/* Writes for each pair the 3 x 3 covariance, by rows, between the pose of i and that of j: the
 * contract is that of backend::Optimizer::Covariances, optimizer.h. Changes nothing of the graph.
 * Reports GMAPPING_SPA_CONVERGED, or GMAPPING_SPA_FAILURE with a message when there are none; costs
 * are not looked at. `optimizer` is one that `create` has made. */
typedef void (*GmappingSpaCovariancesFunction)(void* optimizer,
                                               const struct GmappingSpaGraph* graph,
                                               const struct GmappingSpaNodePair* pairs,
                                               size_t pair_count, double* covariances,
                                               const struct GmappingSpaReport* report);

/* The ability to go on in another process: a function without arguments that returns a
 * `const struct GmappingSpaStateFunctions*`. */
#define GMAPPING_SPA_STATE_ENTRY_POINT "gmapping_spa_backend_state"

/* The contract is that of backend::Optimizer::State and SetState, optimizer.h. Both report
 * GMAPPING_SPA_CONVERGED, or GMAPPING_SPA_FAILURE with a message; costs are not looked at. */
struct GmappingSpaStateFunctions {
  /* Calls `take` once, with the state and `context` as it is. */
  void (*save)(void* optimizer, void* context,
               void (*take)(void* context, const char* bytes, size_t size),
               const struct GmappingSpaReport* report);
  void (*restore)(void* optimizer, const char* bytes, size_t size,
                  const struct GmappingSpaReport* report);
};
/* NOLINTEND(modernize-*) */

#endif /* GMAPPING_SPA_BACKEND_PLUGIN_PLUGIN_ABI_H_ */
