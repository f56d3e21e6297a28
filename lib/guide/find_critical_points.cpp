#include "guide/find_critical_points.hpp"

#include <algorithm>
#include <utility>

#include "field/error_estimate.hpp"
#include "guide/cell_zero.hpp"
#include "guide/multiple_zero.hpp"
#include "guide/valence.hpp"
#include "guide/zero_search.hpp"

namespace quadrille {
namespace {

/// Each zero once, from the lowest element that holds it: zeros on an edge or vertex are found on every side of it.
/// The elements were searched in ascending sequence. Two zeros are no nearer than the cells that isolate them.
std::vector<FoundZero> distinct(const std::vector<FoundZero>& zeros, double diameter) {
  std::vector<FoundZero> result;
  for (const FoundZero& zero : zeros) {
    const bool known = std::any_of(result.begin(), result.end(), [&](const FoundZero& other) {
      return distance(zero.x, other.x) <= 1e-3 * std::min(zero.cell_radius, other.cell_radius) + 1e-12 * diameter;
    });
    if (!known) result.push_back(zero);
  }
  return result;
}

/// A point of the closed reference triangle: a zero on an edge may stand round-off beyond it.
Vec2 clamped(Vec2 xi) {
  xi = {std::max(xi.x, -1.0), std::max(xi.y, -1.0)};
  const double excess = xi.x + xi.y;
  return excess > 0 ? Vec2{xi.x - excess / 2, xi.y - excess / 2} : xi;
}

CriticalPoint critical_point(const FieldEvaluator& evaluator, const FoundZero& zero) {
  const FieldSample s = evaluator.sample(zero.elem, zero.xi);
  const int sign = det(s.dv_dx) > 0 ? 1 : -1;
  const Mat2& j = s.dv_dx;
  const std::vector<double>& errors = evaluator.field().elem_error;
  const double diameter = evaluator.field().mesh.face.diameter;
  const double error = errors.empty() ? 0 : std::min(position_error(j, errors[zero.elem]), diameter);
  return {s.x, sign, 4 - sign, zero.elem, clamped(zero.xi), {j.xx, j.xy, j.yx, j.yy}, error};
}

/// Tolerances are no ordering: points are put into columns of equal x first, each column is sorted by y.
void sort_by_place(std::vector<CriticalPoint>& points, double tol) {
  const auto by_x = [](const CriticalPoint& a, const CriticalPoint& b) { return a.position.x < b.position.x; };
  const auto by_y = [](const CriticalPoint& a, const CriticalPoint& b) { return a.position.y < b.position.y; };
  std::stable_sort(points.begin(), points.end(), by_x);
  for (auto first = points.begin(); first != points.end();) {
    auto last = first + 1;
    while (last != points.end() && last->position.x - (last - 1)->position.x <= tol) ++last;
    std::stable_sort(first, last, by_y);
    first = last;
  }
}

int index_sum(const CriticalPoints& points) {
  int sum = 0;
  for (const CriticalPoint& p : points.critical_points) sum += 4 - p.valence;
  for (const Corner& c : points.corners) sum += 2 - c.valence;
  return sum;
}

void report_proof(const SearchCounts& counts, int num_elems, const CriticalPoints& points, Report& report) {
  report.set("critical_points", points.critical_points.size());
  report.set("corners", points.corners.size());
  report.set("index_sum.value", points.index_sum);
  report.set("index_sum.expected", points.index_sum_expected);
  report.set("proof.elements", num_elems);
  report.set("proof.cells_examined", counts.examined);
  report.set("proof.cells_excluded", counts.excluded);
  report.set("proof.cells_isolated", counts.isolated);
  report.set("proof.cells_left_to_corners", counts.ignored);
  report.set("proof.greatest_depth", counts.greatest_depth);
}

}  // namespace

CriticalPoints find_critical_points(const FieldEvaluator& evaluator, Report& report) {
  const TriMesh& mesh = evaluator.field().mesh;
  const CadFace& face = mesh.face;

  CornerValences valences = corner_valences(evaluator);
  ZeroSearch search(evaluator, valences.discs);
  for (int e = 0; e < mesh.num_elems() && !search.is_hopeless(); ++e) search.search(e);
  const std::vector<FoundZero> zeros = distinct(search.zeros(), face.diameter);
  require_simple_zeros(evaluator, zeros, search.open_cells());

  CriticalPoints points;
  points.origin = face.origin;
  for (const FoundZero& zero : zeros) {
    const bool of_corner = std::any_of(valences.discs.begin(), valences.discs.end(),
                                       [&](const Disc& disc) { return distance(disc.centre, zero.x) <= disc.radius; });
    if (!of_corner) points.critical_points.push_back(critical_point(evaluator, zero));
  }
  sort_by_place(points.critical_points, 1e-6 * face.diameter);
  points.corners = std::move(valences.corners);
  points.index_sum = index_sum(points);
  points.index_sum_expected = 4 * face.euler_characteristic();
  report_proof(search.counts(), mesh.num_elems(), points, report);
  return points;
}

}  // namespace quadrille
