#include "page/field_samples.hpp"

#include <algorithm>
#include <cmath>

#include "field/evaluate.hpp"

namespace quadrille::page {

namespace {

/// From the cheapest on; the last is taken where none is good enough.
constexpr std::array<LatticeForm, 7> lattice_forms{{{1, 2}, {1, 4}, {1, 8}, {2, 4}, {2, 8}, {4, 4}, {4, 8}}};

struct DrawingTolerances {
  double pixels = 0.15;    ///< by which contours and points may be displaced
  double colour = 0.004;   ///< of u and v, which no eye sees
  double rounding = 1e-7;  ///< of u and v, below which contours have no place
  int checks = 8;          ///< intervals of a side of the lattice in whose triangles the drawing is compared
};
constexpr DrawingTolerances drawing{};

/// a (3 s) (3 s - 1) ... / a!, a factor of a cubic Lagrange polynomial of the lattice of three intervals.
double lattice_factor(int a, double s) {
  double product = 1;
  for (int r = 0; r < a; ++r) product *= (3 * s - r) / (r + 1);
  return product;
}

/// The number of the point (i, j) of a lattice of n intervals.
int lattice_index(int n, int i, int j) { return j * (2 * n + 3 - j) / 2 + i; }

/// The reference coordinates of a point of the unit triangle.
Vec2 reference(double s, double t) { return {2 * s - 1, 2 * t - 1}; }

/// The cubic at the point (p, q) of the lattice of lines * parts intervals. Parts that point down are those that point
/// up, turned by half a turn.
Vec2 cubic_value(LatticeForm form, const std::vector<Vec2>& at_points, int p, int q) {
  const int k = form.lines;
  int i = p / k, j = q / k, a = p % k, b = q % k, sign = 1;
  if (a + b > k) ++i, ++j, a = k - a, b = k - b, sign = -1;
  if (a == 0 && b == 0) return at_points[lattice_index(form.intervals(), 3 * i, 3 * j)];
  const double s = static_cast<double>(a) / k, t = static_cast<double>(b) / k;
  Vec2 value;
  for (int beta = 0; beta <= 3; ++beta)
    for (int alpha = 0; alpha + beta <= 3; ++alpha)
      value += lattice_factor(alpha, s) * lattice_factor(beta, t) * lattice_factor(3 - alpha - beta, 1 - s - t) *
               at_points[lattice_index(form.intervals(), 3 * i + sign * alpha, 3 * j + sign * beta)];
  return value;
}

/// The field where its drawing is compared with it.
struct Check {
  double s = 0, t = 0;
  field::FieldSample field;
};

std::vector<Check> checks_of(const field::FieldEvaluator& evaluator, int elem) {
  std::vector<Check> checks;
  const double third = 1.0 / (3 * drawing.checks);
  const auto add = [&](double s, double t) { checks.push_back({s, t, evaluator.sample(elem, reference(s, t))}); };
  for (int j = 0; j < drawing.checks; ++j)
    for (int i = 0; i + j < drawing.checks; ++i) {
      add((3 * i + 1) * third, (3 * j + 1) * third);
      if (i + j + 1 < drawing.checks) add((3 * i + 2) * third, (3 * j + 2) * third);
    }
  return checks;
}

/// Positions and values at the points of a lattice.
struct Lattice {
  std::vector<Vec2> positions, values;
};

Lattice lattice_of(const field::FieldEvaluator& evaluator, int elem, LatticeForm form) {
  Lattice lattice;
  const int n = form.intervals();
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i + j <= n; ++i) {
      Vec2 x;
      Mat2 dx_dxi;
      lattice.values.push_back(evaluator.value(elem, reference(1.0 * i / n, 1.0 * j / n), x, dx_dxi));
      lattice.positions.push_back(x);
    }
  return lattice;
}

/// Whether the drawn component deviates too little to be seen. `reach`: the distance of checks, within which a contour
/// may pass.
bool is_unseen(double error, double value, Vec2 gradient, double pixel, double reach, bool has_contours) {
  const double steepness = norm(gradient), displaced = drawing.pixels * pixel * steepness;
  const bool has_contour = has_contours && std::abs(value) <= reach * steepness;
  return std::abs(error) <= std::max(displaced, has_contour ? drawing.rounding : drawing.colour);
}

bool is_good(LatticeForm form, const Lattice& lattice, const std::vector<Check>& checks, double pixel, double reach,
             bool has_contours) {
  return std::all_of(checks.begin(), checks.end(), [&](const Check& check) {
    const Vec2 moved = drawn_value(form, lattice.positions, check.s, check.t) - check.field.x;
    const Mat2& slope = check.field.dv_dx;
    const Vec2 error = drawn_value(form, lattice.values, check.s, check.t) - check.field.value - slope * moved;
    return norm(moved) <= drawing.pixels * pixel &&
           is_unseen(error.x, check.field.value.x, {slope.xx, slope.xy}, pixel, reach, has_contours) &&
           is_unseen(error.y, check.field.value.y, {slope.yx, slope.yy}, pixel, reach, has_contours);
  });
}

double scale_of(const std::vector<Vec2>& values, double Vec2::*component) {
  double greatest = 0;
  for (const Vec2& value : values)
    if (std::isfinite(value.*component)) greatest = std::max(greatest, std::abs(value.*component));
  return greatest;
}

std::int16_t in_units_of(double scale, double value) {
  const double part = scale > 0 ? 32767 * value / scale : 0;
  return static_cast<std::int16_t>(std::isfinite(part) ? std::lround(std::clamp(part, -32767.0, 32767.0)) : 0);
}

void append(FieldSamples& samples, LatticeForm form, const Lattice& lattice, bool is_curved, const PageFrame& frame) {
  const int n = form.intervals();
  samples.forms.push_back(static_cast<std::uint8_t>(form.parts + 8 * form.lines + (is_curved ? 128 : 0)));
  for (int p = 0; p < form.num_points(); ++p)
    if (is_curved || p == 0 || p == n || p + 1 == form.num_points()) frame.append(samples.points, lattice.positions[p]);
  const double u = scale_of(lattice.values, &Vec2::x), v = scale_of(lattice.values, &Vec2::y);
  samples.scales.insert(samples.scales.end(), {u, v});
  for (const Vec2 value : lattice.values)
    samples.values.insert(samples.values.end(), {in_units_of(u, value.x), in_units_of(v, value.y)});
}

void append_triangle(FieldSamples& samples, const field::FieldEvaluator& evaluator, int elem, const PageFrame& frame) {
  const std::vector<Check> checks = checks_of(evaluator, elem);
  Lattice lattice;
  LatticeForm form{0, 0};
  double pixel = frame.pixel(checks.front().field.x);
  for (const Check& check : checks) pixel = std::min(pixel, frame.pixel(check.field.x));
  for (const LatticeForm next : lattice_forms) {
    if (next.parts != form.parts) lattice = lattice_of(evaluator, elem, next);
    form = next;
    const double reach = distance(lattice.positions.front(), lattice.positions.back()) / drawing.checks;
    if (is_good(form, lattice, checks, pixel, reach, evaluator.field().kind != FieldKind::phase)) break;
  }
  append(samples, form, lattice, !evaluator.maps()[elem].is_affine(), frame);
}

}  // namespace

Vec2 drawn_value(LatticeForm form, const std::vector<Vec2>& at_points, double s, double t) {
  const int n = form.parts * form.lines;
  const int p = std::min(static_cast<int>(s * n), n - 1), q = std::min(static_cast<int>(t * n), n - 1 - p);
  const double a = s * n - p, b = t * n - q;
  const auto at = [&](int i, int j) { return cubic_value(form, at_points, p + i, q + j); };
  const bool is_at_last_side = p + q + 1 == n;  // where rounding must not lead beyond it
  if (a + b <= 1 || is_at_last_side) return (1 - a - b) * at(0, 0) + a * at(1, 0) + b * at(0, 1);
  return (a + b - 1) * at(1, 1) + (1 - b) * at(1, 0) + (1 - a) * at(0, 1);
}

FieldSamples field_samples(const draw::RegionFields& regions, const PageFrame& frame) {
  FieldSamples samples;
  for (const field::FieldEvaluator& evaluator : regions.evaluators)
    for (int e = 0; e < evaluator.field().mesh.num_elems(); ++e) append_triangle(samples, evaluator, e, frame);
  return samples;
}

}  // namespace quadrille::page
