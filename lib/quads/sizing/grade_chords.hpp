#pragma once
// One count and one grading for each chord, from the prescribed sizes.
//
// A chord is sampled along its sections: its arcs, and in each block between two of them as many parallel lines as the
// variation of the size field needs. A section of length L where the prescribed edge length is h needs L / h elements
// per unit of u. All sections have one density rho(u), whose deviation is measured by
//
//   sum over sections of weight L (greatest / h)^6 (ln(L / h) - ln rho)^2.
//
// The minimum is at the weighted mean of ln(L / h). Arcs have weight 1, the lines of one block together at most 1: a
// size that is prescribed along a boundary must not be averaged away by the blocks behind it. The power favours small
// local sizes: a section that needs edges half as long as the others weighs as much as 64 of them. Where the size is
// uniform it has no effect. Of a metric M, h is the length along the section: over a chord rho then integrates to
// sqrt(t M t), t the tangent.

#include <array>
#include <limits>
#include <vector>

#include "base/enum_names.hpp"
#include "sizing/grading.hpp"
#include "sizing/measured_layout.hpp"
#include "sizing/size_field.hpp"

namespace quadrille::sizing {

/// The rule for the single count of a chord whose arcs have different prescribed lengths.
enum class SizeRule {
  nearest,  ///< least deviation (ChordSections)
  at_most,  ///< no edge is longer than prescribed
  error     ///< first nearest, with elements shorter only where the boundary needs it, then least error
            ///< of a smooth solution (refine/lower_error)
};
constexpr auto enum_names(SizeRule) { return std::to_array({"nearest", "at-most", "error"}); }

/// A prescribed count.
struct ChordCount {
  int chord = 0, count = 1;
};

struct ChordPlan {
  Grading grading;
  int count = 1;
  double slope = 0;            ///< |d eta / du| of the grading is at most that (sizing/grading)
  bool is_bound = false;       ///< no edge may be longer (SizeRule::at_most)
  bool is_prescribed = false;  ///< the count is a prescribed one
  bool is_by_user = true;      ///< if it is; others are raised where no symmetric division has them

  bool operator==(const ChordPlan&) const = default;
};

/// One plan per chord. Counts are rounded to the integer with the least deviation of the logarithm (at_most: upwards);
/// of two equally good ones (within 1e-6) the greater, so that mirror images agree. Throws UsageError for a prescribed
/// chord that does not exist.
std::vector<ChordPlan> grade_chords(const MeasuredLayout& measured, const SizeField& sizes, SizeRule rule,
                                    const std::vector<ChordCount>& prescribed);

/// The rounded count, at least 1, for a real number > 0.
double whole_count(double count, SizeRule rule);

struct ElementDensity {
  double nearest = 0;   ///< rho that deviates least, elements per unit of u
  double greatest = 0;  ///< rho that no section exceeds: no edge is longer than prescribed
};

/// A block that the chord runs through, with its sides `side` and side + 2 among the chord's arcs.
struct ChordBlock {
  int block = 0, side = 0;
};

/// The blocks of each chord.
std::vector<std::vector<ChordBlock>> chord_blocks(const MeasuredLayout& measured);

/// The density of elements that the size field prescribes along a chord.
class ChordSections {
 public:
  /// Everything must outlive the sections.
  ChordSections(const MeasuredLayout& measured, const mesh::Chord& chord, const std::vector<ChordBlock>& blocks,
                const SizeField& sizes);

  ElementDensity at(double u) const;

 private:
  /// The point of one arc of the chord at a parameter.
  struct ArcPoint {
    Vec2 position;
    Vec2 tangent;      ///< unit, in the chord's direction; with a metric only
    double along = 0;  ///< fraction of the arc's length in the chord's direction
  };
  /// A block with its own (s, t): s along side a, t from a to b, positions in the chord; the lines inside are at
  /// t = k / (lines + 1).
  struct Block {
    int a = 0, b = 0;
    int region = -1;
    bool is_against = false;  ///< s runs against the chord
    std::array<Vec2, 4> corners;
    std::vector<Vec2> left, right;  ///< points on the sides s = 0 and s = 1, one for each line
  };
  const curve::Chain& chain(int arc) const { return measured_.chain(chord_.arcs[arc]); }
  int region_of(std::size_t arc) const { return measured_.region_of(chord_.arcs[arc]); }
  /// Points of one arc, at equal distances in u, and the least size there.
  struct ArcTrial {
    std::vector<ArcPoint> points;
    double least = std::numeric_limits<double>::infinity();
  };
  std::vector<ArcTrial> arc_trials() const;
  void add_block(const std::array<HalfEdge, 4>& sides, int region, const std::vector<ArcTrial>& trials);
  void add_lines(Block& block, const std::array<HalfEdge, 4>& sides, int lines) const;
  /// As many as the variation of the size across the block needs. May add lines on trial.
  int num_lines(Block& block, const std::array<HalfEdge, 4>& sides, const std::vector<ArcTrial>& trials) const;
  double least_on_lines(const Block& block, const std::vector<ArcTrial>& trials) const;
  std::vector<ArcPoint> arc_points(double u) const;
  Vec2 position(const Block& block, const ArcPoint& a, const ArcPoint& b, std::size_t line) const;

  const MeasuredLayout& measured_;
  const mesh::Chord& chord_;
  const SizeField& sizes_;
  std::vector<Block> blocks_;
};

}  // namespace quadrille::sizing
