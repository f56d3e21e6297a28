#pragma once
// What the sizes ask of a chord at one of its parameters.
//
// A chord is looked at along its sections: its arcs, and in each block between two of them as many lines side by side
// as the size field needs to be seen. A section of length L where the wanted edge length is h asks for L / h elements
// per unit of u. All sections share one density rho(u), whose deviation is measured by
//
//   sum over sections of weight L (greatest / h)^6 (ln(L / h) - ln rho)^2.
//
// Its least is at the weighted mean of ln(L / h). Arcs have the weight 1, the lines of one block together at most 1: a
// size that is asked for along a boundary must not drown in the blocks behind it. The power lets a size win that is
// asked for in one place: where one section wants edges half as long as the others it weighs as much as 64 of them.
// Where all want the same size it has no effect.

#include <array>
#include <vector>

#include "sizing/measured_layout.hpp"
#include "sizing/size_field.hpp"

namespace quadrille::sizing {

struct ElementDensity {
  double nearest = 0;   ///< rho that deviates least, elements per unit of u
  double greatest = 0;  ///< rho that no section exceeds: all edges at most as long as wanted
};

/// A block that the chord runs through, with its sides `side` and side + 2 among the chord's arcs.
struct ChordBlock {
  int block = 0, side = 0;
};

/// The blocks of each chord.
std::vector<std::vector<ChordBlock>> chord_blocks(const MeasuredLayout& measured);

class ChordSections {
 public:
  /// Everything must outlive the sections.
  ChordSections(const MeasuredLayout& measured, const mesh::Chord& chord, const std::vector<ChordBlock>& blocks,
                const SizeField& sizes);

  ElementDensity at(double u) const;

 private:
  /// A chord's arc at one parameter.
  struct Place {
    Vec2 position;
    double along = 0;  ///< share of the arc's length in the chord's direction
  };
  /// A block with its own (s, t): s along side a, t from a to b, places in the chord; the lines inside are at
  /// t = k / (lines + 1).
  struct Block {
    int a = 0, b = 0;
    bool is_against = false;  ///< s runs against the chord
    std::array<Vec2, 4> corners;
    std::vector<Vec2> left, right;  ///< points on the sides s = 0 and s = 1, one for each line
  };
  const curve::Chain& chain(int arc) const { return measured_.chain(chord_.arcs[arc]); }
  void add_block(const std::array<HalfEdge, 4>& sides, const std::array<int, 2>& ends);
  void add_lines(Block& block, const std::array<HalfEdge, 4>& sides, int lines) const;
  double least_size(const Block& block) const;
  std::vector<Place> places(double u) const;
  Vec2 position(const Block& block, const std::vector<Place>& places, std::size_t line) const;

  const MeasuredLayout& measured_;
  const mesh::Chord& chord_;
  const SizeField& sizes_;
  std::vector<Block> blocks_;
};

}  // namespace quadrille::sizing
