#pragma once
// The search for zeros in all elements: cells are halved until each is proved empty or proved to hold at most one.

#include <vector>

#include "guide/cell.hpp"
#include "guide/enclosure.hpp"

namespace quadrille {

/// A disc in which the search does not look: what happens there belongs to a corner (guide/valence).
struct Disc {
  Vec2 centre;
  double radius = 0;
};

struct FoundZero {
  int elem = 0;
  Vec2 xi, x;
  double cell_radius = 0;  ///< of the cell in which it was found
};

/// A cell that could be neither excluded nor isolated.
struct OpenCell {
  int elem = 0;
  Vec2 centre;
  double radius = 0;
};

struct SearchCounts {
  long long examined = 0, excluded = 0, isolated = 0, ignored = 0;
  int greatest_depth = 0;  ///< of halvings of an element
};

/// |v| below which nothing can be told about a field that was solved to round-off.
inline constexpr double field_noise = 1e-10;

class ZeroSearch {
 public:
  ZeroSearch(const FieldEvaluator& evaluator, std::vector<Disc> ignored);

  /// Searches one element. Stops early, with an open cell, when the element needs more cells than zeros ever do.
  void search(int elem);

  const std::vector<FoundZero>& zeros() const { return zeros_; }
  const std::vector<OpenCell>& open_cells() const { return open_; }
  /// True when there is no point in going on: some element needed too many cells, or very many cells are open.
  bool is_hopeless() const { return budget_ == 0 || open_.size() > 1000; }
  const SearchCounts& counts() const { return counts_; }

 private:
  void visit(const Cell& cell, int depth);
  bool is_ignored() const;

  const FieldEvaluator* evaluator_;
  std::vector<Disc> ignored_;
  std::vector<std::array<Cell, 2>> halves_;  ///< by depth: storage of the recursion
  Enclosure enclosure_;
  long long budget_ = 1;  ///< cells left for this element
  std::vector<FoundZero> zeros_;
  std::vector<OpenCell> open_;
  SearchCounts counts_;
};

}  // namespace quadrille
