#pragma once
// Whether two points of the face see each other.

#include "field/evaluate.hpp"

namespace quadrille::guide {

/// Whether the segment from a to b lies in the mesh, tested at nine points.
inline bool is_segment_in_mesh(const field::FieldEvaluator& evaluator, Vec2 a, Vec2 b) {
  for (int i = 1; i < 10; ++i)
    if (evaluator.locator().find(a + (i / 10.0) * (b - a)).elem < 0) return false;
  return true;
}

}  // namespace quadrille::guide
