#include "refine/refine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <tuple>
#include <utility>

#include "base/error.hpp"
#include "check/check.hpp"
#include "layers/wall_layers.hpp"
#include "mesh/chords.hpp"
#include "refine/align_chords.hpp"
#include "refine/chosen_blocks.hpp"
#include "refine/divide_arcs.hpp"
#include "refine/relax.hpp"
#include "refine/split_isoparametric.hpp"
#include "refine/validity.hpp"
#include "sizing/grade_chords.hpp"
#include "sizing/tell_sizes.hpp"

namespace quadrille::refine {
namespace {

constexpr double max_element_nodes = 1e8;

using ArcEnds = std::vector<std::vector<double>>;

/// A slip of the pen in the size must not fill the memory.
void require_bounded_size(const BlockLayout& layout, const ArcEnds& arc_ends, int order) {
  double num_elems = 0;
  for (const std::array<HalfEdge, 4>& sides : layout.block2arcs)
    num_elems +=
        static_cast<double>(arc_ends[sides[0].arc].size() - 1) * static_cast<double>(arc_ends[sides[1].arc].size() - 1);
  if (num_elems * (order + 1) * (order + 1) > max_element_nodes)
    throw ComputeError(
        fmt::format("size and geometric tolerance ask for {:.0f} elements of order {}, which is more "
                    "than this program can hold",
                    num_elems, order));
}

void tell(const QuadMesh& mesh, std::size_t num_chords, Report& report) {
  report.set("quads", mesh.num_elems());
  report.set("nodes", mesh.nodes.size());
  report.set("blocks", mesh.block_names.size());
  report.set("chords", num_chords);
  report.set("irregular_nodes", mesh.num_irregular);
  tell_validity(mesh, report);
}

/// The elements of all blocks that hold layers: relaxation leaves them alone.
std::vector<bool> elems_at_walls(const QuadMesh& mesh, const std::optional<layers::WallPlan>& walls) {
  std::vector<bool> is_at_wall;
  if (walls)
    for (const int block : mesh.elem_block) is_at_wall.push_back(walls->has_wall(block));
  return is_at_wall;
}

void relax_and_tell(QuadMesh& mesh, const RelaxOptions& options, Report& report) {
  const auto least = [&] {
    return *std::min_element(mesh.elem_scaled_jacobian.begin(), mesh.elem_scaled_jacobian.end());
  };
  const auto mean = [&] {
    return std::accumulate(mesh.elem_scaled_jacobian.begin(), mesh.elem_scaled_jacobian.end(), 0.0) / mesh.num_elems();
  };
  report.set("relax.least_scaled_jacobian_before", least());
  report.set("relax.mean_scaled_jacobian_before", mean());
  const RelaxOutcome outcome = relax(mesh, options);
  report.set("relax.sweeps", outcome.sweeps);
  report.set("relax.energy_before", outcome.energy_before);
  report.set("relax.energy_after", outcome.energy_after);
  report.set("relax.largest_move", outcome.largest_move);
}

}  // namespace

void RefineOptions::validate() const {
  if (size < 0) throw UsageError("--size must not be negative");
  if (order < 1 || order > 20) throw UsageError("--order must lie in 1..20");
  if (!(geometry_tol >= 0)) throw UsageError("--geometry-tol must not be negative");
}

double default_geometry_tol(int order) { return order == 1 ? 5e-3 : order == 2 ? 5e-4 : order == 3 ? 2e-5 : 5e-7; }

QuadMesh refine(const BlockLayout& layout, const RefineOptions& options, Report& report) {
  options.validate();
  const curve::CurveTable table(layout.face, layout.splines);
  std::vector<curve::Chain> chains;
  for (const GraphArc& arc : layout.arcs) chains.emplace_back(table, arc.pieces);
  const std::vector<mesh::Chord> chords = mesh::directed_chords(
      layout.block2arcs, mesh::arc_chords(layout.block2arcs, static_cast<int>(layout.arcs.size())));

  const double diameter = layout.face.diameter;
  const sizing::SizeField sizes =
      options.size_field ? *options.size_field : sizing::SizeField(options.size > 0 ? options.size : diameter / 20);
  const double tolerance = options.geometry_tol > 0 ? options.geometry_tol : default_geometry_tol(options.order);
  const DivideOptions division{options.order, tolerance * diameter};
  std::vector<sizing::ChordCount> coarse;
  if (!options.blocks.empty()) coarse = coarse_counts(layout, chords, options.blocks, options.counts);
  std::optional<layers::WallPlan> walls;
  const auto split_at = [&](const std::vector<sizing::ArcParameter>& parameters) -> std::pair<QuadMesh, ArcEnds> {
    std::vector<sizing::ChordCount> counts = options.counts;
    counts.insert(counts.end(), coarse.begin(), coarse.end());
    const std::vector<sizing::ChordPlan> plans =
        sizing::grade_chords(layout, chords, chains, parameters, sizes, options.size_rule, counts);
    ArcEnds arc_ends = divide_arcs(layout, chords, plans, table, chains, parameters, division);
    if (!options.walls.empty())
      walls = layers::plan_walls(
          {layout, chords, table, chains, parameters, options.walls, sizes, division.order, division.tolerance},
          arc_ends);
    require_bounded_size(layout, arc_ends, options.order);
    QuadMesh mesh = split_isoparametric(layout, chains, arc_ends, options.order, walls ? &*walls : nullptr);
    measure_elements(mesh);
    return {std::move(mesh), std::move(arc_ends)};
  };

  const std::vector<sizing::ArcParameter> aligned = align_chords(chords, chains);
  const bool is_plain = std::all_of(aligned.begin(), aligned.end(), std::mem_fn(&sizing::ArcParameter::is_identity));
  const auto split_well = [&] {
    std::pair<QuadMesh, ArcEnds> first = split_at(aligned);
    if (first.first.is_valid || is_plain) return first;
    std::pair<QuadMesh, ArcEnds> plain = split_at(std::vector<sizing::ArcParameter>(chains.size()));
    return plain.first.is_valid ? plain : first;
  };
  auto [mesh, arc_ends] = split_well();
  while (!mesh.is_valid && raise_counts(layout, chords, mesh, coarse)) std::tie(mesh, arc_ends) = split_well();
  if (options.relax > 0) relax_and_tell(mesh, {options.relax, division.tolerance, elems_at_walls(mesh, walls)}, report);
  tell(mesh, chords.size(), report);
  if (walls) layers::tell_walls(*walls, options.walls, report);
  sizing::tell_sizes(chords, chains, arc_ends, sizes, options.counts, report);
  if (!options.allow_invalid) require_valid_elements(mesh);
  if (!mesh.is_valid) report.warn("W-QUA-001", check::doubt_about(mesh));
  return mesh;
}

}  // namespace quadrille::refine
