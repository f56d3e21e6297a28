#include "features/loop_section.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/angle.hpp"
#include "base/bracketed_root.hpp"
#include "base/tolerance.hpp"
#include "curve/chain.hpp"
#include "curve/nurbs.hpp"
#include "curve/project.hpp"
#include "features/feature_state.hpp"

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

TurnSide side_at(const Nurbs& curve, double t, double least_curvature) {
  const double k = curve::curvature(curve, t);
  if (!(std::abs(k) > least_curvature)) return TurnSide::none;
  return k > 0 ? TurnSide::left : TurnSide::right;
}

/// The parameter between a and b at which the side of the curvature changes.
double change_between(const Nurbs& curve, double a, double b, double least_curvature) {
  const TurnSide side = side_at(curve, a, least_curvature);
  return bisect([&](double t) { return side_at(curve, t, least_curvature) == side ? -1 : 1; }, a, b);
}

double turn_between(const Nurbs& curve, double a, double b) {
  return std::abs(wrap_pi(angle_of(curve::tangent(curve, b, true)) - angle_of(curve::tangent(curve, a))));
}

/// Sets the turning and the greatest curvature.
void measure(const Nurbs& curve, const std::vector<double>& samples, CurvedInterval& part) {
  double last = part.interval.t0;
  const auto advance = [&](double t) {
    part.turning += turn_between(curve, last, t);
    part.greatest_curvature =
        std::max({part.greatest_curvature, std::abs(curve::curvature(curve, (last + t) / 2)),
                  std::abs(curve::curvature(curve, last)), std::abs(curve::curvature(curve, t, true))});
    last = t;
  };
  for (const double t : samples) {
    if (t > last && t < part.interval.t1) advance(t);
  }
  advance(part.interval.t1);
}

std::vector<CurvedInterval> curved_intervals(const Nurbs& curve, int id, double least_curvature) {
  const std::vector<double> samples = sample_parameters(curve);
  std::vector<CurvedInterval> parts;
  TurnSide side = TurnSide::none;
  double previous = curve.begin();
  for (size_t i = 1; i < samples.size(); ++i) {
    const double middle = (samples[i - 1] + samples[i]) / 2;
    const TurnSide here = side_at(curve, middle, least_curvature);
    if (here != side) {
      const double change = i == 1 ? curve.begin() : change_between(curve, previous, middle, least_curvature);
      if (side != TurnSide::none) parts.back().interval.t1 = change;
      if (here != TurnSide::none) parts.push_back({{id, change, curve.end()}, here});
    }
    side = here;
    previous = middle;
  }
  for (CurvedInterval& part : parts) measure(curve, samples, part);
  return parts;
}

/// Whether b continues a over a smooth joint.
bool does_continue(const CadFace& face, const CurvedInterval& a, const CurvedInterval& b) {
  return a.side == b.side && a.interval.t1 == face.curves[a.interval.curve].end() &&
         b.interval.t0 == face.curves[b.interval.curve].begin() &&
         face.next_in_loop(a.interval.curve) == b.interval.curve && !face.joints[b.interval.curve].is_corner;
}

/// Joins the last run to the first if the loop's first joint lies inside a run.
void close_loop(const CadFace& face, std::vector<CurvedRun>& runs) {
  if (runs.empty() || !does_continue(face, runs.back().parts.back(), runs.front().parts.front())) return;
  if (runs.size() == 1) {
    runs.front().is_loop = true;
    return;
  }
  std::vector<CurvedInterval>& first = runs.front().parts;
  first.insert(first.begin(), runs.back().parts.begin(), runs.back().parts.end());
  runs.pop_back();
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

double CurvedRun::turning() const {
  double sum = 0;
  for (const CurvedInterval& part : parts) sum += part.turning;
  return sum;
}

double CurvedRun::least_radius() const {
  double greatest = 0;
  for (const CurvedInterval& part : parts) greatest = std::max(greatest, part.greatest_curvature);
  return 1 / greatest;
}

std::vector<CurveInterval> CurvedRun::intervals() const {
  std::vector<CurveInterval> result;
  for (const CurvedInterval& part : parts) result.push_back(part.interval);
  return result;
}

std::vector<CurvedRun> curved_runs(const CadFace& face, int loop, double least_curvature) {
  std::vector<CurvedRun> runs;
  for (int c = face.loop_offsets[loop]; c < face.loop_offsets[loop + 1]; ++c) {
    for (const CurvedInterval& part : curved_intervals(face.curves[c], c, least_curvature)) {
      if (!runs.empty() && does_continue(face, runs.back().parts.back(), part))
        runs.back().parts.push_back(part);
      else
        runs.push_back({{part}});
    }
  }
  close_loop(face, runs);
  return runs;
}

std::vector<double> sample_parameters(const Nurbs& curve) {
  constexpr int n = feature_constants.samples_per_span;
  std::vector<double> t{curve.begin()};
  for (size_t i = 1; i < curve.knots.size(); ++i) {
    const double a = curve.knots[i - 1], b = curve.knots[i];
    for (int j = 1; a < b && j <= n; ++j) t.push_back(a + (b - a) * j / n);
  }
  t.back() = curve.end();
  return t;
}

}  // namespace quadrille::features
