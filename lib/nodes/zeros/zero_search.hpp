#pragma once
// The search for zeros in all elements: cells are bisected until each is proved empty or proved to contain at most one.
//
// A discontinuous field (hybridised DG) has two values on an edge, and a zero near the edge may appear on both sides or
// on neither. Zeros are therefore those of a continuous field w that stays within the local jump of the one-sided
// values; any such w will do: if J is regular and varies by less than the jump allows, all of them have the same zeros,
// each within |J^-1 jump| of the one-sided one. Hence the search of an element is widened by the jump, and zeros of two
// elements that are nearer than their shifts are one.

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "field/evaluate.hpp"
#include "zeros/cell.hpp"
#include "zeros/enclosure.hpp"
#include "zeros/far_liftings.hpp"

namespace quadrille::zeros {

/// The jumps of one element.
struct Jumps {
  std::array<double, 3> edge{};    ///< across local edge k, 0 on the boundary
  std::array<double, 3> vertex{};  ///< at local vertex k: the sum over half the edges that meet there
};

/// The jumps of each element. The jump of an edge is twice the greatest at P + 2 points. Empty for continuous fields
/// (method "cg").
std::vector<Jumps> edge_jumps(const field::FieldEvaluator& evaluator);

/// A zero of the polynomial of `elem`. If the field jumps between elements it may lie beyond the element's edge.
struct FoundZero {
  int elem = 0;
  Vec2 xi, x;
  int index = 0;               ///< the sign of det(dv/dx)
  double cell_radius = 0;      ///< of the cell in which it was found
  double shift = 0;            ///< bound of its displacement by rounding and jumps: |J^-1| times the noise of the value
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
  int greatest_depth = 0;  ///< bisections of an element
};

/// |v| below this is noise in a field that was solved to round-off.
inline constexpr double field_noise = 1e-10;

/// What a search has found so far.
struct SearchResult {
  std::vector<FoundZero> zeros;
  std::vector<OpenCell> open_cells;
  SearchCounts counts;
};

/// A cell of a search that is over: the first half of a bisected one follows, the second follows that half's cells.
struct KnownCell {
  double least = 0;   ///< a lower bound of |v|; 0 if there may be a zero
  double most = 0;    ///< the greatest such bound of its parts
  int num_cells = 1;  ///< with its parts
};

/// The cells of one element, in the order of the search; empty if nothing is known.
using KnownCells = std::vector<KnownCell>;

class ZeroSearch {
 public:
  /// Cells in which |v| stays below `noise` are not bisected further. Zeros in `ignored` belong to a corner
  /// (guide/valence). The field must stay as it is, or renew() follow.
  ZeroSearch(const field::FieldEvaluator& evaluator, std::vector<Disc> ignored, double noise = field_noise);

  /// Searches one element. Stops early, with an open cell, if the element needs more cells than zeros ever require.
  void search(int elem);
  /// The same with what is known from a field that differs by at most `change` on the element: only cells in which that
  /// may lead to a zero are examined. `known` becomes what is known of this field.
  void search(int elem, double change, KnownCells& known);
  /// Adds the zeros of an element to which Newton's method leads from its middle, from places near its vertices and
  /// from `before`, where zeros were. They are zeros, but others may exist: it costs a few values of the field.
  void follow(int elem, const std::vector<FoundZero>& before);
  /// Begins anew, because the field has changed.
  void renew();

  /// Adds what was found in an element before.
  void add(const SearchResult& found);

  const std::vector<FoundZero>& zeros() const { return found_.zeros; }
  const std::vector<OpenCell>& open_cells() const { return found_.open_cells; }
  /// Whether the search cannot be completed: an element needed too many cells, or very many cells are open.
  bool is_budget_exhausted() const { return budget_ == 0 || found_.open_cells.size() > 4000; }
  const SearchCounts& counts() const { return found_.counts; }
  /// What was found so far; the search begins anew.
  SearchResult take() { return std::exchange(found_, {}); }

 private:
  bool keep_known(std::size_t at);
  void visit(const Cell& cell, int depth, std::size_t at);
  double examine(const Cell& cell, int depth, bool& is_decided);
  void isolate(const Cell& cell, const Mat2& inverse_jacobian, double contraction);
  bool is_ignored() const;
  double margin(const Cell& cell) const;

  const field::FieldEvaluator* evaluator_;
  std::vector<Disc> ignored_;
  double noise_;
  std::vector<Jumps> jumps_;
  FarLiftings liftings_;
  std::vector<std::array<Cell, 2>> halves_;  ///< by depth: storage of the recursion
  Enclosure enclosure_;
  long long budget_ = 1;  ///< cells left for this element
  KnownCells before_, now_;
  double change_ = 0;  ///< since before_
  SearchResult found_;
};

/// Throws ComputeError with the position if the search cannot be completed.
void require_decided(const ZeroSearch& search, const CadFace& face);

/// Removes duplicates: a zero on an edge or vertex is found in every adjacent element. Two zeros of equal index are one
/// if they are nearer to each other than their shifts allow: near each other and with J of one sign the field is
/// injective, so that two zeros are impossible. Of each group the zero is kept that lies inside its own element, and of
/// the lowest such element; if none does (the zero falls into the gap between elements) the first that still lies in
/// the mesh. A zero of an element's polynomial that lies beyond the mesh is removed. `zeros` in the order of a search
/// of the elements in ascending order. Quadratic in their number.
std::vector<FoundZero> distinct_zeros(const field::FieldEvaluator& evaluator, const std::vector<FoundZero>& zeros);

/// The open cells without those that lie no farther from a zero than rounding may shift it: next to a zero with small J
/// the smallest cells cannot be isolated, and they contain that zero.
std::vector<OpenCell> cells_without_zero(const std::vector<OpenCell>& open_cells, const std::vector<FoundZero>& zeros);

}  // namespace quadrille::zeros
