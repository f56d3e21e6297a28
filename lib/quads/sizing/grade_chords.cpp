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
/// The prescribed size may change by this fraction between two samples.
constexpr double sample_resolution = 0.25;
constexpr int first_samples = 8;
constexpr double least_step = 1e-6;

/// Samples of the prescribed element length in u along one chord, as many as its changes need.
class LengthSamples {
 public:
  LengthSamples(const ChordSections& sections, const SizeField& sizes, SizeRule rule)
      : sections_(sections), slope_(sizes.slope()), rule_(rule) {
    ElementDensity low = sections.at(0);
    add(0, low);
    for (int k = 1; k <= first_samples && !sizes.is_uniform(); ++k) {
      const double u0 = (k - 1.0) / first_samples, u1 = static_cast<double>(k) / first_samples;
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
    if (change <= sample_resolution || u1 - u0 <= least_step) return;
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

double whole_count(double count, SizeRule rule) {
  if (rule == SizeRule::at_most) return std::max(1.0, std::ceil(count * (1 - equal_tol)));
  // ln n and ln(n + 1) are equally far from ln sqrt(n (n + 1)).
  const double n = std::floor(count);
  return std::max(1.0, count >= (1 - equal_tol) * std::sqrt(n * (n + 1)) ? n + 1 : n);
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
