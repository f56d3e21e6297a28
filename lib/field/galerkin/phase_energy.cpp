#include "galerkin/phase_energy.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "field/explicit_value.hpp"
#include "spectral/quadrature.hpp"
#include "surface/positions.hpp"

namespace quadrille::galerkin {
namespace {

/// The sum of integers times logarithms, at the cost of one logarithm for most sums.
class LogSum {
 public:
  void add(double a, int times) {
    double& product = times > 0 ? product_ : divisor_;
    for (int i = std::abs(times); i > 0; --i) {
      product *= a;
      if (!(product > 1e-150 && product < 1e150)) take_logarithms();
    }
  }
  double value() const { return sum_ + std::log(product_ / divisor_); }

 private:
  void take_logarithms() {
    sum_ += std::log(product_) - std::log(divisor_);
    product_ = divisor_ = 1;
  }

  double product_ = 1, divisor_ = 1, sum_ = 0;
};

/// Of a piece of a curve over which one rule integrates.
struct PieceLimits {
  double greatest_turn = 0.8;  ///< radians
  double nearest = 0.5;        ///< distance of a source, relative to the length
  double too_near = 3e-6;      ///< below this fraction, the direction from the apex is rounding error
};
constexpr PieceLimits piece_limits;

/// weight * ln |z - position| in L.
struct Source {
  Vec2 position;
  double weight;
};

/// Part [t0, t1] of a curve; apex0 and apex1: the sources at its ends, -1: none.
struct Piece {
  double t0, t1;
  int apex0, apex1;
};

class BoundaryIntegral {
 public:
  BoundaryIntegral(const CadFace& face, const std::vector<Source>& sources, int first_apex)
      : face_(face), sources_(sources), first_apex_(first_apex) {}

  /// int L (dPhi - dA / 2) along the curve between ascending `cuts`.
  double over(int curve, const std::vector<double>& cuts) {
    curve_ = &face_.curves[curve];
    double sum = 0;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
      sum += over({cuts[i], cuts[i + 1], apex_at(cuts[i]), apex_at(cuts[i + 1])}, 0);
    return sum;
  }

 private:
  int apex_at(double t) const {
    const Vec2 x = curve::point(*curve_, t);
    const auto is_there = [&](const Source& s) { return distance(s.position, x) <= 1e-11 * face_.diameter; };
    const auto found = std::find_if(sources_.begin(), sources_.end(), is_there);
    return found == sources_.end() ? -1 : static_cast<int>(found - sources_.begin());
  }

  double over(const Piece& piece, int depth) const {
    constexpr int deepest = 60;
    if (depth == deepest || is_short(piece)) return integral(piece);
    const double middle = (piece.t0 + piece.t1) / 2;
    return over({piece.t0, middle, piece.apex0, -1}, depth + 1) + over({middle, piece.t1, -1, piece.apex1}, depth + 1);
  }

  bool is_short(const Piece& piece) const {
    if (piece.apex0 >= 0 && piece.apex1 >= 0) return false;
    const Vec2 x[] = {curve::point(*curve_, piece.t0), curve::point(*curve_, (piece.t0 + piece.t1) / 2),
                      curve::point(*curve_, piece.t1)};
    const double length = distance(x[0], x[1]) + distance(x[1], x[2]);
    if (dot(curve::tangent(*curve_, piece.t0), curve::tangent(*curve_, piece.t1, true)) <
        std::cos(piece_limits.greatest_turn))
      return false;
    if (dot(x[1] - x[0], x[2] - x[1]) <
        std::cos(piece_limits.greatest_turn) * distance(x[0], x[1]) * distance(x[1], x[2]))
      return false;
    for (int i = 0; i < static_cast<int>(sources_.size()); ++i) {
      if (i == piece.apex0 || i == piece.apex1) continue;
      for (const Vec2 at : x)
        if (norm2(at - sources_[i].position) < piece_limits.nearest * piece_limits.nearest * length * length)
          return false;
    }
    return true;
  }

  // L is logarithmic at an apex: the points are graded towards it, t ~ u^6.
  double integral(const Piece& piece) const {
    static const spectral::Quadrature rule = spectral::gauss_legendre(16), fine_rule = spectral::gauss_legendre(20);
    const bool at_begin = piece.apex0 >= 0, is_graded = at_begin || piece.apex1 >= 0;
    const double length = piece.t1 - piece.t0;
    const spectral::Quadrature& used = is_graded ? fine_rule : rule;
    double sum = 0;
    for (std::size_t q = 0; q < used.points.size(); ++q) {
      const double u = (1 + used.points[q]) / 2, weight = used.weights[q] / 2;
      if (!is_graded) {
        sum += weight * length * integrand(piece.t0 + length * u, -1, 0);
        continue;
      }
      const double fraction = std::pow(u, 6), slope = 6 * std::pow(u, 5);
      const double t = at_begin ? piece.t0 + length * fraction : piece.t1 - length * fraction;
      sum += weight * length * slope * integrand(t, at_begin ? piece.apex0 : piece.apex1, fraction);
    }
    return sum;
  }

  double integrand(double t, int apex, double fraction) const {
    const double least2 = 1e-34 * face_.diameter * face_.diameter;  // a point near an apex may be rounded onto it
    const auto [x, d1, d2, d3] = curve::derivatives(*curve_, t);
    const double bend = cross(d1, d2) / norm2(d1);  // d theta_t / dt
    double turning = 0;
    const auto turn = [&, d1 = d1](int i, Vec2 r, double r2) {
      return i == apex && fraction < piece_limits.too_near ? bend / 2 : cross(r, d1) / r2;
    };
    LogSum turns;
    for (int i = 0; i < first_apex_; ++i) {
      const Vec2 r = x - sources_[i].position;
      const double r2 = std::max(norm2(r), least2);
      turns.add(r2, static_cast<int>(sources_[i].weight));
      turning += sources_[i].weight * turn(i, r, r2);
    }
    double log_sum = turns.value() / 2;
    for (int i = first_apex_; i < static_cast<int>(sources_.size()); i += 2) {
      const Vec2 r = x - sources_[i].position, from_pole = x - sources_[i + 1].position;
      const double r2 = std::max(norm2(r), least2), pole2 = norm2(from_pole);
      log_sum += sources_[i].weight * std::log(r2 / pole2) / 2;
      turning += sources_[i].weight * (turn(i, r, r2) - cross(from_pole, d1) / pole2);
    }
    return log_sum * (4 * bend - turning / 2);
  }

  const CadFace& face_;
  const std::vector<Source>& sources_;
  int first_apex_;
  const Nurbs* curve_ = nullptr;
};

// Ends, inner knots and boundary nodes of a curve.
std::vector<double> cuts_of(const CadFace& face, int c, const PhaseNodes& asked) {
  const Nurbs& curve = face.curves[c];
  std::vector<double> cuts(curve.knots.begin() + curve.degree, curve.knots.end() - curve.degree);
  const double tol = 1e-12 * (curve.end() - curve.begin());
  for (const BoundaryNode& node : asked.boundary_nodes)
    if (node.curve == c && node.t > curve.begin() + tol && node.t < curve.end() - tol) cuts.push_back(node.t);
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end(), [&](double a, double b) { return b - a <= tol; }), cuts.end());
  cuts.back() = curve.end();
  return cuts;
}

// L at x without the sources that are there.
double log_of_others(const std::vector<Source>& sources, Vec2 x, double same) {
  double sum = 0;
  for (const Source& source : sources)
    if (const double away = distance(source.position, x); away > same) sum += source.weight * std::log(away);
  return sum;
}

}  // namespace

double explicit_energy(const CadFace& face, const PhaseNodes& asked, const PhaseTerms& terms,
                       const std::vector<field::ApexTurn>& apex_turns) {
  std::vector<Source> sources;
  for (const PhaseTurn& turn : terms.nodes) sources.push_back({turn.position, static_cast<double>(turn.turns)});
  for (const auto* turns : {&terms.holes, &terms.images})
    for (const PhaseTurn& turn : *turns)
      if (turn.turns != 0) sources.push_back({turn.position, static_cast<double>(turn.turns)});
  const std::size_t first_apex = sources.size();
  for (const CornerAngle& corner : terms.corner_angles) {
    sources.push_back({corner.apex, corner.beta});
    sources.push_back({corner.pole, -corner.beta});
  }
  BoundaryIntegral integral(face, sources, static_cast<int>(first_apex));
  double energy = 0;
  for (int c = 0; c < face.num_curves(); ++c) energy += integral.over(c, cuts_of(face, c, asked));
  const double same = tolerance::round_off * face.diameter;
  for (const PhaseTurn& node : terms.nodes) energy -= pi * node.turns * log_of_others(sources, node.position, same);
  for (const field::ApexTurn& apex : apex_turns) energy += apex.turn * log_of_others(sources, apex.position, same);
  return energy;
}

mesh::Location locate_node(const mesh::Locator& locator, const TriMesh& mesh, Vec2 node) {
  const mesh::Location at = locator.find(node);
  if (at.elem >= 0) return at;
  throw ComputeError("the irregular node at " + surface::position_text(mesh.face, node) + " is outside the mesh");
}

Vec2 phase_energy_gradient(const PhaseTerms& terms, int k, Vec2 remainder_slope) {
  const PhaseTurn node = terms.nodes[k];
  PhaseTerms others = terms;
  others.nodes.erase(others.nodes.begin() + k);
  const Vec2 slope = remainder_slope + field::explicit_phase_gradient(others, node.position);
  return -2 * pi * node.turns * Vec2{slope.y, -slope.x};
}

}  // namespace quadrille::galerkin
