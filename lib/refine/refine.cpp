#include "refine/refine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "base/error.hpp"
#include "mesh/chords.hpp"
#include "refine/align_chords.hpp"
#include "refine/divide_arcs.hpp"
#include "refine/split_isoparametric.hpp"
#include "spectral/quad_map.hpp"

namespace quadrille {
namespace {

constexpr double max_element_nodes = 1e8;

std::vector<Vec2> element_nodes(const QuadMesh& mesh, int elem) {
  std::vector<Vec2> nodes;
  const int count = mesh.nodes_per_elem();
  for (int k = 0; k < count; ++k) nodes.push_back(mesh.nodes[mesh.elem_nodes[elem * count + k]]);
  return nodes;
}

/// Fills in bounds and scaled Jacobians.
void measure(QuadMesh& mesh) {
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const std::vector<Vec2> nodes = element_nodes(mesh, elem);
    mesh.elem_jacobian_bound.push_back(quad_jacobian_lower_bound(mesh.order, nodes.data()));
    mesh.elem_scaled_jacobian.push_back(quad_scaled_jacobian(mesh.order, nodes.data()));
  }
}

bool is_valid(const QuadMesh& mesh) {
  return std::all_of(mesh.elem_jacobian_bound.begin(), mesh.elem_jacobian_bound.end(), [](double b) { return b > 0; });
}

using ArcEnds = std::vector<std::vector<double>>;

/// A slip of the pen in the size must not fill the memory.
void require_bounded_size(const BlockLayout& layout, const ArcEnds& arc_ends, int order) {
  double num_elems = 0;
  for (const std::array<int, 4>& sides : layout.block2arcs)
    num_elems += static_cast<double>(arc_ends[arc_of(sides[0])].size() - 1) *
                 static_cast<double>(arc_ends[arc_of(sides[1])].size() - 1);
  if (num_elems * (order + 1) * (order + 1) > max_element_nodes)
    throw ComputeError(
        fmt::format("size and geometric tolerance ask for {:.0f} elements of order {}, which is more "
                    "than this program can hold",
                    num_elems, order));
}

void require_valid_elements(const QuadMesh& mesh) {
  const auto worst = std::min_element(mesh.elem_jacobian_bound.begin(), mesh.elem_jacobian_bound.end());
  if (worst == mesh.elem_jacobian_bound.end() || *worst > 0) return;
  const int elem = static_cast<int>(worst - mesh.elem_jacobian_bound.begin());
  const Vec2 place = quad_position(mesh.order, element_nodes(mesh, elem).data(), {0, 0}) + mesh.face.origin;
  const auto invalid = std::count_if(mesh.elem_jacobian_bound.begin(), mesh.elem_jacobian_bound.end(),
                                     [](double bound) { return !(bound > 0); });
  throw ComputeError(fmt::format(
      "{} of {} elements cannot be proved valid; the worst lies at ({:.6g}, {:.6g}) in {}: det J is only known to be "
      "at least {:.3g}",
      invalid, mesh.num_elems(), place.x, place.y, mesh.block_names[mesh.elem_block[elem]], *worst));
}

void tell(const QuadMesh& mesh, std::size_t num_chords, Report& report) {
  const auto least = [](const std::vector<double>& values) { return *std::min_element(values.begin(), values.end()); };
  report.set("quads", mesh.num_elems());
  report.set("nodes", mesh.nodes.size());
  report.set("blocks", mesh.block_names.size());
  report.set("chords", num_chords);
  report.set("irregular_nodes", mesh.num_irregular);
  report.set("least_jacobian_bound", least(mesh.elem_jacobian_bound));
  report.set("least_scaled_jacobian", least(mesh.elem_scaled_jacobian));
}

}  // namespace

void RefineOptions::validate() const {
  if (size < 0) throw UsageError("--size must not be negative");
  if (order < 1 || order > 20) throw UsageError("--order must lie in 1..20");
  if (!(geometry_tol > 0)) throw UsageError("--geometry-tol must be positive");
}

QuadMesh refine(const BlockLayout& layout, const RefineOptions& options, Report& report) {
  options.validate();
  const CurveTable table(layout.face, layout.splines);
  std::vector<Chain> chains;
  for (const GraphArc& arc : layout.arcs) chains.emplace_back(table, arc.pieces);
  const std::vector<Chord> chords =
      directed_chords(layout.block2arcs, arc_chords(layout.block2arcs, static_cast<int>(layout.arcs.size())));

  const double diameter = layout.face.diameter;
  const DivideOptions division{options.size > 0 ? options.size : diameter / 20, options.order,
                               options.geometry_tol * diameter};
  const auto split_at = [&](const std::vector<ArcParameter>& parameters) {
    const ArcEnds arc_ends = divide_arcs(layout, chords, table, chains, parameters, division);
    require_bounded_size(layout, arc_ends, options.order);
    QuadMesh mesh = split_isoparametric(layout, chains, arc_ends, options.order);
    measure(mesh);
    return mesh;
  };

  const std::vector<ArcParameter> aligned = align_chords(chords, chains);
  QuadMesh mesh = split_at(aligned);
  if (!is_valid(mesh) && !std::all_of(aligned.begin(), aligned.end(), std::mem_fn(&ArcParameter::is_identity))) {
    QuadMesh plain = split_at(std::vector<ArcParameter>(chains.size()));
    if (is_valid(plain)) mesh = std::move(plain);
  }
  require_valid_elements(mesh);
  tell(mesh, chords.size(), report);
  return mesh;
}

}  // namespace quadrille
