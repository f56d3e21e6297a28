#include "block/report_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "curve/face_boundary.hpp"
#include "curve/nurbs.hpp"
#include "mesh/chords.hpp"
#include "model/interfaces.hpp"
#include "surface/positions.hpp"

namespace quadrille::block {
namespace {

/// A feature and its distance along the rail.
struct Held {
  double distance = std::numeric_limits<double>::infinity();
  BoundaryFeature feature;
};

class Rails {
 public:
  Rails(const BlockLayout& layout, const BlockMaps& maps) : layout_(layout), maps_(maps) {
    for (std::vector<int>& beside : beside_) beside.assign(layout.arcs.size(), -1);
    for (int b = 0; b < layout.num_blocks(); ++b)
      for (int k = 0; k < 4; ++k) {
        const HalfEdge directed = layout.block2arcs[b][k];
        beside_[directed.is_backwards][directed.arc] = 4 * b + k;
      }
  }

  /// The features that fix the rails through both ends of side k of a block, searched on both sides of it.
  std::array<BoundaryFeature, 2> around(int block, int side) {
    const HalfEdge directed = layout_.block2arcs[block][side];
    held_ = {};
    look_at_node(0, start_of(directed), 0);
    look_at_node(1, start_of(directed.reversed()), 0);
    walk(directed, {0, 1});
    walk(directed.reversed(), {1, 0});
    std::array<BoundaryFeature, 2> found{held_[0].feature, held_[1].feature};
    for (int r = 0; r < 2; ++r)
      if (held_[r].feature.curve < 0)
        found[r] = nearest_curve(layout_.nodes[start_of(r == 0 ? directed : directed.reversed())].position);
    return found;
  }

 private:
  int start_of(HalfEdge h) const { return quadrille::start_of(layout_.arcs, h); }

  /// Visits the blocks on the left of a directed arc; rail[0] is the position in held_ of the rail through its start.
  void walk(HalfEdge directed, std::array<int, 2> rail) {
    std::array<double, 2> walked{0, 0};
    for (int steps = 0; steps <= layout_.num_blocks(); ++steps) {
      const int beside = beside_[directed.is_backwards][directed.arc];
      if (beside < 0) return;
      const int block = beside / 4, k = beside % 4;
      const std::array<HalfEdge, 4>& sides = layout_.block2arcs[block];
      const std::array<HalfEdge, 2> along{sides[(k + 3) % 4], sides[(k + 1) % 4]};  // at the start and at the end
      for (int end = 0; end < 2; ++end) {
        look_at_arc(rail[end], along[end], start_of(end == 0 ? directed : directed.reversed()), walked[end]);
        walked[end] += maps_.arc(along[end].arc).length();
      }
      const HalfEdge opposite = sides[(k + 2) % 4];
      directed = opposite.reversed();
      for (int end = 0; end < 2; ++end)
        look_at_node(rail[end], start_of(end == 0 ? directed : directed.reversed()), walked[end]);
    }
  }

  bool is_nearer(int rail, double distance) const {
    return held_[rail].feature.curve < 0 || distance < (1 - tolerance::tied) * held_[rail].distance;
  }

  void hold(int rail, double distance, const BoundaryFeature& feature) {
    if (is_nearer(rail, distance)) held_[rail] = {distance, feature};
  }

  /// A rail along the boundary is fixed from its nearer end on, by the curve rather than by a corner at its start.
  void look_at_arc(int rail, HalfEdge directed, int from, double distance) {
    const GraphArc& arc = layout_.arcs[directed.arc];
    if (!is_on_cad_curve(layout_, arc)) return;
    const ArcPiece& piece = arc.from == from ? arc.pieces.front() : arc.pieces.back();
    const BoundaryFeature feature{piece.curve, false, layout_.nodes[from].position};
    if (distance == 0) held_[rail] = {distance, feature};
    hold(rail, distance, feature);
  }

  void look_at_node(int rail, int id, double distance) {
    const GraphNode& node = layout_.nodes[id];
    if (node.curve >= 0) {
      const bool is_regular = node.valence == (node.is_inner() ? 4 : 2);
      const bool is_corner = node.kind == NodeKind::corner || node.kind == NodeKind::junction;
      if (is_regular && !is_corner) return;
      hold(rail, distance, {node.curve, is_corner, node.position});
    } else if (node.valence != 4 && is_nearer(rail, distance)) {
      held_[rail] = {distance, nearest_curve(node.position)};
    }
  }

  BoundaryFeature nearest_curve(Vec2 x) const {
    const curve::NearestPoint foot =
        curve::CurveTree(layout_.face.curves).nearest_feet(x, tolerance::tied * layout_.face.diameter).front();
    return {foot.curve, false, foot.position};
  }

  const BlockLayout& layout_;
  const BlockMaps& maps_;
  std::array<std::vector<int>, 2> beside_;  ///< [forwards, backwards][arc]: 4 block + side, or -1
  std::array<Held, 2> held_;
};

std::string curve_name(const CadFace& face, int curve) {
  const std::string& name = face.curve_names[curve];
  return fmt::format("{}{}", curve, name.empty() || !face.has_given_name(curve) ? "" : " '" + name + "'");
}

/// The first block whose `value` is least.
template <typename Value>
int worst(const std::vector<BlockMeasure>& measures, const Value& value) {
  const auto less = [&](const BlockMeasure& a, const BlockMeasure& b) { return value(a) < value(b); };
  return static_cast<int>(std::min_element(measures.begin(), measures.end(), less) - measures.begin());
}

int worst_shape(const std::vector<BlockMeasure>& measures) {
  return worst(measures, [](const BlockMeasure& m) { return m.scaled_jacobian; });
}

Report::Value in_file(const BlockLayout& layout, Vec2 x) { return surface::position_in_file(layout.face, x); }

void report_counts(const BlockLayout& layout, Report& report) {
  report.set("blocks", layout.num_blocks());
  report.set("arcs", layout.arcs.size());
  report.set("chords", 1 + *std::max_element(layout.arc_chord.begin(), layout.arc_chord.end()));
  report.set("irregular_nodes",
             static_cast<int>(std::count_if(layout.nodes.begin(), layout.nodes.end(),
                                            [](const GraphNode& n) { return n.is_inner() && n.valence != 4; })));
}

void report_worst(const BlockLayout& layout, const std::vector<BlockMeasure>& measures, Report& report) {
  const int folded = worst(measures, [](const BlockMeasure& m) { return m.jacobian_bound; });
  report.set("least_jacobian_bound", measures[folded].jacobian_bound);
  report.set("least_jacobian_bound_block", layout.block_names[folded]);
  const int shape = worst_shape(measures);
  report.set("least_scaled_jacobian", measures[shape].scaled_jacobian);
  report.set("least_scaled_jacobian_block", layout.block_names[shape]);
  report.set("least_scaled_jacobian_place", in_file(layout, measures[shape].scaled_jacobian_position));
  const int far = worst(measures, [](const BlockMeasure& m) { return -m.boundary_distance; });
  report.set("greatest_boundary_distance", measures[far].boundary_distance);
  report.set("greatest_boundary_distance_block", layout.block_names[far]);
  if (measures[far].boundary_distance > 0)
    report.set("greatest_boundary_distance_place", in_file(layout, measures[far].boundary_distance_position));
}

/// The criterion that a block fails: as one quad only, or by its exact map too.
void report_proof(const std::vector<BlockMeasure>& measures, Report& report) {
  const auto count = [&](const auto& has) {
    return static_cast<int>(std::count_if(measures.begin(), measures.end(), has));
  };
  report.set(
      "least_map_scaled_jacobian",
      measures[worst(measures, [](const BlockMeasure& m) { return m.map_scaled_jacobian; })].map_scaled_jacobian);
  report.set("proved.as_one_quad", count([](const BlockMeasure& m) { return m.divisions == 1; }));
  report.set("proved.when_divided", count([](const BlockMeasure& m) { return m.divisions > 1; }));
  report.set("proved.not", count([](const BlockMeasure& m) { return m.divisions == 0; }));
}

void report_feature(const BlockLayout& layout, const BoundaryFeature& feature, const std::string& key, Report& report) {
  const CadFace& face = layout.face;
  report.set(key + ".kind", feature.is_corner ? "corner" : "curve");
  report.set(key + ".curve", feature.curve);
  report.set(key + ".name", face.curve_names[feature.curve]);
  report.set(key + ".loop", face.loop_of(feature.curve));
  report.set(key + ".place", in_file(layout, feature.position));
}

}  // namespace

SmallestBlock smallest_block(const BlockLayout& layout, const std::vector<BlockMeasure>& measures) {
  SmallestBlock smallest;
  double least = std::numeric_limits<double>::infinity();
  for (int b = 0; b < layout.num_blocks(); ++b)
    if (measures[b].shortest_side < (1 - tolerance::tied) * least)
      least = measures[b].shortest_side, smallest.block = b, smallest.side = measures[b].shortest_side_index;
  const BlockMaps maps(layout);
  smallest.position = maps.arc(layout.block2arcs[smallest.block][smallest.side].arc).at(0.5).position;
  smallest.between = Rails(layout, maps).around(smallest.block, smallest.side);
  return smallest;
}

std::string name_of(const CadFace& face, const BoundaryFeature& feature) {
  const int loop = face.loop_of(feature.curve);
  const std::string hole = loop == 0 ? "" : fmt::format(" (hole {})", loop);
  if (!feature.is_corner) return "curve " + curve_name(face, feature.curve) + hole;
  return fmt::format("the corner of curves {} and {}{}", curve_name(face, face.previous_in_loop(feature.curve)),
                     curve_name(face, feature.curve), hole);
}

void report_layout(const BlockLayout& layout, const std::vector<BlockMeasure>& measures, Report& report) {
  report_counts(layout, report);
  report_worst(layout, measures, report);
  report_proof(measures, report);
  const SmallestBlock smallest = smallest_block(layout, measures);
  const BlockMeasure& m = measures[smallest.block];
  report.set("smallest_block.block", layout.block_names[smallest.block]);
  report.set("smallest_block.shortest_side", m.shortest_side);
  report.set("smallest_block.place", in_file(layout, smallest.position));
  report.set("smallest_block.area", m.area);
  report.set("smallest_block.least_area", measures[worst(measures, [](const BlockMeasure& b) { return b.area; })].area);
  report_feature(layout, smallest.between[0], "smallest_block.first", report);
  report_feature(layout, smallest.between[1], "smallest_block.second", report);
}

std::string summarise_layout(const BlockLayout& layout, const std::vector<BlockMeasure>& measures) {
  const int shape = worst_shape(measures);
  const SmallestBlock smallest = smallest_block(layout, measures);
  const std::string first = name_of(layout.face, smallest.between[0]);
  const std::string second = name_of(layout.face, smallest.between[1]);
  return fmt::format(
      "{} block{}, least scaled Jacobian {:.2f} (block {} near {}), smallest block {}: a side of {:.3g} "
      "near {} {}",
      layout.num_blocks(), layout.num_blocks() == 1 ? "" : "s", measures[shape].scaled_jacobian, shape,
      surface::position_text(layout.face, measures[shape].scaled_jacobian_position), smallest.block,
      measures[smallest.block].shortest_side, surface::position_text(layout.face, smallest.position),
      first == second ? "at " + first : "between " + first + " and " + second);
}

}  // namespace quadrille::block
