#include "block/report_layout.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/position_text.hpp"

namespace quadrille::block {
namespace {

/// The first block whose `value` is least.
template <typename Value>
int worst(const std::vector<BlockMeasure>& measures, const Value& value) {
  const auto less = [&](const BlockMeasure& a, const BlockMeasure& b) { return value(a) < value(b); };
  return static_cast<int>(std::min_element(measures.begin(), measures.end(), less) - measures.begin());
}

int worst_shape(const std::vector<BlockMeasure>& measures) {
  return worst(measures, [](const BlockMeasure& m) { return m.scaled_jacobian; });
}

Report::Value in_file(const BlockLayout& layout, Vec2 x) {
  return std::vector<double>{x.x + layout.face.origin.x, x.y + layout.face.origin.y};
}

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
      position_text(measures[shape].scaled_jacobian_position + layout.face.origin), smallest.block,
      measures[smallest.block].shortest_side, position_text(smallest.position + layout.face.origin),
      first == second ? "at " + first : "between " + first + " and " + second);
}

}  // namespace quadrille::block
