#include "sizing/grade_chords.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/tolerance.hpp"
#include "mesh/transfinite.hpp"

namespace quadrille::sizing {
namespace {

struct SectionConstants {
  double line_resolution = 0.5;  ///< part of the size by which it may change between two lines through a block
  int max_lines = 63;
  int trial_lines = 7;  ///< that are sampled to determine the necessary number of lines
  /// Blocks with so few intervals between lines, by the sizes on their arcs and the growth of sizes, need no trial.
  int certain_intervals = 3;
  /// Of samples along a chord: the prescribed size may change by this fraction between two of them.
  double sample_resolution = 0.25;
  int first_samples = 8;
  double least_step = 1e-6;
};
constexpr SectionConstants section_constants;

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

/// Samples of the prescribed element length in u along one chord, as many as its changes need.
class LengthSamples {
 public:
  LengthSamples(const ChordSections& sections, const SizeField& sizes, SizeRule rule)
      : sections_(sections), slope_(sizes.slope()), rule_(rule) {
    ElementDensity low = sections.at(0);
    add(0, low);
    for (int k = 1; k <= section_constants.first_samples && !sizes.is_uniform(); ++k) {
      const double u0 = (k - 1.0) / section_constants.first_samples,
                   u1 = static_cast<double>(k) / section_constants.first_samples;
      const ElementDensity high = sections.at(u1);
      sample_between(u0, low, u1, high);
      add(u1, high);
      low = high;
    }
  }

  Grading grading() const {
    if (u_.size() == 1) return Grading(1 / eta_[0]);
    return {u_, limited(u_, eta_, slope_)};
  }

 private:
  void add(double u, const ElementDensity& density) {
    u_.push_back(u);
    eta_.push_back(1 / (rule_ == SizeRule::at_most ? density.greatest : density.nearest));
  }

  void sample_between(double u0, const ElementDensity& low, double u1, const ElementDensity& high) {
    // Where a section's density is rho, its size changes by the fraction slope rho step over a step.
    const double change = slope_ * std::max(low.greatest, high.greatest) * (u1 - u0);
    if (change <= section_constants.sample_resolution || u1 - u0 <= section_constants.least_step) return;
    const double u = (u0 + u1) / 2;
    const ElementDensity middle = sections_.at(u);
    sample_between(u0, low, u, middle);
    add(u, middle);
    sample_between(u, middle, u1, high);
  }

  const ChordSections& sections_;
  double slope_;
  SizeRule rule_;
  std::vector<double> u_, eta_;
};

void prescribe(const std::vector<ChordCount>& counts, std::vector<ChordPlan>& plans) {
  for (const ChordCount& c : counts) {
    if (c.chord < 0 || c.chord >= static_cast<int>(plans.size()))
      throw UsageError(
          fmt::format("--count: there is no chord {}; chords are numbered 0 to {}", c.chord, plans.size() - 1));
    if (c.count < 1)
      throw UsageError(fmt::format("--count: chord {} must have at least one element, not {}", c.chord, c.count));
    plans[c.chord].count = c.count;
    plans[c.chord].is_prescribed = true;
  }
}

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
  const std::vector<ArcTrial> trials = sizes.is_uniform() ? std::vector<ArcTrial>{} : arc_trials();
  for (const ChordBlock& b : blocks) {
    std::array<HalfEdge, 4> sides = measured.blocks().block2arcs[b.block];
    std::rotate(sides.begin(), sides.begin() + b.side, sides.end());
    add_block(sides, measured.region_of_block(b.block), trials);
  }
}

void ChordSections::add_block(const std::array<HalfEdge, 4>& sides, int region, const std::vector<ArcTrial>& trials) {
  Block block;
  block.region = region;
  block.a = measured_.position_in_chord(sides[0].arc), block.b = measured_.position_in_chord(sides[2].arc);
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
  for (std::size_t k = 0; k < section_constants.trial_lines + 2; ++k) {
    const std::vector<ArcPoint> at = arc_points(static_cast<double>(k) / (section_constants.trial_lines + 1));
    for (std::size_t i = 0; i < at.size(); ++i) {
      trials[i].points.push_back(at[i]);
      trials[i].least = std::min(trials[i].least, sizes_.directed(at[i].position, region_of(i)).least());
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
  const bool is_certain = change <= section_constants.certain_intervals * section_constants.line_resolution * bound;
  if (!is_certain) add_lines(block, sides, section_constants.trial_lines);
  const double least = is_certain ? bound : std::min(on_arcs, least_on_lines(block, trials));
  return static_cast<int>(std::min<double>(section_constants.max_lines,
                                           std::ceil(change / (section_constants.line_resolution * least)) - 1));
}

double ChordSections::least_on_lines(const Block& block, const std::vector<ArcTrial>& trials) const {
  double least = sizes_.greatest();
  for (std::size_t k = 0; k < trials[block.a].points.size(); ++k)
    for (std::size_t line = 0; line < block.left.size(); ++line)
      least = std::min(
          least,
          sizes_.directed(position(block, trials[block.a].points[k], trials[block.b].points[k], line), block.region)
              .least());
  return least;
}

std::vector<ChordSections::ArcPoint> ChordSections::arc_points(double u) const {
  std::vector<ArcPoint> result;
  for (std::size_t i = 0; i < chord_.arcs.size(); ++i) {
    const double fraction = measured_.arc_fraction(chord_, static_cast<int>(i), u);
    const bool is_backwards = chord_.backwards[i];
    ArcPoint at{{}, {}, is_backwards ? 1 - fraction : fraction};
    if (sizes_.has_metric()) {
      const curve::ChainPoint on_arc = chain(static_cast<int>(i)).at(fraction);
      at.position = on_arc.position, at.tangent = (is_backwards ? -1 : 1) * on_arc.tangent;
    } else {
      at.position = chain(static_cast<int>(i)).position(fraction);
    }
    result.push_back(at);
  }
  return result;
}

Vec2 ChordSections::position(const Block& block, const ArcPoint& a, const ArcPoint& b, std::size_t line) const {
  const double t = static_cast<double>(line + 1) / static_cast<double>(block.left.size() + 1);
  const double along = (1 - t) * a.along + t * b.along, s = block.is_against ? 1 - along : along;
  return mesh::blend_sides({a.position, block.right[line], b.position, block.left[line]}, block.corners, s, t);
}

ElementDensity ChordSections::at(double u) const {
  Sum sum;
  const std::vector<ArcPoint> at = sizes_.is_uniform() ? std::vector<ArcPoint>(chord_.arcs.size()) : arc_points(u);
  for (std::size_t i = 0; i < at.size(); ++i)
    sum.add(chain(static_cast<int>(i)).length(), sizes_.along(at[i].tangent, at[i].position, region_of(i)),
            sizes_.greatest_at(at[i].position), 1);
  for (const Block& block : blocks_) {
    const double lines = static_cast<double>(block.left.size()) + 1;
    for (std::size_t line = 0; line < block.left.size(); ++line) {
      const double t = static_cast<double>(line + 1) / lines;
      const double of_a = (1 - t) * chain(block.a).length(), of_b = t * chain(block.b).length();
      const Vec2 along = of_a * at[block.a].tangent + of_b * at[block.b].tangent;
      const Vec2 x = position(block, at[block.a], at[block.b], line);
      sum.add(of_a + of_b, sizes_.along(normalized(along), x, block.region), sizes_.greatest_at(x), 1 / lines);
    }
  }
  return {std::exp(sum.weighted_log / sum.weight), sum.greatest};
}

double whole_count(double count, SizeRule rule) {
  if (rule == SizeRule::at_most) return std::max(1.0, std::ceil(count * (1 - tolerance::tied)));
  // ln n and ln(n + 1) are equally far from ln sqrt(n (n + 1)).
  const double n = std::floor(count);
  return std::max(1.0, count >= (1 - tolerance::tied) * std::sqrt(n * (n + 1)) ? n + 1 : n);
}

std::vector<ChordPlan> grade_chords(const MeasuredLayout& measured, const SizeField& sizes, SizeRule rule,
                                    const std::vector<ChordCount>& prescribed) {
  const std::vector<std::vector<ChordBlock>> blocks = chord_blocks(measured);
  std::vector<ChordPlan> plans;
  for (std::size_t c = 0; c < blocks.size(); ++c) {
    const ChordSections sections(measured, measured.chords()[c], blocks[c], sizes);
    ChordPlan plan{LengthSamples(sections, sizes, rule).grading(), 1, sizes.slope(), rule == SizeRule::at_most};
    plan.count = static_cast<int>(std::min(1e9, whole_count(plan.grading.count(), rule)));
    plans.push_back(std::move(plan));
  }
  prescribe(prescribed, plans);
  return plans;
}

}  // namespace quadrille::sizing
