#include "sizing/curve_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "curve/symmetry_lines.hpp"
#include "model/name_rules.hpp"
#include "sizing/element_limit.hpp"

namespace quadrille::sizing {
namespace {

/// Times as many elements as without sizes along curves.
constexpr double most_refined = 2;
/// From one trial of s to the next finer one, and the halvings of that factor's logarithm.
constexpr double coarsening = 4;
constexpr int num_bisections = 3;
constexpr double wake_growth = 1.05;

/// Whether a boundary with sizes of its own is the wake, in any region.
bool is_wake(const NearSize& near) { return near.boundary.substr(0, near.boundary.find('@')) == wake_name; }

SizeOptions with_wake(const CadFace& face, SizeOptions options) {
  const std::vector<int> curves = wake_curves(face);
  if (curves.empty() || std::ranges::any_of(options.near, is_wake)) return options;
  const SizeField sizes = make_size_field(face, options);
  const GrowingSize ends = growing_size(face, curves, 0, 0);
  const double left = sizes.at(ends.end), right = sizes.at(ends.other_end), least = std::min(left, right);
  const double most = least + std::log(wake_growth) * distance(ends.end, ends.other_end);
  options.near.push_back(left <= right ? NearSize{wake_name, least, most} : NearSize{wake_name, most, least});
  return options;
}

/// Infinite if there are none.
double least_size(const std::vector<SizeSegment>& segments) {
  double least = std::numeric_limits<double>::infinity();
  for (const SizeSegment& segment : segments) least = std::min({least, segment.size_a, segment.size_b});
  return least;
}

}  // namespace

SizeOptions with_curve_sizes(const MeasuredLayout& measured, const SizeOptions& options, SizeRule rule) {
  if (options.per_curve != SizeOptions::automatic) return options;
  SizeOptions none = options;
  none.per_curve = 0;
  if (options.size > 0 || options.sources.is_table) return none;
  const CadFace& face = measured.blocks().face;
  const auto with_least = [&](double least) {
    SizeOptions finer = options;
    finer.per_curve = SizeField::default_per_curve;
    finer.least_along_curves = least;
    return finer;
  };
  if (has_far_field(face)) return with_wake(face, with_least(0));

  const auto num_elements = [&](const SizeOptions& sizes) {
    return num_planned(measured, grade_chords(measured, make_size_field(face, sizes), rule, {}));
  };
  const double greatest = make_size_field(face, none).greatest();
  const CadFace whole = curve::whole_of(face, options.symmetry);
  const double shortest = least_size(segments_by_curves(whole, SizeField::default_per_curve, 0, greatest, 1));
  if (shortest >= greatest) return none;
  const double most = most_refined * num_elements(none);
  const auto are_few = [&](const SizeOptions& sizes) { return num_elements(sizes) <= most; };
  // Coarse sizes, whose chords need few samples, come first.
  const double least = std::max(shortest, least_curve_size * face.diameter);
  SizeOptions best = none;
  double fine = greatest, coarse = greatest;
  while (fine > least) {
    fine = std::max(least, fine / coarsening);
    if (!are_few(with_least(fine))) break;
    best = with_least(fine), coarse = fine;
  }
  for (int k = 0; k < num_bisections && fine < coarse; ++k) {
    const double middle = std::sqrt(fine * coarse);
    if (are_few(with_least(middle)))
      best = with_least(middle), coarse = middle;
    else
      fine = middle;
  }
  return best;
}

}  // namespace quadrille::sizing
