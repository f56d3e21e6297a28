// The chart of a curved face: its triangles as cells.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mesh/chart_map.hpp"
#include "page/sheet.hpp"

namespace quadrille::page {

namespace {

Quantity scales(const Chart& chart) {
  Quantity quantity{"length in space / length in the chart", "", 0, 0, {}, true};
  for (int e = 0; e < chart.num_elems(); ++e) {
    double sum = 0;
    for (int i = 0; i < chart.nodes_per_elem(); ++i) sum += chart.log_scale[e * chart.nodes_per_elem() + i];
    quantity.values.push_back(std::exp(sum / chart.nodes_per_elem()));
  }
  return quantity;
}

}  // namespace

Sheet stage_sheet(const ChartedFace& charted, const PageFrame& frame) {
  const Chart& chart = *charted.face.chart;
  const auto [least, greatest] = std::minmax_element(chart.log_scale.begin(), chart.log_scale.end());
  Sheet sheet;
  sheet.title = "Chart";
  sheet.caption = fmt::format("{} triangles of order {} on {} surface{}", chart.num_elems(), chart.order,
                              chart.surfaces.size(), chart.surfaces.size() == 1 ? "" : "s");
  sheet.facts = {{"triangles", std::to_string(chart.num_elems())},
                 {"order", std::to_string(chart.order)},
                 {"least scale", draw::figure_text(std::exp(*least))},
                 {"greatest scale", draw::figure_text(std::exp(*greatest))},
                 {"error of angles", draw::figure_text(chart.closedness)}};
  sheet.layers.push_back(triangle_layer(mesh::chart_triangles(charted.face), {scales(chart)}, true, frame));
  return sheet;
}

}  // namespace quadrille::page
