// Quad meshes: elements as cells, with the measures of their shape.

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/angle.hpp"
#include "mesh/element_sizes.hpp"
#include "mesh/side_key.hpp"
#include "model/quad_mesh.hpp"
#include "page/sheet.hpp"
#include "page/space_data.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::page {

namespace {

/// Values and derivatives at the nine samples of a side, from its nodes.
class SideSampler {
 public:
  explicit SideSampler(int order) {
    const std::vector<double>& points = spectral::gll_points(order);
    std::vector<double> at;
    for (int k = 0; k <= 8; ++k) at.push_back(k / 4.0 - 1);
    values_ = spectral::interpolation_matrix(points, at);
    derivatives_ = 2.0 * values_ * spectral::differentiation_matrix(points);  // along s in [0, 1]
  }

  SideSamples samples(const QuadMesh& mesh, int elem, int side) const {
    SideSamples samples;
    for (int i = 0; i <= mesh.order; ++i) {
      const Vec2 x = mesh.nodes[side_node(mesh, elem, side, i)];
      for (int k = 0; k <= 8; ++k) {
        samples[k].position += values_(k, i) * x;
        samples[k].derivative += derivatives_(k, i) * x;
      }
    }
    return samples;
  }

 private:
  Eigen::MatrixXd values_, derivatives_;
};

struct Cells {
  std::vector<std::int32_t> vertices, ends, elements;
  Bends bends;
  std::vector<double> skewness;  ///< greatest deviation of a corner's angle from 90 degrees, by 90 degrees
};

/// Numbers the corners of elements in the order in which they are met, and appends their positions.
class CornerNumbers {
 public:
  CornerNumbers(const QuadMesh& mesh, const PageFrame& frame, std::vector<std::int32_t>& vertices)
      : mesh_(mesh), frame_(frame), vertices_(vertices), numbers_(mesh.nodes.size(), -1) {}
  int operator()(int node) {
    if (numbers_[node] < 0) {
      numbers_[node] = static_cast<int>(vertices_.size() / 2);
      frame_.append(vertices_, mesh_.nodes[node]);
    }
    return numbers_[node];
  }

 private:
  const QuadMesh& mesh_;
  const PageFrame& frame_;
  std::vector<std::int32_t>& vertices_;
  std::vector<int> numbers_;
};

/// `starts[k]` and `ends[k]`: derivatives along side k at its first and last corner.
double skewness_of(const std::array<Vec2, 4>& starts, const std::array<Vec2, 4>& ends) {
  double greatest = 0;
  for (int k = 0; k < 4; ++k) {
    const Vec2 out = starts[k], back = -ends[(k + 3) % 4];
    greatest = std::max(greatest, std::abs(std::atan2(cross(out, back), dot(out, back)) - half_pi) / half_pi);
  }
  return std::min(greatest, 1.0);
}

Cells cells_of(const QuadMesh& mesh, const PageFrame& frame) {
  Cells cells;
  const SideSampler sampler(mesh.order);
  CornerNumbers corner(mesh, frame, cells.vertices);
  std::map<std::pair<int, int>, int> known;
  for (int e = 0; e < mesh.num_elems(); ++e) {
    std::array<Vec2, 4> starts, ends;
    for (int side = 0; side < 4; ++side) {
      const SideSamples samples = sampler.samples(mesh, e, side);
      starts[side] = samples.front().derivative;
      ends[side] = samples.back().derivative;
      const int next = static_cast<int>(cells.ends.size() / 2);
      const auto [edge, is_new] = known.try_emplace(mesh::side_key(mesh, e, side), next);
      cells.elements.push_back(is_new ? edge->second + 1 : -edge->second - 1);
      if (!is_new) continue;
      for (const int k : {0, mesh.order}) cells.ends.push_back(corner(side_node(mesh, e, side, k)));
      cells.bends.append(samples);
    }
    cells.skewness.push_back(skewness_of(starts, ends));
  }
  return cells;
}

std::vector<Quantity> quantities_of(const QuadMesh& mesh, const Cells& cells) {
  std::vector<Quantity> quantities{{"scaled Jacobian", "low", 0, 1, mesh.elem_scaled_jacobian},
                                   {"edge-length ratio", "high", 0, 0, mesh.elem_edge_ratio, true},
                                   {"area jump", "high", 0, 0, mesh.elem_area_jump, true},
                                   {"skewness", "high", 0, 1, cells.skewness},
                                   bounds_of_jacobian(mesh.elem_jacobian_bound)};
  if (!mesh.elem_prescribed_length.empty())
    quantities.push_back({"size against prescribed", "high", 0, 0, mesh::relative_sizes(mesh), true});
  return quantities;
}

JsonObject cells_layer(const QuadMesh& mesh, const Cells& cells) {
  JsonObject layer;
  layer.text("type", "cells").text("key", "mesh").text("title", "quads").text("noun", "quad");
  layer.number("sides", 4).flag("shown", true).flag("plain", false);
  layer.json("quantities", quantities_json(quantities_of(mesh, cells)));
  layer.data("vertices", packed(cells.vertices)).data("ends", packed(cells.ends));
  layer.data("elements", packed(cells.elements)).data("pieces", packed(cells.bends.pieces));
  layer.data("bends", packed(cells.bends.points));
  layer.data("blocks", packed(mesh.elem_block));
  layer.json("blockNames", json_texts(mesh.block_names));
  return layer;
}

}  // namespace

Sheet stage_sheet(const QuadMesh& mesh, const PageFrame& frame) {
  Sheet sheet;
  const Cells cells = cells_of(mesh, frame);
  sheet.title = "Quad mesh";
  sheet.caption = fmt::format("{}{} quads of order {} in {} blocks",
                              mesh.is_valid ? "" : "NOT VALID: ", mesh.num_elems(), mesh.order, draw::num_blocks(mesh));
  sheet.facts = draw::figures_of(mesh);
  sheet.layers.push_back(cells_layer(mesh, cells));
  if (!mesh.space_nodes.empty()) sheet.space = space_data(mesh).str();
  return sheet;
}

}  // namespace quadrille::page
