#pragma once
// Two irregular nodes of valence 3 whose separatrices run head on towards each other.

#include <gtest/gtest.h>

#include <complex>
#include <memory>

#include "square_field.hpp"
#include "trace/advance.hpp"
#include "trace/launch_directions.hpp"
#include "trace/merge_candidates.hpp"

namespace quadrille::trace {

// v = -e^{i skew} (z^2 - 1/4): nodes of valence 3 at -1/2 and 1/2. Without skew two of their separatrices run into each
// other along the axis; with it they pass each other.
struct TwoNodes : testing::Test {
  void make(double skew) {
    const auto value = [skew](Vec2 p) {
      const std::complex<double> z(p.x, p.y), v = -std::polar(1.0, skew) * (z * z - 0.25);
      return Vec2{v.real(), v.imag()};
    };
    field = interpolated_field(square_mesh({-1, -1}, 2, 4), 2, value);
    evaluator = std::make_unique<field::FieldEvaluator>(field);
    lines.clear();
    for (int n = 0; n < 2; ++n) {
      const mesh::Location at = evaluator->locator().find(nodes[n]);
      for (const double angle : launch_directions(evaluator->sample(at.elem, at.xi).dv_dx))
        lines.push_back(advance(*evaluator, launch_line(*evaluator, n, nodes[n], angle, 1e-4, 1), PointGrid(nodes),
                                {1e-11, 0.1, 10, 1e-7}));
    }
  }

  std::vector<MergeCandidate> candidates(double degrees_allowed, double distance_allowed = 0) const {
    return merge_candidates(*evaluator, lines, nodes, {radians(degrees_allowed), distance_allowed});
  }

  const std::vector<Vec2> nodes{{-0.5, 0}, {0.5, 0}};
  Field field;
  std::unique_ptr<field::FieldEvaluator> evaluator;
  std::vector<Streamline> lines;
};

}  // namespace quadrille::trace
