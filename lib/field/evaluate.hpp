#pragma once
// The guiding field at a point: value, gradient, position. The one way in which later stages see a field.

#include <vector>

#include "mesh/locate.hpp"
#include "mesh/tri_topology.hpp"
#include "model/field.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::field {

struct FieldSample {
  Vec2 x;
  Mat2 dx_dxi;
  Vec2 value;  ///< v = (u, v), liftings included; a unit vector where the field is of kind "phase"
  Mat2 dv_dx;  ///< rows u, v
};

/// The field at a point of the plane; at.elem = -1: outside the mesh, and zeros.
struct PointSample {
  mesh::Location at;
  Vec2 value;
  Mat2 dv_dx;
};

class FieldEvaluator {
 public:
  /// `field` must outlive the evaluator. Builds maps, topology and locator.
  explicit FieldEvaluator(const Field& field);
  FieldEvaluator(const FieldEvaluator&) = delete;  // the locator refers to the maps
  FieldEvaluator& operator=(const FieldEvaluator&) = delete;

  /// Position and value only: what a streamline needs. On a corner with a lifting the value depends on the direction
  /// of approach: there it is the limit from the element's centroid. No allocation; cost linear in the number of
  /// modes and of liftings.
  Vec2 value(int elem, Vec2 xi, Vec2& x, Mat2& dx_dxi) const;
  FieldSample sample(int elem, Vec2 xi) const;
  /// Value at a physical point; false when x lies outside the mesh.
  bool value_at(Vec2 x, Vec2& value) const;
  /// Value and gradient at many physical points: each is sought by a walk from the one before (mesh/locate), and by the
  /// search grid where that ends without an answer. Quickest for points in a sequence that does not jump.
  std::vector<PointSample> values_at(const std::vector<Vec2>& points) const;
  /// sample() at many places, which must exist.
  std::vector<FieldSample> samples(const std::vector<mesh::Location>& places) const;

  const Field& field() const { return *field_; }
  const std::vector<spectral::TriMap>& maps() const { return maps_; }
  const mesh::TriTopology& topology() const { return topology_; }
  const mesh::Locator& locator() const { return locator_; }

 private:
  Vec2 liftings(int elem, Vec2 x) const;
  Vec2 inward(int elem, Vec2 x) const;  ///< from x towards the element's centroid
  Vec2 phase_value(double remainder, int elem, Vec2 x) const;
  FieldSample phase_sample(int elem, Vec2 xi) const;

  const Field* field_;
  bool is_phase_;
  std::vector<spectral::TriMap> maps_;
  mesh::TriTopology topology_;
  mesh::Locator locator_;
};

}  // namespace quadrille::field
