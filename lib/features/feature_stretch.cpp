#include "features/feature_stretch.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "curve/arc_length.hpp"
#include "curve/nurbs.hpp"
#include "curve/project.hpp"

namespace quadrille::features {
namespace {

constexpr double knot_tol = 1e-9;  // of a curve's parameter range: nearer to a knot or end is the knot or joint

double length_of(const Nurbs& curve, double t0, double t1) { return curve::ArcLength(curve).between(t0, t1); }

BoundaryPlace place(const CadFace& face, int curve, double t) {
  const Nurbs& c = face.curves[curve];
  const double tol = knot_tol * (c.end() - c.begin());
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

Stretch::Stretch(const CadFace& face, std::vector<CurvePart> parts, bool is_closed)
    : face_(&face), parts_(std::move(parts)), is_closed_(is_closed) {
  double length = 0;
  for (const CurvePart& part : parts_) ends_.push_back(length += length_of(face.curves[part.curve], part.t0, part.t1));
}

BoundaryPlace Stretch::at(double fraction) const {
  fraction = is_closed_ ? fraction - std::floor(fraction) : std::clamp(fraction, 0.0, 1.0);
  const double target = fraction * length();
  const size_t i =
      std::min<size_t>(std::lower_bound(ends_.begin(), ends_.end(), target) - ends_.begin(), parts_.size() - 1);
  const curve::ArcLength arc(face_->curves[parts_[i].curve]);
  const double start = i == 0 ? 0 : ends_[i - 1];
  return place(*face_, parts_[i].curve, arc.parameter(arc.at(parts_[i].t0) + target - start));
}

StretchFoot Stretch::foot(Vec2 x) const {
  StretchFoot best;
  for (size_t i = 0; i < parts_.size(); ++i) {
    const auto& [curve, t0, t1] = parts_[i];
    const curve::Projection p = curve::project(face_->curves[curve], x, t0, t1);
    if (i > 0 && p.distance >= best.distance) continue;
    const double start = i == 0 ? 0 : ends_[i - 1];
    best = {(start + length_of(face_->curves[curve], t0, p.t)) / length(), p.distance, p.position};
  }
  return best;
}

}  // namespace quadrille::features
