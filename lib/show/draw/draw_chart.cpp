// Draws the chart of a curved face: its triangles, coloured by the scale.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "draw/labels.hpp"
#include "draw/marks.hpp"

namespace quadrille::draw {

namespace {

/// Mean of a triangle's nodes.
double log_scale_of(const Chart& chart, int elem) {
  double sum = 0;
  for (int i = 0; i < chart.nodes_per_elem(); ++i) sum += chart.log_scale[elem * chart.nodes_per_elem() + i];
  return sum / chart.nodes_per_elem();
}

}  // namespace

std::string draw_stage(const ChartedFace& charted, const DrawOptions& options) {
  const CadFace& face = charted.face;
  const Chart& chart = *face.chart;
  const auto [least, greatest] = std::minmax_element(chart.log_scale.begin(), chart.log_scale.end());
  const double low = *least, range = std::max(*greatest - *least, 1e-9);
  Picture picture(shown_box(bounding_box(face), face.origin, options), options, "Chart",
                  fmt::format("{} of order {}; lengths in space are {:.3g} to {:.3g} times those in the chart, angles "
                              "differ by about {:.1g}",
                              counted(chart.num_elems(), "triangle"), chart.order, std::exp(low), std::exp(*greatest),
                              chart.closedness));
  const Ramp& ramp = palette(Paper::light).amount;
  picture.open_group("elems");
  for (int e = 0; e < chart.num_elems(); ++e) {
    const spectral::TriMap map(chart.order, chart.nodes.data() + e * chart.nodes_per_elem());
    const double lambda = log_scale_of(chart, e);
    picture.add(svg_element(
        "path",
        {{"id", fmt::format("elem-{}", e)},
         {"fill", ramp_colour(ramp, (lambda - low) / range)},
         {"d", tri_outline(picture, map).str()}},
        fmt::format("triangle {} of surface {}, scale {:.4g}", e, chart.elem_surface[e], std::exp(lambda))));
  }
  picture.close_group();
  draw_boundary(picture, face);
  draw_corners(picture, face);
  picture.legend_bar(ramp, "length in space / length in the chart",
                     {fmt::format("{:.3g}", std::exp(low)), fmt::format("{:.3g}", std::exp(low + range))});
  legend_corner(picture, face);
  label_curves(picture, face, options.curve_labels);
  legend_scale(picture, face);
  return picture.str();
}

}  // namespace quadrille::draw
