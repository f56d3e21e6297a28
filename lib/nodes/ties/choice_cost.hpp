#pragma once
// What a choice of valences at ties costs. The first figure that differs decides.

#include <array>
#include <optional>
#include <string>

#include "curve/face_boundary.hpp"
#include "field/evaluate.hpp"
#include "model/critical_points.hpp"
#include "ties/tilted_field.hpp"

namespace quadrille::ties {

/// In the order of their weight.
enum class Criterion {
  crowded,    ///< nodes too close to the boundary or to another node
  halved,     ///< orbits whose mirror images differ
  narrow,     ///< nodes close to the boundary or to another node
  defect,     ///< sum V (omega / (90 V) - 1)^2, and a tenth for each node
  far_field,  ///< ties that turn against the field away from the corner
  sides,      ///< minus the lengths of the sides at ties with the smaller valence, in diameters
  middle      ///< minus their distances from the middle of the face, in diameters
};
using Cost = std::array<double, 7>;

/// The first criterion by which both differ; std::nullopt if they are equal.
std::optional<Criterion> difference(const Cost& a, const Cost& b);
bool is_better(const Cost& a, const Cost& b);
/// A clause for people: "there are fewer nodes ...".
std::string text_of(Criterion criterion);

/// Measures choices on one face.
class CostMeasure {
 public:
  /// `field`: without tilts. Both must outlive this.
  CostMeasure(const field::FieldEvaluator& field, const TieOrbits& ties);
  /// `points`: what the choice leads to.
  Cost operator()(const Choice& choice, const CriticalPoints& points) const;
  /// At least what the choice costs, whatever nodes of this total index, of up to `max_valence`, it leads to.
  Cost least(const Choice& choice, int index, int max_valence) const;

 private:
  bool is_narrow_everywhere(const field::FieldEvaluator& field) const;
  int far_sign(const field::FieldEvaluator& field, const Tie& tie) const;

  const CadFace* face_;
  curve::FaceBoundary boundary_;
  const TieOrbits* ties_;
  Vec2 middle_;
  bool is_narrow_;              ///< wherever a node lies, it is close to the boundary
  std::vector<int> far_signs_;  ///< of each tie; 1: the smaller valence, -1: the larger, 0: undecided
};

}  // namespace quadrille::ties
