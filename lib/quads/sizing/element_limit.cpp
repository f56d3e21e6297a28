#include "sizing/element_limit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace quadrille::sizing {
namespace {

constexpr double max_element_nodes = 1e8;
constexpr double most_exact_number = 1e9;  ///< greater ones are printed with three digits
/// Elements of a face may be fewer than its area over the square of their size, where chords widen.
constexpr double area_doubt = 4;
constexpr double most_reported = 9e18;  ///< the greatest number that the report can hold, or nearly

/// The sum over all blocks of the product of the counts of two adjacent sides.
template <typename CountOfArc>
double num_elements(const BlockLayout& layout, const CountOfArc& count) {
  double num = 0;
  for (const auto& sides : layout.block2arcs) num += count(sides[0].arc) * count(sides[1].arc);
  return num;
}

std::string number(double num) {
  return num < most_exact_number ? fmt::format("{:.0f}", num) : fmt::format("{:.3g}", num);
}

/// `cause` determines the number, in the plural; `remedy` lowers it.
void require_within(double num, const std::string& about, const ElementLimit& limit, const char* cause,
                    const std::string& remedy) {
  const double nodes_per_element = (limit.order + 1) * (limit.order + 1);
  if (num > limit.max_elements)
    throw TooManyElements(fmt::format("{} require {}{} quads, more than --max-elements {}: {}, or raise --max-elements",
                                      cause, about, number(num), limit.max_elements, remedy));
  if (num * nodes_per_element > max_element_nodes)
    throw TooManyElements(
        fmt::format("{} require {}{} quads of order {}, with more than 1e8 nodes: raise --size or --geometry-tol, or "
                    "lower --count or --order",
                    cause, about, number(num), limit.order));
}

std::string raised_size(double num, const ElementLimit& limit) {
  return fmt::format("raise --size by a factor of {:.3g}", std::sqrt(num / limit.max_elements));
}

}  // namespace

double num_planned(const MeasuredLayout& measured, const std::vector<ChordPlan>& plans) {
  return num_elements(measured.blocks(),
                      [&](int arc) { return static_cast<double>(plans[measured.chord_of(arc)].count); });
}

double num_divided(const BlockLayout& layout, const ArcDivisions& divisions) {
  return num_elements(layout, [&](int arc) { return static_cast<double>(divisions[arc].num_intervals()); });
}

void require_area_within(double area, double size, const ElementLimit& limit) {
  const double num = area / (size * size);
  if (num > area_doubt * limit.max_elements) require_within(num, "some ", limit, "sizes", raised_size(num, limit));
}

void require_nested_within(int num_elems, int levels, const ElementLimit& limit) {
  require_within(std::ldexp(num_elems, 2 * levels), "", limit, "parts of elements", "lower --refine");
}

void require_planned_within(const MeasuredLayout& measured, const std::vector<ChordPlan>& plans,
                            const ElementLimit& limit, Report& report) {
  const auto plan = [&](int arc) -> const ChordPlan& { return plans[measured.chord_of(arc)]; };
  const double num = num_planned(measured, plans);
  report.set("estimated_quads", static_cast<long long>(std::min(num, most_reported)));
  const double num_by_sizes = num_elements(
      measured.blocks(), [&](int arc) { return plan(arc).is_prescribed ? 1.0 : static_cast<double>(plan(arc).count); });
  if (num_by_sizes <= limit.max_elements && num > limit.max_elements)
    require_within(num, "about ", limit, "counts", "lower --count");
  require_within(num, "about ", limit, num == num_by_sizes ? "sizes" : "sizes and counts", raised_size(num, limit));
}

void require_divided_within(const BlockLayout& layout, const ArcDivisions& divisions, const ElementLimit& limit) {
  const double num = num_divided(layout, divisions);
  require_within(
      num, "", limit, "sizes, counts, wall layers and geometric tolerance",
      raised_size(num, limit) + " (or --geometry-tol, or give fewer layers, where these determine the number)");
}

}  // namespace quadrille::sizing
