#include "layers/end_spacing.hpp"

#include <algorithm>
#include <cmath>

#include "layers/layer_rules.hpp"

namespace quadrille::layers {
namespace {

/// Rule 21: if an arc is too short for first intervals as fine as its neighbours', its own would become finer from
/// block to block. Layers are always continued.
void relax_crowding(const ArcSpacing& spacing, int count, FreePart& part) {
  const double most = layer_constants.greatest_crowding * part.length / (count - part.layers);
  if (spacing[0].layers() == 0) part.ends.before = std::min(part.ends.before, most);
  if (spacing[1].layers() == 0) part.ends.after = std::min(part.ends.after, most);
}

}  // namespace

FreePart free_part(const ArcSpacing& spacing, double length, double size) {
  const auto top = [](const EndSpacing& end) { return end.layer_ends.empty() ? 0 : end.layer_ends.back(); };
  return {{spacing[0].before, spacing[1].before},
          (1 - top(spacing[0]) - top(spacing[1])) * length,
          size,
          spacing[0].layers() + spacing[1].layers()};
}

double least_growth(const mesh::Chord& chord, const std::vector<ArcSpacing>& spacings) {
  double least = 0;
  for (const int arc : chord.arcs)
    for (const EndSpacing& end : spacings[arc])
      if (!end.is_free()) least = least > 0 ? std::min(least, end.growth) : end.growth;
  return least;
}

std::vector<double> spaced_ends(const ArcSpacing& spacing, double length, double size, int count) {
  FreePart part = free_part(spacing, length, size);
  relax_crowding(spacing, count, part);
  std::vector<double> ends{0.0};
  ends.insert(ends.end(), spacing[0].layer_ends.begin(), spacing[0].layer_ends.end());
  const int num_free = count - part.layers;
  const std::vector<double> intervals = sizing::graded_intervals(part.ends, num_free, part.length, part.size);
  const double low = ends.back();
  double sum = 0;
  for (int k = 0; k + 1 < num_free; ++k) ends.push_back(low + (sum += intervals[k]) / length);
  for (int k = spacing[1].layers(); k-- > 0;) ends.push_back(1 - spacing[1].layer_ends[k]);
  ends.push_back(1);
  return ends;
}

double even_size(const ArcSpacing& spacing, double length, double size, double growth, int count) {
  constexpr double unlimited = 1e3;  // lengths of the arc: what grows towards it is a geometric series
  FreePart part = free_part(spacing, length, size);
  relax_crowding(spacing, count, part);
  const auto is_even = [&](double cap) {
    const std::vector<double> intervals = sizing::graded_intervals(part.ends, count - part.layers, part.length, cap);
    return sizing::worst_growth(part.ends, intervals) <= growth * (1 + layer_constants.equal_tol);
  };
  if (part.ends.are_free() || is_even(size)) return size;
  double low = std::log(size), high = std::log(std::max(size, unlimited * length));
  for (int step = 0; step < 40; ++step) {
    const double middle = (low + high) / 2;
    (is_even(std::exp(middle)) ? high : low) = middle;
  }
  return std::exp(high);
}

}  // namespace quadrille::layers
