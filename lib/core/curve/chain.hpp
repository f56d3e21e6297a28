#pragma once
// A chain of curve pieces as ONE curve, parametrised by the fraction s in [0, 1] of its total arc length: a side of a
// block.

#include <unordered_map>
#include <vector>

#include "curve/arc_length.hpp"
#include "model/arc_graph.hpp"

namespace quadrille::curve {

struct ChainPoint {
  Vec2 position;
  Vec2 tangent;   ///< unit, in the direction of rising s
  int piece = 0;  ///< index into the chain's pieces
  double t = 0;   ///< parameter on that piece's curve
};

/// Arc-length tables of many curves, made on first use and shared by all chains of one layout.
class CurveTable {
 public:
  /// `face` and `splines` must outlive the table. Curve ids as in SeparatrixGraph.
  CurveTable(const CadFace& face, const std::vector<Nurbs>& splines);
  const Nurbs& curve(int id) const;
  const ArcLength& arc_length(int id) const;
  double diameter() const { return face_->diameter; }
  bool is_cad_curve(int id) const { return id < face_->num_curves(); }

 private:
  const CadFace* face_;
  const std::vector<Nurbs>* splines_;
  mutable std::unordered_map<int, ArcLength> tables_;  ///< of the curves asked for: most tables are about a few
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
  std::vector<double> break_fractions() const;
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

  const CurveTable* table_;
  std::vector<ArcPiece> pieces_;
  std::vector<double> ends_;                   ///< length up to the end of each piece
  std::vector<double> starts_;                 ///< length on its curve at which each piece begins
  std::vector<const ArcLength*> arc_lengths_;  ///< of the curve of each piece
};

}  // namespace quadrille::curve
