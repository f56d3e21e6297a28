#pragma once
// Arc lengths of curves, and a chain of curve pieces as ONE curve, parametrised by the fraction s in [0, 1] of its
// total
// arc length: a side of a block.

#include <array>
#include <cstddef>
#include <optional>
#include <unordered_map>
#include <vector>

#include "model/arc_graph.hpp"
#include "model/cad_face.hpp"

namespace quadrille::curve {

class ArcLength {
 public:
  /// Gauss-Legendre on sub-intervals that are halved until two rules agree to 1e-14 of the length. Stores a pointer to
  /// `curve`, which must outlive the object.
  explicit ArcLength(const Nurbs& curve);

  double total() const { return lengths_.back(); }
  /// Length from the beginning of the curve to t.
  double at(double t) const;
  /// Length from t0 to t1, negative if t1 < t0.
  double between(double t0, double t1) const { return at(t1) - at(t0); }
  /// The parameter at `length` from the beginning (clamped to the curve), by Newton's method from the table.
  double parameter(double length) const;

 private:
  static constexpr int most_terms = 8;
  /// The derivative on one knot span of a polynomial curve of degree 8 or less, or a rational one of degree 2, as the
  /// quotient of d[0] + d[1] u + d[2] u^2 + ..., where u = t - middle, and the square of w[0] + w[1] u + w[2] u^2: a
  /// tenth of the cost of evaluating the curve.
  struct Hodograph {
    double middle = 0;
    std::array<Vec2, most_terms> d;
    std::array<double, 3> w = {1, 0, 0};
  };

  /// `a`, `b`: the ends of the span.
  static Hodograph hodograph(const Nurbs& curve, bool is_polynomial, double a, double b);
  void add(double parameter, double length, std::size_t span);
  /// `t` is a parameter in span number `span`; only spans that are not empty are counted.
  double speed(std::size_t span, double t) const;
  /// The length from a to b in a span by n points.
  template <int n>
  double gauss(std::size_t span, double a, double b) const;
  /// Length from parameters_[i] to t, which lies in interval i.
  double inside(std::size_t i, double t) const;
  /// Cubic guess of the parameter at `length` in interval i, from lengths and speeds at its ends.
  double guess(std::size_t i, double length) const;

  const Nurbs* curve_;
  std::vector<Hodograph> hodographs_;  // one per span; empty for other curves
  int num_terms_ = 3;                  // of their d
  std::vector<double> parameters_, lengths_, speeds_;
  std::vector<std::size_t> spans_;  // span of the interval that ends at each parameter
  bool is_polyline_ = false, is_rational_ = false;
};

// A chain of curve pieces as ONE curve, parametrised by the fraction s in [0, 1] of its total arc length: a side of a
// block.

struct ChainPoint {
  Vec2 position;
  Vec2 tangent;   ///< unit, in the direction of rising s
  int piece = 0;  ///< index into the chain's pieces
  double t = 0;   ///< parameter on that piece's curve
};

/// Arc-length tables and breaks of many curves, made on first use and shared by all chains of one layout.
class CurveTable {
 public:
  /// `face` and `splines` must outlive the table. Curve ids as in SeparatrixGraph.
  CurveTable(const CadFace& face, const std::vector<Nurbs>& splines);
  const Nurbs& curve(int id) const;
  const ArcLength& arc_length(int id) const;
  /// Its smoothness_breaks (curve/nurbs).
  const std::vector<double>& breaks(int id) const;
  double diameter() const { return face_->diameter; }
  bool is_cad_curve(int id) const { return id < face_->num_curves(); }

 private:
  const CadFace* face_;
  const std::vector<Nurbs>* splines_;
  // Of the curves asked for: most tables are about a few.
  mutable std::unordered_map<int, ArcLength> tables_;
  mutable std::unordered_map<int, std::vector<double>> breaks_;
};

class Chain {
 public:
  /// `table` must outlive the chain. Each piece starts at the end of the one before; t0 > t1: traversed backwards.
  Chain(const CurveTable& table, std::vector<ArcPiece> pieces);

  double length() const { return ends_.back(); }
  /// The point at fraction s of the length, s in [0, 1] (clamped).
  ChainPoint at(double s) const;
  /// at(s).position, in less time.
  Vec2 position(double s) const;
  /// Fractions of the joints between pieces, ascending, without 0 and 1.
  std::vector<double> joint_fractions() const;
  /// Fractions that no element edge may straddle: joints between pieces and smoothness_breaks inside CAD pieces. The
  /// seam of a smooth closed curve is not a break; its position is arbitrary. Breaks within 1e-6 diameters of an end of
  /// the chain count as that end, except the far end of a curve that is no longer than that, which may have a name.
  const std::vector<double>& break_fractions() const;
  const std::vector<ArcPiece>& pieces() const { return pieces_; }

 private:
  struct Place {
    size_t piece = 0;
    double t = 0;
  };
  Place place(double s) const;
  /// Whether pieces i and i + 1 are joined at the seam of one smooth closed curve.
  bool is_smooth_seam(size_t i) const;
  bool is_whole_curve(size_t i) const;
  /// Whether a break counts as an end of the chain.
  bool is_at_end(double fraction) const;
  std::vector<double> find_break_fractions() const;

  const CurveTable* table_;
  std::vector<ArcPiece> pieces_;
  std::vector<double> ends_;                                    ///< length up to the end of each piece
  std::vector<double> starts_;                                  ///< length on its curve at which each piece begins
  std::vector<const ArcLength*> arc_lengths_;                   ///< of the curve of each piece
  mutable std::optional<std::vector<double>> break_fractions_;  ///< once they were asked for
};

}  // namespace quadrille::curve
