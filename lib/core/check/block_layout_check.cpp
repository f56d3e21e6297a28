#include <utility>

#include "check/rules.hpp"
#include "model/interfaces.hpp"

namespace quadrille::check {

namespace {

void arrays_agree(const BlockLayout& layout, Findings& findings) {
  const std::size_t n = layout.block2nodes.size();
  if (n == 0) findings.add("the layout has no blocks");
  if (layout.block2arcs.size() != n || layout.block_jacobian_bound.size() != n || layout.block_names.size() != n)
    findings.add("block2nodes, block2arcs, block_jacobian_bound and block_names must have one entry for each block");
  if (!are_ascending_indices(layout.unnamed_blocks, n))
    findings.add("unnamed_blocks must be blocks in ascending order, each once");
  if (layout.arc_chord.size() != layout.arcs.size())
    findings.add("arc_chord has {} entries for {} arcs", layout.arc_chord.size(), layout.arcs.size());
  if (!are_finite(layout.block_jacobian_bound))
    findings.add("block_jacobian_bound contains a number that is not finite");
  for (const auto& [name, values] : {std::pair{"block_scaled_jacobian", &layout.block_scaled_jacobian},
                                     std::pair{"block_boundary_distance", &layout.block_boundary_distance}})
    if (!values->empty() && (values->size() != n || !are_finite(*values)))
      findings.add("{} must be empty or have one finite number for each block", name);
}

void block_indices_exist(const BlockLayout& layout, Findings& findings) {
  for (std::size_t b = 0; b < layout.block2nodes.size(); ++b)
    for (int k = 0; k < 4; ++k)
      if (!is_index(layout.block2nodes[b][k], layout.nodes.size()) ||
          !is_index(layout.block2arcs[b][k].arc, layout.arcs.size()))
        findings.add("block {}: node or arc {} does not exist", b, k);
  for (std::size_t a = 0; a < layout.arc_chord.size(); ++a)
    if (!is_index(layout.arc_chord[a], layout.arcs.size()))
      findings.add("arc {}: chord {} is outside 0 to {}", a, layout.arc_chord[a], layout.arcs.size() - 1);
}

void sides_join_nodes(const BlockLayout& layout, Findings& findings) {
  for (std::size_t b = 0; b < layout.block2nodes.size(); ++b)
    for (int k = 0; k < 4; ++k) {
      const HalfEdge side = layout.block2arcs[b][k];
      if (start_of(layout.arcs, side) != layout.block2nodes[b][k] ||
          end_of(layout.arcs, side) != layout.block2nodes[b][(k + 1) % 4])
        findings.add("block {}: side {} does not run from its node {} to the next", b, k, k);
    }
}

/// Inner arcs have a block on each side, boundary arcs one block.
void arcs_are_shared(const BlockLayout& layout, Findings& findings) {
  std::vector<std::array<int, 2>> uses(layout.arcs.size());
  for (const auto& sides : layout.block2arcs)
    for (const HalfEdge h : sides) ++uses[h.arc][h.is_backwards ? 1 : 0];
  for (std::size_t a = 0; a < uses.size(); ++a) {
    const bool is_sound =
        layout.arcs[a].is_boundary ? uses[a][0] + uses[a][1] == 1 : uses[a][0] == 1 && uses[a][1] == 1;
    if (!is_sound)
      findings.add("arc {} {} bounds {} blocks on its left and {} on its right", a,
                   layout.arcs[a].is_boundary ? "(boundary)" : "(inner)", uses[a][0], uses[a][1]);
  }
}

void chords_link_opposite_sides(const BlockLayout& layout, Findings& findings) {
  for (std::size_t b = 0; b < layout.block2arcs.size(); ++b)
    for (int k = 0; k < 2; ++k)
      if (layout.arc_chord[layout.block2arcs[b][k].arc] != layout.arc_chord[layout.block2arcs[b][k + 2].arc])
        findings.add("block {}: sides {} and {} are not of one chord", b, k, k + 2);
}

void names_are_there(const BlockLayout& layout, Findings& findings) {
  for (std::size_t b = 0; b < layout.block_names.size(); ++b)
    if (layout.block_names[b].empty()) findings.add("block {} has no name", b);
}

void euler_count_holds(const BlockLayout& layout, Findings& findings) {
  const int euler = static_cast<int>(layout.nodes.size()) - static_cast<int>(layout.arcs.size()) + layout.num_blocks();
  const int expected = euler_characteristic_of_whole(layout);
  if (euler != expected)
    findings.add("nodes - arcs + blocks is {}, the face's Euler characteristic {}", euler, expected);
}

void valences_are_blocks(const BlockLayout& layout, Findings& findings) {
  std::vector<int> count(layout.nodes.size());
  for (const auto& nodes : layout.block2nodes)
    for (const int n : nodes) ++count[n];
  for (std::size_t i = 0; i < count.size(); ++i)
    if (count[i] != layout.nodes[i].valence)
      findings.add("node {} has {} blocks but valence {}, at {}", i, count[i], layout.nodes[i].valence,
                   position_text(layout.face, layout.nodes[i].position));
}

void index_sum_holds(const BlockLayout& layout, Findings& findings) {
  const long long sum = index_sum_of(layout), expected = 4LL * euler_characteristic_of_whole(layout);
  if (sum != expected) findings.add("the index sum is {}, not {}", sum, expected);
}

void regions_fit(const BlockLayout& layout, Findings& findings) {
  if (layout.face.num_regions() == 1 && layout.block_region.empty()) return;
  if (static_cast<int>(layout.block_region.size()) != layout.num_blocks())
    return findings.add("block_region has {} entries for {} blocks", layout.block_region.size(), layout.num_blocks());
  const std::vector<int> curve_region = curve_regions(layout.face);
  std::vector<int> arc_region(layout.arcs.size(), -1);  // of the arcs inside a region: that of the first block there
  for (int b = 0; b < layout.num_blocks(); ++b)
    for (int k = 0; k < 4; ++k) {
      const HalfEdge side = layout.block2arcs[b][k];
      int expected = region_on_left(layout, side, curve_region);
      if (expected < 0) {
        int& met = arc_region[side.arc];
        if (met < 0) met = layout.block_region[b];
        expected = met;
      }
      if (layout.block_region[b] != expected)
        findings.add("block {} is of region {}, but its side {} bounds region {}, at {}", b, layout.block_region[b], k,
                     expected, position_text(layout.face, layout.nodes[layout.block2nodes[b][k]].position));
    }
}

/// Blocks on both sides of an interface that is not open share its arcs, and so its nodes.
void interfaces_are_closed(const BlockLayout& layout, Findings& findings) {
  const std::vector<bool> is_open = open_interfaces(layout.face, layout.open_curves, findings);
  if (is_open.empty()) return;
  for (std::size_t a = 0; a < layout.arcs.size(); ++a) {
    const int curve = layout.arcs[a].pieces.front().curve;
    if (curve >= layout.face.num_curves() || !layout.face.is_interface(curve)) continue;
    if (layout.arcs[a].is_boundary != is_open[curve])
      findings.add("arc {} on the interface curve {} {}, at {}", a, curve,
                   is_open[curve] ? "is inside, though the interface is open"
                                  : "bounds the blocks of one side only, though the interface is not open",
                   position_text(layout.face, layout.nodes[layout.arcs[a].from].position));
  }
}

constexpr Rule<BlockLayout> block_layout_rules[] = {
    {"BLK-R01", RuleKind::structure, [](const auto& b, Findings& f) { splines_are_sound(b, f); }},
    {"BLK-R02", RuleKind::structure, [](const auto& b, Findings& f) { graph_indices_exist(b, f); }},
    {"BLK-R03", RuleKind::structure, [](const auto& b, Findings& f) { pieces_are_sound(b, f); }},
    {"BLK-R04", RuleKind::structure, arrays_agree},
    {"BLK-R05", RuleKind::structure, block_indices_exist},
    {"BLK-R06", RuleKind::quick, [](const auto& b, Findings& f) { arcs_are_chains(b, f); }},
    {"BLK-R07", RuleKind::quick, [](const auto& b, Findings& f) { boundary_is_covered(b, f); }},
    {"BLK-R08", RuleKind::quick, [](const auto& b, Findings& f) { node_kinds_fit(b, f); }},
    {"BLK-R09", RuleKind::quick, sides_join_nodes},
    {"BLK-R10", RuleKind::quick, arcs_are_shared},
    {"BLK-R11", RuleKind::quick, chords_link_opposite_sides},
    {"BLK-R12", RuleKind::quick, names_are_there},
    {"BLK-R13", RuleKind::full, euler_count_holds},
    {"BLK-R14", RuleKind::full, valences_are_blocks},
    {"BLK-R15", RuleKind::full, index_sum_holds},
    {"BLK-R16", RuleKind::quick, regions_fit},
    {"BLK-R17", RuleKind::full, interfaces_are_closed},
};

}  // namespace

std::vector<Violation> violations_of(const BlockLayout& layout, CheckDepth depth) {
  return apply_rules_after(layout.face, block_layout_rules, layout, depth);
}

template std::vector<Violation> check_stage(const BlockLayout&, CheckDepth);

}  // namespace quadrille::check
