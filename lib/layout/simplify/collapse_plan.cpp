#include "simplify/collapse_plan.hpp"

#include "model/interfaces.hpp"

namespace quadrille::simplify {

using graph::FixedSide;

int wrapped_rung(const graph::ChordStrip& strip, int i) {
  return strip.is_closed ? i % static_cast<int>(strip.rungs.size()) : i;
}

CollapsePlan plan_collapse(const graph::ChordStrip& strip, const std::vector<FixedSide>& fixed) {
  const int num_rungs = static_cast<int>(strip.rungs.size());
  CollapsePlan plan{fixed, std::vector<FixedSide>(strip.num_blocks(), FixedSide::none), {}};
  const auto at = [&](int i) { return wrapped_rung(strip, i); };
  int first = 0;
  while (fixed[first] == FixedSide::none) ++first;
  if (!strip.is_closed)
    for (int b = 0; b < first; ++b) plan.kept_rail[b] = plan.merged_into[b] = fixed[first];
  const int end = strip.is_closed ? first + num_rungs : num_rungs;
  for (int i = first, next = 0; i < end; i = next) {
    next = i + 1;
    while (next < end && fixed[at(next)] == FixedSide::none) ++next;
    const bool is_last = !strip.is_closed && next == end;
    const FixedSide here = fixed[at(i)], there = is_last ? here : fixed[at(next)];
    if (here != there) {
      plan.stretches.push_back({i, next - i, here == FixedSide::left});
      continue;
    }
    for (int k = i; k < next; ++k) plan.merged_into[at(k)] = here;
    for (int k = i; k < next - (is_last ? 1 : 0); ++k) plan.kept_rail[at(k)] = here;
  }
  return plan;
}

bool removes_boundary(const ArcGraph& graph, const graph::ChordStrip& strip, const CollapsePlan& plan) {
  const auto is_boundary = [&](HalfEdge h) { return is_on_cad_curve(graph, graph.arcs[h.arc]); };
  for (int b = 0; b < strip.num_blocks(); ++b)
    if ((plan.kept_rail[b] != FixedSide::left && is_boundary(strip.left[b])) ||
        (plan.kept_rail[b] != FixedSide::right && is_boundary(strip.right[b])))
      return true;
  return false;
}

}  // namespace quadrille::simplify
