// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/graph_picture.h"

#include <cairo.h>

#include <algorithm>
#include <limits>

#include "backend/graph/graph_index.h"
#include "experiments/apps/png_canvas.h"

namespace gmapping_spa::apps {
namespace {

using backend::PoseGraph;

constexpr double kPanel_px = 900.0;
constexpr double kMargin_px = 30.0;

struct Box {
  double min_x = std::numeric_limits<double>::infinity(), max_x = -min_x;
  double min_y = min_x, max_y = -min_x;
};

Box BoxAround(const PoseGraph& graph) {
  Box box;
  for (const backend::Node& node : graph.nodes) {
    box.min_x = std::min(box.min_x, node.world_T_node.x);
    box.max_x = std::max(box.max_x, node.world_T_node.x);
    box.min_y = std::min(box.min_y, node.world_T_node.y);
    box.max_y = std::max(box.max_y, node.world_T_node.y);
  }
  return box;
}

void DrawEdges(const PoseGraph& graph, const backend::GraphIndex& index, bool loop_closures,
               cairo_t* cairo) {
  for (std::size_t k = 0; k < graph.edges.size(); ++k) {
    if ((graph.edges[k].kind == backend::EdgeKind::kLoopClosure) != loop_closures) continue;
    const backend::SE2& from = graph.nodes[index.edges[k].i].world_T_node;
    const backend::SE2& to = graph.nodes[index.edges[k].j].world_T_node;
    cairo_move_to(cairo, from.x, from.y);
    cairo_line_to(cairo, to.x, to.y);
  }
  // The pen is as wide as a pixel, not as a metre.
  cairo_save(cairo);
  cairo_identity_matrix(cairo);
  cairo_stroke(cairo);
  cairo_restore(cairo);
}

void DrawPanel(const PoseGraph& graph, double left_px, cairo_t* cairo) {
  if (graph.nodes.empty()) return;
  const Box box = BoxAround(graph);
  const double extent = std::max({box.max_x - box.min_x, box.max_y - box.min_y, 1e-9});
  const double scale = (kPanel_px - 2 * kMargin_px) / extent;
  cairo_save(cairo);
  cairo_translate(cairo, left_px + kPanel_px / 2, kPanel_px / 2);
  cairo_scale(cairo, scale, -scale);
  cairo_translate(cairo, -(box.min_x + box.max_x) / 2, -(box.min_y + box.max_y) / 2);
  const backend::GraphIndex index = IndexGraph(graph);
  cairo_set_source_rgb(cairo, 0.8, 0.2, 0.2);
  DrawEdges(graph, index, /*loop_closures=*/true, cairo);
  cairo_set_source_rgb(cairo, 0.1, 0.2, 0.7);
  DrawEdges(graph, index, /*loop_closures=*/false, cairo);
  cairo_restore(cairo);
}

}  // namespace

void WriteGraphPicture(const PoseGraph& before, const PoseGraph& after,
                       const std::string& png_path) {
  const PngCanvas canvas(static_cast<int>(2 * kPanel_px), static_cast<int>(kPanel_px));
  cairo_t* const cairo = canvas.context();
  cairo_set_source_rgb(cairo, 1.0, 1.0, 1.0);
  cairo_paint(cairo);
  cairo_set_line_width(cairo, 1.0);
  DrawPanel(before, 0.0, cairo);
  DrawPanel(after, kPanel_px, cairo);
  canvas.Write(png_path);
}

}  // namespace gmapping_spa::apps
