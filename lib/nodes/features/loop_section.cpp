#include "features/loop_section.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/tolerance.hpp"
#include "curve/arc_length.hpp"
#include "curve/nurbs.hpp"
#include "curve/project.hpp"

namespace quadrille::features {
namespace {

double length_of(const Nurbs& curve, double t0, double t1) { return curve::ArcLength(curve).between(t0, t1); }

SectionPoint boundary_point(const CadFace& face, int curve, double t) {
  const Nurbs& c = face.curves[curve];
  const double tol = tolerance::round_off * (c.end() - c.begin());
  if (t >= c.end() - tol) {
    curve = face.next_in_loop(curve);
    t = face.curves[curve].begin();
  } else {
    for (const double knot : c.knots) {
      if (std::abs(t - knot) <= tol) t = knot;
    }
  }
  return {curve, t, curve::point(face.curves[curve], t)};
}

}  // namespace

LoopSection::LoopSection(const CadFace& face, std::vector<CurveInterval> intervals, bool is_closed)
    : face_(&face), intervals_(std::move(intervals)), is_closed_(is_closed) {
  double length = 0;
  for (const CurveInterval& i : intervals_) ends_.push_back(length += length_of(face.curves[i.curve], i.t0, i.t1));
}

SectionPoint LoopSection::at(double fraction) const {
  fraction = is_closed_ ? fraction - std::floor(fraction) : std::clamp(fraction, 0.0, 1.0);
  const double target = fraction * length();
  const size_t i =
      std::min<size_t>(std::lower_bound(ends_.begin(), ends_.end(), target) - ends_.begin(), intervals_.size() - 1);
  const curve::ArcLength arc(face_->curves[intervals_[i].curve]);
  const double start = i == 0 ? 0 : ends_[i - 1];
  return boundary_point(*face_, intervals_[i].curve, arc.parameter(arc.at(intervals_[i].t0) + target - start));
}

SectionFoot LoopSection::foot(Vec2 x) const {
  SectionFoot best;
  for (size_t i = 0; i < intervals_.size(); ++i) {
    const auto& [curve, t0, t1] = intervals_[i];
    const curve::Projection p = curve::project(face_->curves[curve], x, t0, t1);
    if (i > 0 && p.distance >= best.distance) continue;
    const double start = i == 0 ? 0 : ends_[i - 1];
    best = {(start + length_of(face_->curves[curve], t0, p.t)) / length(), p.distance, p.position};
  }
  return best;
}

LoopSection whole_loop(const CadFace& face, int loop) {
  std::vector<CurveInterval> intervals;
  for (int c = face.loop_offsets[loop]; c < face.loop_offsets[loop + 1]; ++c)
    intervals.push_back({c, face.curves[c].begin(), face.curves[c].end()});
  return {face, std::move(intervals), true};
}

bool do_overlap(const LoopSection& a, const LoopSection& b) {
  for (const CurveInterval& p : a.intervals()) {
    for (const CurveInterval& q : b.intervals()) {
      if (p.curve == q.curve && p.t0 < q.t1 && q.t0 < p.t1) return true;
    }
  }
  return false;
}

}  // namespace quadrille::features
