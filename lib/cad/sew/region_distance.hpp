#pragma once
// How two regions lie to each other, from samples of their boundaries: for messages about regions that do not fit.

#include <optional>

#include "sew/region.hpp"

namespace quadrille::sew {

struct MeasuredPlace {
  Vec2 position;
  double size = 0;  ///< a length
};

/// Where the regions overlap, with the greatest distance of a sample in both regions from their boundaries; samples
/// that are nearer than `negligible` to a boundary do not count. std::nullopt if no sample is in both.
std::optional<MeasuredPlace> overlap(const Region& a, const Region& b, double negligible);

/// The least distance of their boundaries, to about a millionth of it, in the middle between them.
MeasuredPlace gap_between(const Region& a, const Region& b);

}  // namespace quadrille::sew
