#include "trace/require_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace quadrille {
namespace {

constexpr double node_share = 1e-6;  // of the diameter: how far a node may lie from its zero

// A zero of the index that the file says.
bool is_zero(const FieldEvaluator& evaluator, const CriticalPoint& p) {
  if (p.valence != 4 - p.index) return false;
  const double diameter = evaluator.field().mesh.face.diameter;
  const Location at = evaluator.locator().find(p.position);
  if (at.elem < 0) return false;
  const FieldSample sample = evaluator.sample(at.elem, at.xi);
  // A multiple zero has no slope to tell its distance by, but the field is small about it.
  if (std::abs(p.index) != 1) return norm(sample.value) <= 1e-4;
  if ((det(sample.dv_dx) > 0) != (p.index > 0)) return false;
  const Vec2 off = inverse(sample.dv_dx) * sample.value;
  return norm(off) <= node_share * diameter;
}

}  // namespace

void require_nodes_of_field(const FieldEvaluator& evaluator, const CriticalPoints& points) {
  const CadFace& face = evaluator.field().mesh.face;
  int sum = 0;
  for (const CriticalPoint& p : points.critical_points) {
    sum += 4 - p.valence;
    if (is_zero(evaluator, p)) continue;
    const Vec2 place = p.position + face.origin;
    throw FormatError(
        fmt::format("the node at ({:.6g}, {:.6g}) is no zero of the field: run fieldsolve --nodes", place.x, place.y));
  }
  for (const Corner& c : points.corners) {
    sum += 2 - c.valence;
    if (c.joint < 0 || c.joint >= face.num_curves() || !face.joints[c.joint].is_corner)
      throw FormatError(fmt::format("joint {} of the critical points is no corner of the field's face", c.joint));
  }
  const int expected = 4 * face.euler_characteristic();
  if (sum != expected)
    throw FormatError(fmt::format("the index sum of nodes and corners is {} where the domain needs {}", sum, expected));
}

}  // namespace quadrille
