#include "sizing/hole_rings.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "base/angle.hpp"
#include "base/tolerance.hpp"
#include "curve/chain.hpp"
#include "curve/face_boundary.hpp"
#include "curve/nurbs.hpp"
#include "mesh/side_key.hpp"

namespace quadrille::sizing {
namespace {

struct RingConstants {
  double longest_hole = 12.0 / 20;  ///< diameters
  double thickness = 0.9;           ///< of the first row, in radii of a circle as long as the hole
  double growth = 1.5;              ///< from row to row
  double room = 2;                  ///< in radii
};
constexpr RingConstants ring_constants;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The blocks that have a side on a loop.
struct LoopBlocks {
  int num_sides = 0;
  int chord = -1;  ///< of the sides beside those on the loop
  bool has_one_chord = true;
  double least_size = infinity;  ///< prescribed at the ends of these sides
};

std::vector<LoopBlocks> blocks_at_loops(const MeasuredLayout& measured, const SizeField& sizes) {
  const BlockLayout& blocks = measured.blocks();
  std::vector<LoopBlocks> loops(blocks.face.num_loops());
  for (const auto& sides : blocks.block2arcs)
    for (int side = 0; side < 4; ++side) {
      const GraphArc& arc = blocks.arcs[sides[side].arc];
      if (!arc.is_boundary) continue;
      LoopBlocks& at = loops[blocks.face.loop_of(arc.pieces[0].curve)];
      const int chord = measured.chord_of(sides[(side + 1) % 4].arc);
      at.has_one_chord &= at.num_sides == 0 || at.chord == chord;
      at.chord = chord;
      ++at.num_sides;
      for (const int node : {arc.from, arc.to})
        at.least_size = std::min(at.least_size, sizes.at(blocks.nodes[node].position));
    }
  return loops;
}

double length_of_loop(const CadFace& face, int loop) {
  double length = 0;
  for (int c = face.loop_offsets[loop]; c < face.loop_offsets[loop + 1]; ++c)
    length += curve::ArcLength(face.curves[c]).total();
  return length;
}

/// The least distance of a loop from the others: from the nearest of a few points by projection to and fro.
double distance_to_others(const curve::CurveTree& tree, const CadFace& face, int loop) {
  constexpr int samples = 16, rounds = 20;
  const int first = face.loop_offsets[loop], last = face.loop_offsets[loop + 1];
  const curve::CurveTree::Filter own = [&](int curve) { return curve >= first && curve < last; };
  const curve::CurveTree::Filter other = [&](int curve) { return !own(curve); };
  curve::NearestPoint nearest;
  for (int c = first; c < last; ++c)
    for (int k = 0; k < samples; ++k) {
      const Nurbs& curve = face.curves[c];
      const double t = curve.begin() + (curve.end() - curve.begin()) * k / samples;
      const curve::NearestPoint foot = tree.nearest(curve::point(curve, t), other);
      if (foot.distance < nearest.distance) nearest = foot;
    }
  for (int round = 0; round < rounds && nearest.curve >= 0; ++round)
    nearest = tree.nearest(tree.nearest(nearest.position, own).position, other);
  return nearest.distance;
}

/// By chord: the number of blocks that it passes.
std::vector<int> chord_lengths(const MeasuredLayout& measured) {
  std::vector<int> lengths(measured.chords().size(), 0);
  for (const auto& sides : measured.blocks().block2arcs)
    for (const int side : {0, 1}) ++lengths[measured.chord_of(sides[side].arc)];
  return lengths;
}

struct ElementSide {
  int elem = -1, side = 0;
};

/// From each side of an element to the one that it shares nodes with.
class SharedSides {
 public:
  explicit SharedSides(const QuadMesh& mesh) : mesh_(mesh) {
    for (int elem = 0; elem < mesh.num_elems(); ++elem)
      for (int side = 0; side < 4; ++side) sides_[mesh::side_key(mesh_, elem, side)].push_back({elem, side});
  }

  /// Element -1 on the boundary.
  ElementSide beyond(ElementSide at) const {
    for (const ElementSide& side : sides_.at(mesh::side_key(mesh_, at.elem, at.side)))
      if (side.elem != at.elem) return side;
    return {};
  }

 private:
  const QuadMesh& mesh_;
  std::map<std::pair<int, int>, std::vector<ElementSide>> sides_;
};

}  // namespace

std::vector<HoleRing> hole_rings(const MeasuredLayout& measured, const SizeField& sizes) {
  const CadFace& face = measured.blocks().face;
  std::vector<HoleRing> rings;
  if (!face.partners.empty() || !face.periodic_pairs.empty()) return rings;
  const std::vector<LoopBlocks> blocks = blocks_at_loops(measured, sizes);
  const std::vector<int> lengths = chord_lengths(measured);
  const curve::CurveTree tree(face.curves);
  const auto is_below = [](double x, double limit) { return x < limit * (1 - tolerance::tied); };
  for (int loop = 1; loop < face.num_loops(); ++loop) {
    const LoopBlocks& at = blocks[loop];
    if (at.num_sides == 0 || !at.has_one_chord || lengths[at.chord] != at.num_sides) continue;
    const double length = length_of_loop(face, loop), radius = length / (2 * pi);
    const double thickness = ring_constants.thickness * radius;
    if (!is_below(length, ring_constants.longest_hole * face.diameter) || !is_below(thickness, at.least_size)) continue;
    const double room = distance_to_others(tree, face, loop);
    rings.push_back({loop, at.chord, thickness, !is_below(room, ring_constants.room * radius)});
  }
  return rings;
}

void add_ring_rows(const std::vector<HoleRing>& rings, std::vector<ChordPlan>& plans) {
  for (const HoleRing& ring : rings)
    if (!plans[ring.chord].is_prescribed) ++plans[ring.chord].count;
}

void report_rings(const std::vector<HoleRing>& rings, Report& report) {
  if (rings.empty()) return;
  std::vector<double> loops, thicknesses;
  for (const HoleRing& ring : rings) loops.push_back(ring.loop), thicknesses.push_back(ring.thickness);
  report.set("rings.loop", std::move(loops));
  report.set("rings.thickness", std::move(thicknesses));
}

std::vector<Vec2> ring_lengths(const QuadMesh& mesh, const std::vector<HoleRing>& rings) {
  if (rings.empty()) return {};
  std::vector<Vec2> lengths(mesh.num_elems(), {infinity, infinity});
  std::vector<double> thickness(mesh.face.num_loops(), 0);
  for (const HoleRing& ring : rings) thickness[ring.loop] = ring.thickness;
  const SharedSides shared(mesh);
  for (const QuadBoundaryEdge& edge : mesh.boundary_edges) {
    double length = thickness[mesh.face.loop_of(edge.curve)];
    ElementSide at{edge.elem, edge.side};
    while (length > 0 && at.elem >= 0 && length < mesh.face.diameter) {
      double& across = at.side % 2 == 0 ? lengths[at.elem].y : lengths[at.elem].x;
      across = std::min(across, length);
      at = shared.beyond({at.elem, (at.side + 2) % 4});
      length *= ring_constants.growth;
    }
  }
  return lengths;
}

}  // namespace quadrille::sizing
