#pragma once
// The ends of the elements across a chord: its parameter interval [0, 1] is cut into one interval per element.
//
// The parameters where an interval must end (joints inside a side) split the chord into segments. Each segment has a
// least number of intervals; the others are added, one by one, to the segment whose intervals are longest. Within a
// segment the intervals are equal. All choices are symmetric: a chord and its mirror image are cut at mirrored
// positions.

#include <vector>

namespace quadrille::sizing {

struct Segments {
  std::vector<double> ends{0.0, 1.0};  ///< ascending, 0 and 1 included
  std::vector<int> least_counts{1};    ///< least number of intervals of each segment

  int least_count() const;
};

/// Counts of the segments that sum to `count` >= segments.least_count(). Empty if equal segments compete for the
/// remaining intervals, so that no choice would be symmetric, unless `break_ties`: then earlier segments are preferred.
std::vector<int> segment_counts(const Segments& segments, int count, bool break_ties);

/// The count + 1 ends of the intervals, ascending from 0 to 1.
std::vector<double> interval_ends(const Segments& segments, const std::vector<int>& counts);

}  // namespace quadrille::sizing
