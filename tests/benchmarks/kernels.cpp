// Kernels of the field: what one call costs. Run it by tests/benchmarks/kernels, which stores the results.

#include <benchmark/benchmark.h>

#include <cmath>

#include "../unit/hand_made.hpp"
#include "../unit/support/square_field.hpp"
#include "field/error_estimate.hpp"
#include "field/evaluate.hpp"
#include "stiffness/element_matrices.hpp"
#include "triangulate/triangulate.hpp"
#include "zeros/cell.hpp"
#include "zeros/enclosure.hpp"

namespace {

using namespace quadrille;
using namespace quadrille::curve;
using namespace quadrille::field;
using namespace quadrille::galerkin;
using namespace quadrille::stiffness;
using namespace quadrille::triangulate;
using namespace quadrille::zeros;

// A half disc with z^4 + 2 on it, which vanishes nowhere, and a lifting.
Field half_disc_field(int order) {
  Report report;
  const CadFace face = hand_made::face({{segment({-1, 0}, {1, 0}), circular_arc({0, 0}, 1, 0, pi)}}, 2);
  TriangulateOptions options;
  Field field = interpolated_field(triangulate::triangulate(face, options, report), order, [](Vec2 p) {
    const Vec2 square{p.x * p.x - p.y * p.y, 2 * p.x * p.y};
    return Vec2{2 + square.x * square.x - square.y * square.y, 2 * square.x * square.y};
  });
  field.liftings = {{0, {-1, 0}, {-1.5, -0.5}, {0.1, 0}}};
  return field;
}

// Points along a spiral inside: neighbours in the sequence are near each other, as on a streamline or a raster.
std::vector<Vec2> spiral() {
  std::vector<Vec2> points;
  for (int i = 0; i < 1024; ++i) points.push_back(Vec2{0, 0.5} + 0.4 * (i / 1024.0) * unit(0.05 * i));
  return points;
}

int a_curved_element(const Field& field) { return field.mesh.curved_elems.front(); }

int a_straight_element(const FieldEvaluator& evaluator) {
  int e = 0;
  while (!evaluator.maps()[e].is_affine()) ++e;
  return e;
}

template <bool is_curved>
void value(benchmark::State& state) {
  const Field field = half_disc_field(static_cast<int>(state.range(0)));
  const FieldEvaluator evaluator(field);
  const int elem = is_curved ? a_curved_element(field) : a_straight_element(evaluator);
  Vec2 xi{-0.3, -0.4}, x;
  Mat2 dx_dxi;
  for (auto _ : state) {
    benchmark::DoNotOptimize(xi);
    benchmark::DoNotOptimize(evaluator.value(elem, xi, x, dx_dxi));
  }
}

template <bool is_curved>
void sample(benchmark::State& state) {
  const Field field = half_disc_field(static_cast<int>(state.range(0)));
  const FieldEvaluator evaluator(field);
  const int elem = is_curved ? a_curved_element(field) : a_straight_element(evaluator);
  Vec2 xi{-0.3, -0.4};
  for (auto _ : state) {
    benchmark::DoNotOptimize(xi);
    benchmark::DoNotOptimize(evaluator.sample(elem, xi));
  }
}

// Per point, location included.
void values_at(benchmark::State& state) {
  const Field field = half_disc_field(static_cast<int>(state.range(0)));
  const FieldEvaluator evaluator(field);
  const std::vector<Vec2> points = spiral();
  for (auto _ : state) benchmark::DoNotOptimize(evaluator.values_at(points));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
}

void locate_by_grid(benchmark::State& state) {
  const Field field = half_disc_field(1);
  const FieldEvaluator evaluator(field);
  const std::vector<Vec2> points = spiral();
  for (auto _ : state)
    for (const Vec2 x : points) benchmark::DoNotOptimize(evaluator.locator().find(x));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
}

void locate_by_walk(benchmark::State& state) {
  const Field field = half_disc_field(1);
  const FieldEvaluator evaluator(field);
  const std::vector<Vec2> points = spiral();
  mesh::Location at = evaluator.locator().find(points.front());
  for (auto _ : state)
    for (const Vec2 x : points) at = walk(evaluator.topology(), evaluator.maps(), x, at);
  benchmark::DoNotOptimize(at);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
}

template <bool is_curved>
void stiffness(benchmark::State& state) {
  const Field field = half_disc_field(1);
  const FieldEvaluator evaluator(field);
  const int elem = is_curved ? a_curved_element(field) : a_straight_element(evaluator);
  for (auto _ : state)
    benchmark::DoNotOptimize(stiffness_matrix(evaluator.maps()[elem], static_cast<int>(state.range(0))));
}

void condensation(benchmark::State& state) {
  const int order = static_cast<int>(state.range(0));
  const Field field = half_disc_field(1);
  const FieldEvaluator evaluator(field);
  const Eigen::MatrixXd matrix = stiffness_matrix(evaluator.maps()[a_straight_element(evaluator)], order);
  for (auto _ : state) benchmark::DoNotOptimize(condense(order, matrix));
}

// Bernstein form of an element and the proof that it holds no zero.
void exclusion(benchmark::State& state) {
  const Field field = half_disc_field(static_cast<int>(state.range(0)));
  const FieldEvaluator evaluator(field);
  const int elem = a_straight_element(evaluator);
  Enclosure enclosure;
  for (auto _ : state) {
    const Cell cell = element_cell(evaluator, elem);
    enclosure.set(cell, field.liftings);
    if (!enclosure.excludes_zero()) state.SkipWithError("the element was expected to be proved empty");
  }
}

// Per element.
void estimate(benchmark::State& state) {
  const Field field = half_disc_field(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(error_estimate(field));
  state.SetItemsProcessed(state.iterations() * field.mesh.num_elems());
}

BENCHMARK(value<false>)->Arg(4)->Arg(8)->Arg(12);
BENCHMARK(value<true>)->Arg(4)->Arg(8)->Arg(12);
BENCHMARK(sample<false>)->Arg(4)->Arg(8)->Arg(12);
BENCHMARK(sample<true>)->Arg(4)->Arg(8)->Arg(12);
BENCHMARK(values_at)->Arg(4)->Arg(8)->Arg(12);
BENCHMARK(locate_by_grid);
BENCHMARK(locate_by_walk);
BENCHMARK(stiffness<false>)->Arg(4)->Arg(8)->Arg(12);
BENCHMARK(stiffness<true>)->Arg(4)->Arg(8)->Arg(12);
BENCHMARK(condensation)->Arg(4)->Arg(8)->Arg(12);
BENCHMARK(exclusion)->Arg(4)->Arg(8)->Arg(12);
BENCHMARK(estimate)->Arg(4)->Arg(8)->Arg(12);

}  // namespace

BENCHMARK_MAIN();
