#pragma once
// A mesh with layers along walls from wall to wall: the divisions of its arcs, the lines inside its blocks, and what
// came of it.

#include <optional>
#include <vector>

#include "base/report.hpp"
#include "growth/limit_growth.hpp"
#include "growth/line_intervals.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::growth {

/// What smoothing must not change, by chord.
struct KeptChords {
  std::vector<bool> counts;     ///< prescribed numbers of intervals
  std::vector<bool> divisions;  ///< prescribed gradings
};

/// Those of prescribed counts, and those along boundaries with prescribed gradings. Throws as prescribe::named_arcs.
KeptChords kept_chords(const sizing::MeasuredLayout& measured, const std::vector<sizing::ChordCount>& counts,
                       const std::vector<prescribe::EndGrading>& gradings);

/// Limits the growth of the intervals of all arcs (limit_growth), and gives the arcs of `plan` their nodes again.
/// Layers that are compressed somewhere are released (layers/wall_layers).
GrowthOutcome smooth_arcs(const layers::WallInput& input, double limit, const KeptChords& kept, layers::WallPlan& plan,
                          sizing::ArcDivisions& divisions);

/// Blocks whose elements corrected lines make invalid or more skew (mesh/mesh_score) lose those along their walls, and
/// the next time, or without walls, all: these lines follow from the sides alone.
/// `without`: the skewness of the same blocks without corrected lines; `mesh`: with `lines`. Returns whether any did.
bool drop_worse(const std::vector<double>& without, const QuadMesh& mesh, const layers::WallSides& walls,
                BlockLines& lines);

/// Keys growth.{greatest_before, greatest, place, raised_chords, blocks_kept, blocks_straightened}; warning W-QUA-004
/// if the mesh misses the limit by more than a tenth. `outcome`: none if only the mesh without smoothing is proved
/// valid.
void report_growth(const std::optional<GrowthOutcome>& outcome, const LinePlan& lines, const QuadMesh& mesh,
                   double limit, Report& report);

}  // namespace quadrille::growth
