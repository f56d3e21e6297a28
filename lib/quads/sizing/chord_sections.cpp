#include "sizing/chord_sections.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "mesh/transfinite.hpp"

namespace quadrille::sizing {
namespace {

/// The size may change by this fraction between two lines through a block.
constexpr double line_resolution = 0.5;
constexpr int max_lines = 63;
/// Number of lines that are sampled to determine the necessary number of lines.
constexpr int trial_lines = 7;
/// Blocks with so few intervals between lines, by the sizes on their arcs and the growth of sizes, need no trial.
constexpr int certain_intervals = 3;

double power6(double x) { return x * x * x * x * x * x; }

/// The mean, the greatest value and the sums they result from.
struct Sum {
  double weighted_log = 0, weight = 0, greatest = 0;

  void add(double length, double size, double greatest_size, double section_weight) {
    const double density = length / size, w = section_weight * length * power6(greatest_size / size);
    weighted_log += w * std::log(density);
    weight += w;
    greatest = std::max(greatest, density);
  }
};

}  // namespace

std::vector<std::vector<ChordBlock>> chord_blocks(const MeasuredLayout& measured) {
  const BlockLayout& layout = measured.blocks();
  std::vector<std::vector<ChordBlock>> blocks(measured.chords().size());
  for (int block = 0; block < layout.num_blocks(); ++block)
    for (const int side : {0, 1})
      blocks[measured.chord_of(layout.block2arcs[block][side].arc)].push_back({block, side});
  return blocks;
}

ChordSections::ChordSections(const MeasuredLayout& measured, const mesh::Chord& chord,
                             const std::vector<ChordBlock>& blocks, const SizeField& sizes)
    : measured_(measured), chord_(chord), sizes_(sizes) {
  std::unordered_map<int, int> arc2position;
  for (std::size_t i = 0; i < chord.arcs.size(); ++i) arc2position[chord.arcs[i]] = static_cast<int>(i);
  const std::vector<ArcTrial> trials = sizes.is_uniform() ? std::vector<ArcTrial>{} : arc_trials();
  for (const ChordBlock& b : blocks) {
    std::array<HalfEdge, 4> sides = measured.blocks().block2arcs[b.block];
    std::rotate(sides.begin(), sides.begin() + b.side, sides.end());
    add_block(sides, {arc2position.at(sides[0].arc), arc2position.at(sides[2].arc)}, measured.region_of_block(b.block),
              trials);
  }
}

void ChordSections::add_block(const std::array<HalfEdge, 4>& sides, const std::array<int, 2>& ends, int region,
                              const std::vector<ArcTrial>& trials) {
  Block block;
  block.region = region;
  block.a = ends[0], block.b = ends[1];
  block.is_against = chord_.backwards[block.a] != sides[0].is_backwards;
  if (!sizes_.is_uniform()) {
    for (int k = 0; k < 4; ++k)
      block.corners[k] = measured_.chain(sides[k].arc).position(sides[k].is_backwards ? 1.0 : 0.0);
    add_lines(block, sides, num_lines(block, sides, trials));
  }
  blocks_.push_back(std::move(block));
}

void ChordSections::add_lines(Block& block, const std::array<HalfEdge, 4>& sides, int lines) const {
  const auto on_side = [&](HalfEdge directed, double t) {
    return measured_.chain(directed.arc).position(directed.is_backwards ? 1 - t : t);
  };
  block.left.clear(), block.right.clear();
  for (int k = 1; k <= lines; ++k) {
    const double t = static_cast<double>(k) / (lines + 1);
    block.right.push_back(on_side(sides[1], t));
    block.left.push_back(on_side(sides[3], 1 - t));
  }
}

std::vector<ChordSections::ArcTrial> ChordSections::arc_trials() const {
  std::vector<ArcTrial> trials(chord_.arcs.size());
  for (std::size_t k = 0; k < trial_lines + 2; ++k) {
    const std::vector<ArcPoint> at = arc_points(static_cast<double>(k) / (trial_lines + 1));
    for (std::size_t i = 0; i < at.size(); ++i) {
      trials[i].points.push_back(at[i]);
      trials[i].least = std::min(trials[i].least, sizes_.at(at[i].position, region_of(i)));
    }
  }
  return trials;
}

int ChordSections::num_lines(Block& block, const std::array<HalfEdge, 4>& sides,
                             const std::vector<ArcTrial>& trials) const {
  const double width = std::max(measured_.chain(sides[1].arc).length(), measured_.chain(sides[3].arc).length());
  const double change = width * sizes_.slope();
  const double on_arcs = std::min(trials[block.a].least, trials[block.b].least);
  // No point is farther from both arcs than half the width.
  const double bound = on_arcs - change / 2;
  const bool is_certain = change <= certain_intervals * line_resolution * bound;
  if (!is_certain) add_lines(block, sides, trial_lines);
  const double least = is_certain ? bound : std::min(on_arcs, least_on_lines(block, trials));
  return static_cast<int>(std::min<double>(max_lines, std::ceil(change / (line_resolution * least)) - 1));
}

double ChordSections::least_on_lines(const Block& block, const std::vector<ArcTrial>& trials) const {
  double least = sizes_.greatest();
  for (std::size_t k = 0; k < trials[block.a].points.size(); ++k)
    for (std::size_t line = 0; line < block.left.size(); ++line)
      least = std::min(
          least, sizes_.at(position(block, trials[block.a].points[k], trials[block.b].points[k], line), block.region));
  return least;
}

std::vector<ChordSections::ArcPoint> ChordSections::arc_points(double u) const {
  std::vector<ArcPoint> result;
  for (std::size_t i = 0; i < chord_.arcs.size(); ++i) {
    const double fraction = measured_.arc_fraction(chord_, static_cast<int>(i), u);
    result.push_back({chain(static_cast<int>(i)).position(fraction), chord_.backwards[i] ? 1 - fraction : fraction});
  }
  return result;
}

Vec2 ChordSections::position(const Block& block, const ArcPoint& a, const ArcPoint& b, std::size_t line) const {
  const double t = static_cast<double>(line + 1) / static_cast<double>(block.left.size() + 1);
  const double along = (1 - t) * a.along + t * b.along, s = block.is_against ? 1 - along : along;
  return mesh::blend_sides({a.position, block.right[line], b.position, block.left[line]}, block.corners, s, t);
}

ElementDensity ChordSections::at(double u) const {
  const double greatest = sizes_.greatest();
  Sum sum;
  const std::vector<ArcPoint> at = sizes_.is_uniform() ? std::vector<ArcPoint>(chord_.arcs.size()) : arc_points(u);
  for (std::size_t i = 0; i < at.size(); ++i)
    sum.add(chain(static_cast<int>(i)).length(), sizes_.at(at[i].position, region_of(i)), greatest, 1);
  for (const Block& block : blocks_) {
    const double lines = static_cast<double>(block.left.size()) + 1;
    for (std::size_t line = 0; line < block.left.size(); ++line) {
      const double t = static_cast<double>(line + 1) / lines;
      const double length = (1 - t) * chain(block.a).length() + t * chain(block.b).length();
      sum.add(length, sizes_.at(position(block, at[block.a], at[block.b], line), block.region), greatest, 1 / lines);
    }
  }
  return {std::exp(sum.weighted_log / sum.weight), sum.greatest};
}

}  // namespace quadrille::sizing
