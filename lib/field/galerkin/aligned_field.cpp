#include "galerkin/aligned_field.hpp"

#include <algorithm>
#include <limits>

#include "field/evaluate.hpp"
#include "field/explicit_value.hpp"

namespace quadrille::galerkin {
namespace {

constexpr int max_rounds = 300;
constexpr double same_phase = 1e-11;  ///< radians: of a round that changes nothing

using ByElement = std::vector<Eigen::VectorXd>;  ///< values at the points of each element that has the term

/// e^(i phi) at the points of each element that has the term.
std::vector<std::vector<Vec2>> directions_at_points(const MeshContext& context, const ContinuousSystem& system,
                                                    const PhaseTerms& terms,
                                                    const std::vector<Eigen::MatrixXd>& coefs) {
  std::vector<std::vector<Vec2>> directions(coefs.size());
  for (int e = 0; e < std::ssize(coefs); ++e) {
    if (!system.has_term(e)) continue;
    const Vec2 centroid = context.maps[e].position(field::centroid);
    const Eigen::VectorXd s = system.values_of(e, coefs[e]);
    const std::vector<Vec2> points = system.points_of(e);
    for (std::size_t q = 0; q < points.size(); ++q)
      directions[e].push_back(field::explicit_direction(terms, points[q], centroid, s[static_cast<Eigen::Index>(q)]));
  }
  return directions;
}

/// Returns the greatest change.
double update(const ContinuousSystem& system, const Eigen::MatrixXd& dofs, const Loads& loads, ByElement& c) {
  double change = 0;
  for (int e = 0; e < std::ssize(c); ++e) {
    if (!system.has_term(e)) continue;
    const Eigen::VectorXd next = system.values_at_points(e, dofs, loads);
    change = std::max(change, (next - c[e]).cwiseAbs().maxCoeff());
    c[e] = next;
  }
  return change;
}

}  // namespace

ValuesInElement right_side_beside(const field::AlignmentTerm& term,
                                  const std::vector<const std::vector<Lifting>*>& liftings, bool has_target) {
  return [&term, liftings, has_target](int, const std::vector<Vec2>& points) {
    Eigen::MatrixXd f(std::ssize(points), 2 * std::ssize(liftings));
    for (std::size_t q = 0; q < points.size(); ++q) {
      const field::AlignmentTerm::Value at = term.at(points[q]);
      for (std::size_t i = 0; i < liftings.size(); ++i) {
        const Vec2 lifted = field::lifting_sum(*liftings[i], points[q]);
        const Vec2 value = (has_target ? at.target : Vec2{}) - at.rate * lifted;
        f.block<1, 2>(static_cast<Eigen::Index>(q), static_cast<Eigen::Index>(2 * i)) << value.x, value.y;
      }
    }
    return f;
  };
}

void align_phase(const MeshContext& context, ContinuousSystem& system, const field::AlignmentTerm& term,
                 const PhaseTerms& terms, Stopwatch& watch, std::vector<Eigen::MatrixXd>& coefs) {
  const std::vector<std::vector<Vec2>> directions = directions_at_points(context, system, terms, coefs);
  ByElement c(coefs.size());
  for (std::size_t e = 0; e < coefs.size(); ++e) c[e] = Eigen::VectorXd::Zero(std::ssize(directions[e]));
  const ValuesInElement right_side = [&](int e, const std::vector<Vec2>& points) {
    Eigen::MatrixXd f(std::ssize(points), 1);
    for (Eigen::Index q = 0; q < f.rows(); ++q) {
      const field::AlignmentTerm::Value at = term.at(points[q]);
      f(q) = at.rate * c[e][q] + cross(field::product(unit(c[e][q]), directions[e][q]), at.target);
    }
    return f;
  };
  const Eigen::MatrixXd given = Eigen::MatrixXd::Zero(system.map().num_dofs - system.map().num_unknowns, 1);
  Eigen::MatrixXd dofs;
  Loads loads;
  double change = std::numeric_limits<double>::infinity();
  for (int round = 0; round < max_rounds && change > same_phase; ++round) {
    loads = system.loads(right_side);
    dofs = system.solve(given, watch, 0, loads);
    change = update(system, dofs, loads, c);
  }
  const std::vector<Eigen::MatrixXd> added = system.all_coefs(dofs, loads);
  for (std::size_t e = 0; e < coefs.size(); ++e) coefs[e] += added[e];
}

}  // namespace quadrille::galerkin
