#pragma once
// The explicit terms of a field (liftings, or those of a phase) for evaluation on one element: most apexes, nodes and
// holes are far from it, and the sum of their angles is one power series there (base/angle_expansion). Where there are
// many terms, those far from a group of elements are summed once for the group, and again for each of the cells of
// which it consists.

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "base/angle_expansion.hpp"
#include "model/field.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::field {

/// Of the reference triangle.
inline constexpr Vec2 centroid{-1.0 / 3, -1.0 / 3};

/// The terms as seen from a disc.
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

/// The terms of each element, made when they are first asked for. May be used by several threads at once.
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

}  // namespace quadrille::field
