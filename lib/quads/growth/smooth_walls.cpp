#include "growth/smooth_walls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>

#include "base/message_text.hpp"
#include "base/warning_codes.hpp"
#include "mesh/mesh_score.hpp"
#include "prescribe/named_arcs.hpp"
#include "surface/positions.hpp"

namespace quadrille::growth {

KeptChords kept_chords(const sizing::MeasuredLayout& measured, const std::vector<sizing::ChordCount>& counts,
                       const std::vector<prescribe::EndGrading>& gradings) {
  const std::vector<bool> none(measured.chords().size(), false);
  KeptChords kept{none, none};
  for (const sizing::ChordCount& count : counts) kept.counts[count.chord] = true;
  for (const prescribe::EndGrading& grading : gradings)
    for (const HalfEdge& half : prescribe::named_arcs(measured, grading.boundary, "--grading"))
      kept.divisions[measured.chord_of(half.arc)] = true;
  return kept;
}

GrowthOutcome smooth_arcs(const layers::WallInput& input, double limit, const KeptChords& kept, layers::WallPlan& plan,
                          sizing::ArcDivisions& divisions) {
  layers::release_compressed_layers(input, plan);
  layers::release_bent_layers(input, plan);
  GrowthInput arcs{input.measured, limit, input.order, input.tolerance, {}, kept.counts};
  for (int arc = 0; arc < input.measured.num_arcs(); ++arc) {
    const layers::ArcSpacing& spacing = plan.requests.spacings[arc];
    const int chord = input.measured.chord_of(arc);
    const bool is_kept = kept.divisions[chord];
    if (is_kept) arcs.keeps_count[chord] = true;
    arcs.layers.push_back({is_kept ? divisions[arc].num_intervals() : spacing[0].layers(), spacing[1].layers()});
  }
  GrowthOutcome outcome = limit_growth(arcs, divisions);
  outcome.num_kept = static_cast<int>(std::ranges::count(arcs.keeps_count, true));
  layers::measure_released_layers(input, divisions, plan);
  plan.arc_nodes = layers::layered_arc_nodes(plan.requests, divisions, input.order);
  return outcome;
}

namespace {

/// The directions of the lines that a block loses next: those along its walls. Without walls, or with walls in both
/// directions, and if it has lines in one direction only, all.
std::array<bool, 2> lines_to_drop(const std::array<int, 4>& walls, const layers::BlockLineLengths& lines) {
  const bool has_columns = walls[0] >= 0 || walls[2] >= 0, has_rows = walls[1] >= 0 || walls[3] >= 0;
  if (has_columns == has_rows || lines[0].empty() || lines[1].empty()) return {true, true};
  return {has_rows, has_columns};
}

/// Whether arcs themselves miss the limit, not only lines inside blocks.
bool arcs_miss(const GrowthOutcome& outcome, double limit) {
  return outcome.worst > limit * (1 + growth_constants.warned_excess);
}

/// `lost`: blocks without smooth lines.
std::string cause_and_remedy(const std::optional<GrowthOutcome>& outcome, std::ptrdiff_t lost, double limit) {
  const std::string usual = ": use a smaller --size or thinner layers";
  if (!outcome) return "; with smooth lines the mesh would not be proved valid" + usual;
  if (arcs_miss(*outcome, limit) && outcome->num_kept > 0)
    return "; chords with prescribed numbers of elements (--count, --grading, --blocks) got no more: raise them";
  if (arcs_miss(*outcome, limit)) return "; no greater numbers of elements suffice" + usual;
  if (lost > 0) return "; " + counted(lost, "block") + " would be invalid or worse with smooth lines" + usual;
  return " on lines inside blocks; along their sides it is kept" + usual;
}

bool is_dropped(const layers::BlockLineLengths& lines) { return lines[0].empty() || lines[1].empty(); }

}  // namespace

bool drop_worse(const std::vector<double>& without, const QuadMesh& mesh, const layers::WallSides& walls,
                BlockLines& lines) {
  const std::vector<double> with = mesh::block_skewness(mesh);
  bool any = false;
  for (std::size_t block = 0; block < lines.size(); ++block) {
    if (lines[block][0].empty() && lines[block][1].empty()) continue;
    if (std::isfinite(with[block]) && !mesh::exceeds(with[block], without[block])) continue;
    const std::array<bool, 2> drop = lines_to_drop(walls.of_block[block], lines[block]);
    for (const int direction : {0, 1})
      if (drop[direction]) lines[block][direction].clear();
    any = true;
  }
  return any;
}

void report_growth(const std::optional<GrowthOutcome>& outcome, const LinePlan& lines, const QuadMesh& mesh,
                   double limit, Report& report) {
  const auto lost = std::ranges::count_if(lines.lengths, is_dropped);
  const mesh::EdgeGrowth growth = mesh::edge_growth(mesh);
  if (outcome) {
    report.set("growth.greatest_before", outcome->worst_before);
    report.set("growth.raised_chords", outcome->raised_chords);
  }
  report.set("growth.greatest", growth.greatest);
  report.set("growth.place", surface::position_in_file(mesh.face, growth.position));
  report.set("growth.blocks_straightened", std::ranges::count_if(lines.shifts, std::not_fn(&layers::RowShifts::empty)));
  report.set("growth.blocks_kept", outcome ? lost : static_cast<std::ptrdiff_t>(mesh.block_names.size()));
  if (growth.greatest <= limit * (1 + growth_constants.warned_excess)) return;
  report.warn(warning::target_growth_missed,
              fmt::format("adjacent edges differ by a factor of {:.3g} near {}, more than --target-growth {:g}{}",
                          growth.greatest, surface::position_text(mesh.face, growth.position), limit,
                          cause_and_remedy(outcome, lost, limit)));
}

}  // namespace quadrille::growth
