#include "ties/choice_cost.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "base/tolerance.hpp"
#include "field/boundary_values.hpp"
#include "guide/valence.hpp"

namespace quadrille::ties {
namespace {

/// Lengths in diameters.
struct ChoiceRules {
  double crowded = 0.005;   ///< a node nearer than this to the boundary or to a node is of no use to any mesh
  double narrow = 0.1;      ///< chamfers of up to about a quarter of the diameter have their node nearer than this
  double node = 0.1;        ///< what a node costs
  double far_field = 0.15;  ///< greater than what an angle off the tie by 2 degrees adds to the field
};
constexpr ChoiceRules rules;

/// Differences that count. Sides and positions may differ by what the angle is off the tie.
constexpr Cost tolerances{0.5, 0.5, 0.5, tolerance::tied, 0.5, 1e-3, 1e-3};

double node_clearance(const curve::FaceBoundary& boundary, const CriticalPoints& points, std::size_t node) {
  const Vec2 x = points.critical_points[node].position;
  double least = boundary.signed_distance(x);
  for (std::size_t i = 0; i < points.critical_points.size(); ++i)
    if (i != node) least = std::min(least, distance(points.critical_points[i].position, x));
  return least / boundary.face().diameter;
}

int num_halved(const TieOrbits& ties, const Choice& choice) {
  return static_cast<int>(std::count_if(ties.orbits.begin(), ties.orbits.end(), [&](const std::vector<int>& orbit) {
    return choice[orbit.front()] != choice[orbit.back()];
  }));
}

}  // namespace

std::optional<Criterion> difference(const Cost& a, const Cost& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::abs(a[i] - b[i]) > tolerances[i]) return static_cast<Criterion>(i);
  return {};
}

bool is_better(const Cost& a, const Cost& b) {
  const auto criterion = difference(a, b);
  return criterion && a[static_cast<std::size_t>(*criterion)] < b[static_cast<std::size_t>(*criterion)];
}

std::string text_of(Criterion criterion) {
  switch (criterion) {
    case Criterion::crowded:
    case Criterion::narrow:
      return "fewer nodes lie close to the boundary or to each other";
    case Criterion::halved:
      return "mirror images get equal valences";
    case Criterion::defect:
      return "the angles of the blocks are nearer to 90 degrees, a node counting a tenth";
    case Criterion::far_field:
      return "the field away from the corner turns that way";
    case Criterion::sides:
      return "smaller valences belong to longer sides";
    case Criterion::middle:
      return "smaller valences belong to corners far from the middle";
  }
  return "";
}

CostMeasure::CostMeasure(const field::FieldEvaluator& field, const TieOrbits& ties)
    : face_(&field.field().mesh.face), boundary_(*face_), ties_(&ties), is_narrow_(is_narrow_everywhere(field)) {
  for (const Joint& joint : face_->joints) middle_ += joint.position / static_cast<double>(face_->joints.size());
  for (const Tie& tie : ties.ties) far_signs_.push_back(far_sign(field, tie));
}

bool CostMeasure::is_narrow_everywhere(const field::FieldEvaluator& field) const {
  return std::all_of(field.maps().begin(), field.maps().end(), [&](const spectral::TriMap& map) {
    const Vec2 centre = map.position(field::centroid);
    return boundary_.signed_distance(centre) + field::radius_of(map, centre) < rules.narrow * face_->diameter;
  });
}

int CostMeasure::far_sign(const field::FieldEvaluator& field, const Tie& tie) const {
  const Joint& joint = face_->joints[tie.joint];
  const double side =
      std::min(guide::side_length(*face_, tie.joint), guide::side_length(*face_, face_->previous_in_loop(tie.joint)));
  Vec2 v;
  if (!field.value_at(joint.position + 0.25 * side * unit(joint.tangent_out + joint.interior_angle / 2), v)) return 0;
  const double turned = cross(field::boundary_value(*face_, tie.joint, face_->curves[tie.joint].begin()), v);
  return std::abs(turned) < rules.far_field ? 0 : turned > 0 ? 1 : -1;
}

Cost CostMeasure::operator()(const Choice& choice, const CriticalPoints& points) const {
  Cost cost{};
  const auto at = [&](Criterion criterion) -> double& { return cost[static_cast<std::size_t>(criterion)]; };
  for (std::size_t i = 0; i < points.critical_points.size(); ++i) {
    const double clearance = node_clearance(boundary_, points, i);
    at(Criterion::crowded) += clearance < rules.crowded;
    at(Criterion::narrow) += clearance < rules.narrow;
    at(Criterion::defect) += rules.node * std::abs(points.critical_points[i].index);
  }
  at(Criterion::halved) = num_halved(*ties_, choice);
  for (std::size_t u = 0; u < choice.size(); ++u)
    for (const int t : ties_->units[u]) {
      const Tie& tie = ties_->ties[t];
      at(Criterion::defect) += guide::angle_defect(tie.angle, tie.smaller + (choice[u] ? 0 : 1));
      at(Criterion::far_field) += far_signs_[t] == (choice[u] ? -1 : 1);
      if (!choice[u]) continue;
      const double sides =
          guide::side_length(*face_, tie.joint) + guide::side_length(*face_, face_->previous_in_loop(tie.joint));
      at(Criterion::sides) -= sides / face_->diameter;
      at(Criterion::middle) -= distance(face_->joints[tie.joint].position, middle_) / face_->diameter;
    }
  return cost;
}

// Nodes have valences of 3 at least.
Cost CostMeasure::least(const Choice& choice, int index, int max_valence) const {
  Cost cost = (*this)(choice, {});
  const int fewest = index > 0 ? index : (max_valence - 5 - index) / (max_valence - 4);
  if (is_narrow_) cost[static_cast<std::size_t>(Criterion::narrow)] = fewest;
  cost[static_cast<std::size_t>(Criterion::defect)] += rules.node * std::abs(index);
  return cost;
}

}  // namespace quadrille::ties
