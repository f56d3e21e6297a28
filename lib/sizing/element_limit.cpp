#include "sizing/element_limit.hpp"

#include <fmt/format.h>

#include <cmath>

namespace quadrille::sizing {
namespace {

constexpr double max_element_nodes = 1e8;

/// The sum over all blocks of the product of the counts of two adjacent sides.
template <typename CountOfArc>
double num_elements(const BlockLayout& layout, const CountOfArc& count) {
  double num = 0;
  for (const auto& sides : layout.block2arcs) num += count(sides[0].arc) * count(sides[1].arc);
  return num;
}

void require_within(double num, const ElementLimit& limit, const char* about) {
  const double nodes_per_element = (limit.order + 1) * (limit.order + 1);
  if (num > limit.max_elements)
    throw TooManyElements(fmt::format(
        "sizes and geometric tolerance require {}{:.0f} quads, more than --max-elements {}: raise --size by a factor "
        "of {:.3g} (or --geometry-tol, where that determines the number), or raise --max-elements",
        about, num, limit.max_elements, std::sqrt(num / limit.max_elements)));
  if (num * nodes_per_element > max_element_nodes)
    throw TooManyElements(fmt::format(
        "sizes and geometric tolerance require {}{:.0f} quads of order {}, with more than 1e8 nodes: raise --size or "
        "--geometry-tol, or lower --order",
        about, num, limit.order));
}

}  // namespace

void require_planned_within(const MeasuredLayout& measured, const std::vector<ChordPlan>& plans,
                            const ElementLimit& limit) {
  const auto count = [&](int arc) { return static_cast<double>(plans[measured.chord_of(arc)].count); };
  require_within(num_elements(measured.blocks(), count), limit, "about ");
}

void require_divided_within(const BlockLayout& layout, const ArcDivisions& divisions, const ElementLimit& limit) {
  const auto count = [&](int arc) { return static_cast<double>(divisions[arc].num_intervals()); };
  require_within(num_elements(layout, count), limit, "");
}

}  // namespace quadrille::sizing
