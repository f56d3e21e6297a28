#pragma once
// The search for zeros in all elements: cells are halved until each is proved empty or proved to hold at most one.

#include <array>
#include <vector>

#include "zeros/cell.hpp"
#include "zeros/edge_jumps.hpp"
#include "zeros/enclosure.hpp"

namespace quadrille::zeros {

/// A disc in which the search does not look: what happens there belongs to a corner (guide/valence).
struct Disc {
  Vec2 centre;
  double radius = 0;
};

/// A zero of the polynomial of `elem`. With jumps between elements it may lie beyond the element's edge.
struct FoundZero {
  int elem = 0;
  Vec2 xi, x;
  int index = 0;               ///< the sign of det(dv/dx)
  double cell_radius = 0;      ///< of the cell in which it was found
  double shift = 0;            ///< how far rounding and jumps may move it: |J^-1| times the value's own noise
  std::array<Vec2, 3> cell{};  ///< that cell's vertices in the plane
};

/// A cell that could be neither excluded nor isolated: |v| in it is below the noise, or below the jump to a neighbour.
struct OpenCell {
  int elem = 0;
  Vec2 centre;
  double radius = 0;
  std::array<Vec2, 3> cell{};
};

struct SearchCounts {
  long long examined = 0, excluded = 0, isolated = 0, ignored = 0;
  int greatest_depth = 0;  ///< of halvings of an element
};

/// |v| below which nothing can be told about a field that was solved to round-off.
inline constexpr double field_noise = 1e-10;

class ZeroSearch {
 public:
  /// Cells in which |v| stays below `noise` are not halved further.
  ZeroSearch(const field::FieldEvaluator& evaluator, std::vector<Disc> ignored, double noise = field_noise);

  /// Searches one element. Stops early, with an open cell, when the element needs more cells than zeros ever do.
  void search(int elem);

  const std::vector<FoundZero>& zeros() const { return zeros_; }
  const std::vector<OpenCell>& open_cells() const { return open_; }
  /// True when there is no point in going on: some element needed too many cells, or very many cells are open.
  bool is_hopeless() const { return budget_ == 0 || open_.size() > 4000; }
  const SearchCounts& counts() const { return counts_; }

 private:
  void visit(const Cell& cell, int depth);
  void isolate(const Cell& cell, const Mat2& inverse_jacobian, double contraction);
  bool is_ignored() const;
  double margin(const Cell& cell) const;

  const field::FieldEvaluator* evaluator_;
  std::vector<Disc> ignored_;
  double noise_;
  std::vector<Jumps> jumps_;
  std::vector<std::array<Cell, 2>> halves_;  ///< by depth: storage of the recursion
  Enclosure enclosure_;
  long long budget_ = 1;  ///< cells left for this element
  std::vector<FoundZero> zeros_;
  std::vector<OpenCell> open_;
  SearchCounts counts_;
};

}  // namespace quadrille::zeros
