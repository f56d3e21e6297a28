#pragma once
// The guiding field at a point: value, gradient, position. Later stages access a field only through this header.

#include <atomic>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "base/angle_sum.hpp"
#include "curve/symmetry.hpp"
#include "mesh/locate.hpp"
#include "mesh/tri_topology.hpp"
#include "model/field.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::field {

/// Of the reference triangle.
inline constexpr Vec2 centroid{-1.0 / 3, -1.0 / 3};

/// The radius of a disc around `centre`, the position of the centroid, that contains the element with a margin.
double radius_of(const spectral::TriMap& map, Vec2 centre);

/// The explicit terms of a field (liftings, or those of a phase) as seen from a disc: most apexes, nodes and holes are
/// far from it, and the sum of their angles is one power series there (base/angle_sum).
class DiscTerms {
 public:
  /// All terms of the field, none of them far.
  explicit DiscTerms(const Field& field);
  /// In a disc that lies inside that of `outer`.
  DiscTerms(const DiscTerms& outer, Vec2 centre, double radius);

  /// Whether far_liftings and far_phase are valid at x.
  bool contains(Vec2 x) const { return expansion_.contains(x); }
  int num_near() const;

  /// Liftings that are not far, and the sum of the others at x.
  const std::vector<Lifting>& near_liftings() const { return near_liftings_; }
  Vec2 far_liftings(Vec2 x) const { return at_centre_ + expansion_.at(x); }

  /// Terms of a phase that are not far. The others sum up to the angle of far_direction() plus far_phase(x), radians.
  const PhaseTerms& near_terms() const { return near_terms_; }
  Vec2 far_direction() const { return at_centre_; }
  double far_phase(Vec2 x) const { return expansion_.at(x).x; }

 private:
  void split_liftings(const DiscTerms& outer, Vec2 centre);
  void split_terms(const DiscTerms& outer, Vec2 centre);
  void split_turns(const std::vector<PhaseTurn>& turns, std::vector<PhaseTurn>& near, std::vector<PhaseTurn>& far);

  bool is_phase_;
  AngleExpansion expansion_;
  Vec2 at_centre_;  // sum of the far liftings, or direction of the far terms, at the centre of the disc
  std::vector<Lifting> near_liftings_;
  PhaseTerms near_terms_;
};

/// The terms of each element, made when they are first asked for. Where there are many, those far from a group of
/// elements are summed once for the group, and again for each of the cells of which it consists. May be used by several
/// threads at once.
class ElementTerms {
 public:
  /// Both must outlive the object.
  ElementTerms(const Field& field, const std::vector<spectral::TriMap>& maps);
  /// In a disc that contains the element.
  const DiscTerms& of(int elem) const;

 private:
  struct Disc {
    Vec2 centre;
    double radius = 0;
    std::once_flag is_made;
    std::unique_ptr<const DiscTerms> terms;
    std::atomic<const DiscTerms*> ready = nullptr;  // terms.get() once they are made

    /// outer(): the terms of a disc around this one; called only to make those of this one.
    template <typename Outer>
    const DiscTerms& made(const Outer& outer);
    void enclose(const Disc& other);
  };
  void group_elements();

  DiscTerms all_;
  mutable std::vector<Disc> discs_;           // by element
  mutable std::vector<Disc> cells_, groups_;  // of a few elements, of a few cells; empty if there are few terms
  std::vector<int> elem2cell_, cell2group_;
};

/// Value and derivatives of the field and of the element map at a point of an element.
struct FieldSample {
  Vec2 x;
  Mat2 dx_dxi;
  Vec2 value;  ///< v = (u, v), liftings included; a unit vector if the field is of kind "phase"
  Mat2 dv_dx;  ///< rows u, v
};

/// The field at a point of the plane; at.elem = -1 outside the mesh, with zero value.
struct PointSample {
  mesh::Location at;
  Vec2 value;
};

/// How the explicit terms of a field, which are singular at corners and nodes, are evaluated: one by one, or those far
/// from an element by one power series, which is made when the element is first used. Values differ by round-off.
enum class FarTerms { summed, expanded };

/// Evaluates a field on the elements of its mesh or at points of the plane.
class FieldEvaluator {
 public:
  /// `field` must outlive the evaluator. Builds maps, topology and locator.
  explicit FieldEvaluator(const Field& field, FarTerms far_terms = FarTerms::summed);
  FieldEvaluator(const FieldEvaluator&) = delete;  // the locator refers to the maps
  FieldEvaluator& operator=(const FieldEvaluator&) = delete;
  /// Jumps of liftings must not change while far terms are expanded.
  void set_far_terms(FarTerms far_terms);

  /// Value, position and element map derivative, as a streamline integrator needs them. At a corner with a lifting the
  /// value depends on the direction of approach: the limit from the element's centroid is returned. Cost: linear in
  /// the number of modes and of explicit terms (of those that are not far if the far ones are expanded).
  Vec2 value(int elem, Vec2 xi, Vec2& x, Mat2& dx_dxi) const;
  /// Value and gradient at reference coordinates xi of element `elem`. Liftings with their corner at this point do not
  /// contribute to the gradient, which has no limit there.
  FieldSample sample(int elem, Vec2 xi) const;
  /// Value at a physical point; false when x lies outside the mesh.
  bool value_at(Vec2 x, Vec2& value) const;
  /// The same; looks first in the element of `at`, from its xi, and replaces `at` by where x lies, if inside the mesh.
  bool value_near(Vec2 x, mesh::Location& at, Vec2& value) const;
  /// Value at many physical points: each is located by a walk through the mesh from the previous point
  /// (mesh/locate), and by the search grid if the walk fails. Fastest if successive points are near each other.
  std::vector<PointSample> values_at(const std::vector<Vec2>& points) const;

  const Field& field() const { return *field_; }
  const std::vector<spectral::TriMap>& maps() const { return maps_; }
  const mesh::TriTopology& topology() const { return topology_; }
  const mesh::Locator& locator() const { return locator_; }

 private:
  /// The terms as seen from the element; nullptr if they are evaluated one by one at x.
  const DiscTerms* expanded_terms(int elem, Vec2 x) const;
  Vec2 liftings(int elem, Vec2 x) const;
  Vec2 sum_of(const std::vector<Lifting>& liftings, int elem, Vec2 x) const;
  Vec2 inward(int elem, Vec2 x) const;  ///< from x towards the element's centroid
  Vec2 value(mesh::Location at) const;
  Vec2 phase_value(double remainder, int elem, Vec2 x) const;
  FieldSample phase_sample(int elem, Vec2 xi) const;

  const Field* field_;
  bool is_phase_;
  std::vector<spectral::TriMap> maps_;
  mesh::TriTopology topology_;
  mesh::Locator locator_;
  std::unique_ptr<const ElementTerms> expanded_;  // nullptr if far terms are summed
};

/// The fields of the regions of a face, of which each point has one. A field whose region is round may be rotated.
class FieldsOfRegions {
 public:
  FieldsOfRegions(const FieldEvaluator& only)  // NOLINT(*-explicit-*): one field is a case of many
      : FieldsOfRegions(std::vector<const FieldEvaluator*>{&only}) {}
  /// Not null; they must outlive the object. `rotations`: of each region, or empty.
  explicit FieldsOfRegions(std::vector<const FieldEvaluator*> regions, std::vector<curve::Rotation> rotations = {})
      : regions_(std::move(regions)), rotations_(std::move(rotations)) {
    rotations_.resize(regions_.size());
  }

  /// As FieldEvaluator::values_at, of the first region that contains the point; in a rotated region PointSample::at is
  /// where the point lies before the rotation.
  std::vector<PointSample> values_at(const std::vector<Vec2>& points) const;

 private:
  std::vector<PointSample> values_in(std::size_t region, std::vector<Vec2> points) const;

  std::vector<const FieldEvaluator*> regions_;
  std::vector<curve::Rotation> rotations_;
};

/// phi_0 of node `node` of a field of kind "phase" (field.phase.prescribed.nodes; lib/method.md §8.7), radians, modulo
/// 2 pi:
///   phi(z) = phi_0 + d arg(z - a) + O(|z - a|)   near a node a of index d = 4 - V,
/// where the cross has the direction alpha if 4 alpha = phi_0 + d alpha (mod 2 pi). Throws FormatError if the node lies
/// outside the mesh. Linear in the number of terms.
double node_phase(const FieldEvaluator& evaluator, int node);

}  // namespace quadrille::field
