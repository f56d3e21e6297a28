#pragma once
// The energy that vertices minimise so that elements have the prescribed size, and the shape of squares as far as that
// allows.
//
// With h the prescribed size of an element (h_s and h_t where they differ), a = x_s / h and b = x_t / h the derivatives
// of its map from the unit square, J = a x b and mu = (|a|^2 + |b|^2) / (2 J) >= 1:
//
//   F = sum over elements of the mean of  (|a|^2q + |b|^2q) J / 2 + w mu^3 + w c (x^-12 - 1),    q = 4, w = 1.
//
// Where a metric M is prescribed, h is sqrt(h1 h2) and a = S x_s / h, b = S x_t / h, S = h sqrt(M) of determinant 1:
// lengths and areas are those in M; x of the third term stays the sine in the plane. Where directions are prescribed,
// by c = |c| e^(4 i angle) in each element, the mean of
//
//   2 |c| - Re(conj(c) ((a / |a|)^4 + (b / |b|)^4)),    a and b as complex numbers,
//
// is added: 0 where both sides follow the cross, 4 |c| at 45 degrees from it, whatever their lengths.
//
// The first term is that by which the error of elements of order q - 1 grows with their lengths for a solution that
// has no preferred direction, as in R (mesh/element_sizes); for equal areas it is least for equal squares. The second
// one has no bound where J tends to 0, the third one keeps angles (refine/skew_energy). The mean is that of the corners
// where an element is bilinear, else of Gauss-Lobatto-Legendre points. A mesh is bilinear in its vertices but for sides
// that are curved: those on CAD curves, which follow their ends along the curve, and edges inside that keep their
// curves, whose displacement from the chord does not change.

#include <Eigen/Dense>
#include <array>
#include <vector>

#include "base/symmetric_tensor.hpp"
#include "mesh/element_sizes.hpp"
#include "refine/relax_problem.hpp"
#include "refine/sampled_loops.hpp"

namespace quadrille::refine {

/// Derivatives of the energy by the moves of the vertices, along the curve for those that slide.
struct EnergyDerivatives {
  double value = 0;  ///< infinite if det J is not positive
  VertexMoves gradient;
  std::vector<std::array<double, 3>> blocks;  ///< positive parts of the Hessian's diagonal: xx, xy, yy; if asked for
};

/// Second derivatives by the moves of the corners, (x, y) of each in turn; of corners that slide x is the slide.
using ElementHessian = Eigen::Matrix<double, 8, 8>;

class SizeEnergy {
 public:
  /// `shaped`: the mesh of the problem with its edges inside as they are to be (refine/inner_edges), measured.
  SizeEnergy(const RelaxProblem& problem, const QuadMesh& shaped);

  /// The prescribed lengths of each element along s and t; scaled by one factor, so that as many rectangles of these
  /// lengths as there are elements fill the mesh. `log_size_gradients`: of each element the gradient of the logarithm
  /// of its lengths, which are those given where its middle is now; empty: lengths stay.
  void set_sizes(const std::vector<Vec2>& sizes, std::vector<Vec2> log_size_gradients = {});
  /// The weight w of the shape of each element, and of its angles (refine/skew_energy).
  std::vector<double> shape_weights, skew_weights;
  /// How many elements each one stands for (refine/count_relaxer).
  std::vector<double> multiplicities;
  /// S of each element; empty: the unit tensor.
  std::vector<SymmetricTensor> stretches;
  /// c of each element; empty: none has prescribed directions.
  std::vector<Vec2> directions;

  double value(const VertexMoves& moves) { return with_derivatives(moves).value; }
  EnergyDerivatives with_derivatives(const VertexMoves& moves, bool has_blocks = false);
  /// By element, where the energy was computed last; positive semidefinite (refine/point_energy).
  std::vector<ElementHessian> hessians() const;
  /// Of the vertices, where the energy was computed last.
  const std::vector<Vec2>& positions() const { return position_; }
  const std::vector<Vec2>& positions(const VertexMoves& moves) { return place(moves), position_; }
  /// Of the curves at the vertices that slide, where the energy was computed last.
  const std::vector<Vec2>& curve_tangents() const { return tangent_; }
  /// Of each element, with its length h or 0, where the energy was computed last (mesh/element_sizes).
  std::vector<mesh::ElementPowers> powers(const std::vector<double>& lengths) const;
  /// Middle of each element's vertices.
  std::vector<Vec2> middles(const VertexMoves& moves);
  bool is_free(int elem) const { return is_free_[elem]; }
  /// Factors of the size of an element along s and t, at most 1, by which bent sides cost no more than straight ones,
  /// where the energy was computed last.
  Vec2 bend_factors(int elem, double size) const;

 private:
  static constexpr int points = 4;  ///< Gauss-Lobatto-Legendre points in each direction, if a side is curved
  using SidePoints = std::array<Vec2, points>;
  struct CurvedSide {
    int edge = -1;         ///< of BoundarySlide; -1: inside, or its ends are fixed
    SidePoints shift{};    ///< from the chord
    SidePoints slope{};    ///< of the shift, by the position along the side
    SidePoints tangent{};  ///< of the curve
    SidePoints bend{};
  };
  struct Sides {
    std::array<int, 4> side{-1, -1, -1, -1};  ///< into sides_, in the side's own direction
    std::array<bool, 2> is_linear{};          ///< of sides 0 and 2, 1 and 3: both are curved
  };
  using Values = std::array<double, points * points>;  ///< at the points of the element's rule; s fastest
  struct Vectors {
    Values x, y;

    Vec2 operator[](int point) const { return {x[point], y[point]}; }
    void add(int point, Vec2 v) { x[point] += v.x, y[point] += v.y; }
    void set(int point, Vec2 v) { x[point] = v.x, y[point] = v.y; }
  };
  struct Tangents {
    Vectors a, b;  ///< S x_s / h, S x_t / h
  };
  struct Blend {
    std::array<double, points> value{}, slope{};  ///< at the points of a line away from the side
  };
  /// A rule of quadrature on the unit square. Bilinear elements need only their corners, where det J is least.
  struct Rule {
    explicit Rule(int count);  ///< of Gauss-Lobatto-Legendre points in each direction, at most `points`
    int size = 0;
    Values s, t, weight;
  };

  void lighten_sharp_corners();
  void weigh_angles(const QuadMesh& shaped);
  void add_curved_sides(const QuadMesh& shaped);
  void place(const VertexMoves& moves);
  void place_side(CurvedSide& side, const VertexMoves& moves) const;
  Tangents tangents(int elem) const { return tangents(elem, rule(elem)); }
  Tangents tangents(int elem, const Rule& at) const;
  void add_shifts(int elem, Tangents& at) const;
  void stretch(int elem, const Rule& of, Tangents& at) const;
  double curvature(int elem, int side) const;
  Vec2 direction(int elem) const { return directions.empty() ? Vec2{} : directions[elem]; }
  double add_direction(int elem, const Tangents& at, Tangents& by) const;
  double add_skewness_in_plane(int elem, const Tangents& at, Tangents& by) const;
  /// Of a or b: without S.
  Vec2 in_plane(int elem, Vec2 a) const { return stretches.empty() ? a : inverse(stretches[elem]) * a; }
  Eigen::Matrix4d bend_of_angles(int elem, Vec2 a, Vec2 b) const;
  double slopes(int elem, const Tangents& at, Tangents& by) const;
  std::array<Vec2, 4> by_corners(int elem, const Tangents& by) const;
  Vec2 middle(int elem) const;
  void update_sizes();
  Vec2 by_middle(int elem, const Tangents& at, const Tangents& by) const;
  void add_element(int elem, EnergyDerivatives& sum);
  SidePoints by_shifts(const Sides& sides, int side, const Tangents& by) const;
  using MoveSlopes = std::array<Eigen::Matrix<double, 4, 8>, points * points>;
  MoveSlopes move_slopes(int elem) const;
  void add_slides_of_points(int elem, int side, MoveSlopes& by_move) const;
  ElementHessian hessian(int elem) const;
  void add_bends(int elem, const Tangents& by, ElementHessian& sum) const;
  void add_blocks(int elem, const Tangents& at, EnergyDerivatives& sum) const;
  void pull_back_sides(int elem, const Tangents& by);
  void reduce_to_curves(EnergyDerivatives& sum) const;
  int sliding_side(int elem, int side) const;
  SidePoints slopes_of(const SidePoints& shift) const;
  const Blend& blend(const Sides& sides, int side) const { return sides.is_linear[side % 2] ? linear_ : quadratic_; }

  /// visit(std::integral_constant<int, number of points>): loops of a known length are fast.
  template <class Visit>
  static void with_size(const Rule& rule, const Visit& visit);
  const Rule& rule(int elem) const { return elem_sides_[elem] < 0 ? corners_ : curved_rule_; }

  const RelaxProblem& problem_;
  const SampledLoops loops_;
  const Rule corners_{2}, curved_rule_{points};
  std::array<double, points> along_{};                      ///< of the points of a side, in [0, 1]
  std::array<std::array<double, points>, points> slope_{};  ///< row: of the derivatives at a point
  Blend quadratic_, linear_;
  std::vector<Vec2> start_, position_, tangent_, bend_;  ///< by vertex
  std::vector<double> slide_gradient_;                   ///< by vertex, from the points between vertices
  std::vector<CurvedSide> sides_;
  std::vector<int> elem_sides_;  ///< into curved_, -1: bilinear
  std::vector<Sides> curved_;
  std::vector<bool> is_free_;
  std::vector<Vec2> inverse_size_;                       ///< along s and t, where the energy was computed last
  std::vector<Vec2> log_size_gradients_;                 ///< by element; empty: none
  std::vector<Vec2> first_inverse_size_, first_middle_;  ///< where they were set, if they grow
};

}  // namespace quadrille::refine
