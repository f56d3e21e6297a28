#include "sizing/grade_chords.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "sizing/chord_sections.hpp"

namespace quadrille::sizing {
namespace {

/// Counts that differ by less, relatively, count as equal.
constexpr double equal_tol = 1e-6;
/// The wanted size may change by this share between two looks at it.
constexpr double look_resolution = 0.25;
constexpr int first_looks = 8;
constexpr double least_step = 1e-6;

/// The wanted element length in u along one chord, looked at as often as it changes.
class ChordLook {
 public:
  ChordLook(const ChordSections& sections, const SizeField& sizes, SizeRule rule)
      : sections_(sections), slope_(sizes.slope()), rule_(rule) {
    WantedDensity low = sections.at(0);
    add(0, low);
    for (int k = 1; k <= first_looks && !sizes.is_uniform(); ++k) {
      const double u0 = (k - 1.0) / first_looks, u1 = static_cast<double>(k) / first_looks;
      const WantedDensity high = sections.at(u1);
      look_between(u0, low, u1, high);
      add(u1, high);
      low = high;
    }
  }

  Grading grading() const {
    if (u_.size() == 1) return Grading(1 / eta_[0]);
    return {u_, limited(u_, eta_, slope_)};
  }

 private:
  void add(double u, const WantedDensity& density) {
    u_.push_back(u);
    eta_.push_back(1 / (rule_ == SizeRule::at_most ? density.greatest : density.nearest));
  }

  void look_between(double u0, const WantedDensity& low, double u1, const WantedDensity& high) {
    // Where a section's density is rho, its size changes by the share slope rho step over a step.
    const double change = slope_ * std::max(low.greatest, high.greatest) * (u1 - u0);
    if (change <= look_resolution || u1 - u0 <= least_step) return;
    const double u = (u0 + u1) / 2;
    const WantedDensity middle = sections_.at(u);
    look_between(u0, low, u, middle);
    add(u, middle);
    look_between(u, middle, u1, high);
  }

  const ChordSections& sections_;
  double slope_;
  SizeRule rule_;
  std::vector<double> u_, eta_;
};

void prescribe(const std::vector<ChordCount>& counts, std::vector<ChordPlan>& plans) {
  for (const ChordCount& c : counts) {
    if (c.chord < 0 || c.chord >= static_cast<int>(plans.size()))
      throw UsageError(fmt::format("no chord has the number {}: they go from 0 to {}", c.chord, plans.size() - 1));
    if (c.count < 1) throw UsageError(fmt::format("chord {} cannot have {} elements", c.chord, c.count));
    plans[c.chord].count = c.count;
    plans[c.chord].is_prescribed = true;
  }
}

}  // namespace

double whole_count(double wanted, SizeRule rule) {
  if (rule == SizeRule::at_most) return std::max(1.0, std::ceil(wanted * (1 - equal_tol)));
  // Of n and n + 1 the logarithms are equally far from that of sqrt(n (n + 1)).
  const double n = std::floor(wanted);
  return std::max(1.0, wanted >= (1 - equal_tol) * std::sqrt(n * (n + 1)) ? n + 1 : n);
}

std::vector<ChordPlan> grade_chords(const BlockLayout& layout, const std::vector<mesh::Chord>& chords,
                                    const std::vector<curve::Chain>& chains,
                                    const std::vector<ArcParameter>& parameters, const SizeField& sizes, SizeRule rule,
                                    const std::vector<ChordCount>& prescribed) {
  const std::vector<std::vector<ChordBlock>> blocks =
      chord_blocks(layout, mesh::arc_chords(layout.block2arcs, static_cast<int>(chains.size())));
  std::vector<ChordPlan> plans;
  for (std::size_t c = 0; c < chords.size(); ++c) {
    const ChordSections sections(layout, chords[c], blocks[c], chains, parameters, sizes);
    ChordPlan plan{ChordLook(sections, sizes, rule).grading(), 1, sizes.slope(), rule == SizeRule::at_most};
    plan.count = static_cast<int>(std::min(1e9, whole_count(plan.grading.count(), rule)));
    plans.push_back(std::move(plan));
  }
  prescribe(prescribed, plans);
  return plans;
}

}  // namespace quadrille::sizing
