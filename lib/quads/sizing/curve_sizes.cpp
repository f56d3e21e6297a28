#include "sizing/curve_sizes.hpp"

#include <algorithm>

#include "curve/arc_length.hpp"
#include "sizing/boundary_sizes.hpp"

namespace quadrille::sizing {
namespace {

constexpr int closed_factor = 3;

struct Run {
  std::vector<int> curves;
  double length = 0;
  bool is_closed = false;
};

/// Whether every mesh has a vertex at the start of the curve.
bool begins_run(const CadFace& face, int curve) {
  const int before = face.previous_in_loop(curve);
  return face.joints[curve].is_corner || (face.curve_names[before] != face.curve_names[curve] &&
                                          (face.has_given_name(before) || face.has_given_name(curve)));
}

std::vector<Run> runs_of_loop(const CadFace& face, int loop) {
  const int begin = face.loop_offsets[loop], end = face.loop_offsets[loop + 1];
  int first = begin;
  while (first < end && !begins_run(face, first)) ++first;
  std::vector<Run> runs;
  if (first == end) runs.push_back({{}, 0, true});
  for (int k = 0; k < end - begin; ++k) {
    const int curve = begin + (first - begin + k) % (end - begin);
    if (begins_run(face, curve)) runs.emplace_back();
    runs.back().curves.push_back(curve);
    runs.back().length += curve::ArcLength(face.curves[curve]).total();
  }
  return runs;
}

}  // namespace

std::vector<SizeSegment> segments_by_curves(const CadFace& face, int per_curve, double least, double greatest,
                                            double slope) {
  std::vector<SizeSegment> segments;
  for (int loop = 0; loop < face.num_loops(); ++loop)
    for (const Run& run : runs_of_loop(face, loop)) {
      const int number = run.is_closed ? closed_factor * per_curve : per_curve;
      const double size = std::max({run.length / number, least, least_curve_size * face.diameter});
      if (size >= greatest) continue;
      for (const int curve : run.curves) {
        const std::vector<SizeSegment> own = segments_near(face.curves[curve], size, slope);
        segments.insert(segments.end(), own.begin(), own.end());
      }
    }
  return segments;
}

}  // namespace quadrille::sizing
