#pragma once
// Pairs the periodic sides of one request: what is the same in the plane and on curved faces.

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "cad/periodic_options.hpp"
#include "model/cad_face.hpp"

namespace quadrille::cad {

/// A part of a side: curves that follow each other along the boundary of the whole, in its direction.
struct SidePart {
  std::string name;  ///< of the side
  std::vector<int> curves;
};

using PeriodicSide = std::vector<SidePart>;

/// The curves of a name or pattern, as they follow each other. Throws UsageError for those that cannot be a side.
class SideFinder {
 public:
  SideFinder(const CadFace& face, const PeriodicRequest& request) : face_(face), request_(request) {}

  std::vector<int> curves_named(const std::string& name) const;
  /// The parts of a side, each in the order of the boundary, also of several regions, whose loops it belongs to.
  PeriodicSide side(const std::string& name) const;
  void require_two_sides(const PeriodicSide& a, const PeriodicSide& b) const;

 private:
  Vec2 start(int curve) const { return face_.curves[curve].poles.front(); }
  Vec2 end(int curve) const { return face_.curves[curve].poles.back(); }
  bool are_same(Vec2 a, Vec2 b) const;
  std::string place(Vec2 x) const;
  std::string places(const PeriodicSide& side) const;

  const CadFace& face_;
  const PeriodicRequest& request_;
};

/// Divides a curve of the boundary at the parameter t inside it, where its tangent is continuous: later curves are
/// renumbered. Both parts have its name and its edge; their curves in space are not divided.
void split_curve(CadFace& face, int curve, double t);

inline constexpr double relative_fit = 1e-9;   ///< diameters: the greatest distance of the image from the other side
inline constexpr double relative_same = 1e-8;  ///< diameters: points nearer than this are one joint

/// `Geometry`: of a face, with Point, Motion (image, original), diameter(), start(curve), end(curve), samples(curves),
/// feet_on(curves), which has nearest(point) with curve (an index of `curves`), t and distance, motion_between(parts),
/// split(curve, t), replace_by_image(first, second, motion), the texts place(point) and text(motion), and given(): the
/// motion of the request.
template <class Geometry>
class PeriodicPairing {
 public:
  using Point = typename Geometry::Point;
  using Motion = typename Geometry::Motion;

  PeriodicPairing(CadFace& face, const PeriodicRequest& request, Geometry& geometry)
      : face_(face), request_(request), geometry_(geometry), finder_(face, request) {}

  void pair() {
    const PeriodicSide first = finder_.side(request_.first), second = finder_.side(request_.second);
    finder_.require_two_sides(first, second);
    const Motion motion = request_.motion ? geometry_.given() : motion_between(first, second);
    const PeriodicSide images = images_of(first, second, motion);
    for (std::size_t k = 0; k < first.size(); ++k) require_fit(first[k], images[k], motion);
    split_at_joints(request_.second, images_of_joints(first, motion, true));
    split_at_joints(request_.first, images_of_joints(finder_.side(request_.second), motion, false));
    const PeriodicSide from = finder_.side(request_.first), to = images_of(from, finder_.side(request_.second), motion);
    for (std::size_t k = 0; k < from.size(); ++k) pair_parts(from[k], to[k], motion);
  }

 private:
  void pair_parts(const SidePart& a, const SidePart& b, const Motion& motion) {
    if (a.curves.size() != b.curves.size()) throw Defect("periodic sides with different numbers of curves");
    for (std::size_t k = 0; k < a.curves.size(); ++k) {
      const int from = a.curves[k], to = b.curves[b.curves.size() - 1 - k];
      geometry_.replace_by_image(from, to, motion);
      face_.periodic_pairs.push_back(geometry_.pair_of(from, to, motion));
    }
  }

  Point start(const SidePart& part) const { return geometry_.start(part.curves.front()); }
  Point end(const SidePart& part) const { return geometry_.end(part.curves.back()); }
  double same() const { return relative_same * geometry_.diameter(); }

  /// How far the ends of the second part are from the images of those of the first one.
  double distance_of_ends(const SidePart& a, const SidePart& b, const Motion& motion) const {
    return std::max(distance(motion.image(start(a)), end(b)), distance(motion.image(end(a)), start(b)));
  }

  /// The parts of b in the order of those of a whose images they are, by their ends.
  PeriodicSide images_of(const PeriodicSide& a, PeriodicSide b, const Motion& motion) const {
    for (std::size_t k = 0; k < a.size(); ++k) {
      const auto is_nearer = [&](const SidePart& x, const SidePart& y) {
        return distance_of_ends(a[k], x, motion) < distance_of_ends(a[k], y, motion);
      };
      std::iter_swap(b.begin() + k, std::min_element(b.begin() + k, b.end(), is_nearer));
    }
    return b;
  }

  /// The motion of the first part onto one of the second side with which the ends of all parts fit best.
  Motion motion_between(const PeriodicSide& a, const PeriodicSide& b) const {
    Motion best;
    double least = std::numeric_limits<double>::infinity();
    for (const SidePart& image : b) {
      const Motion motion = geometry_.motion_between(a.front(), image);
      const PeriodicSide images = images_of(a, b, motion);
      double worst = 0;
      for (std::size_t k = 0; k < a.size(); ++k) worst = std::max(worst, distance_of_ends(a[k], images[k], motion));
      if (worst < least - same()) least = worst, best = motion;
    }
    return best;
  }

  struct Worst {
    Point at;
    double distance = 0;
    bool is_on_first = true;
  };

  void require_fit(const SidePart& a, const SidePart& b, const Motion& motion) const {
    Worst worst;
    const auto compare = [&](Point x, double d, bool is_on_first) {
      if (!(d <= worst.distance)) worst = {x, d, is_on_first};
    };
    compare(start(a), distance(motion.image(start(a)), end(b)), true);
    compare(end(a), distance(motion.image(end(a)), start(b)), true);
    const auto first = geometry_.feet_on(a.curves), second = geometry_.feet_on(b.curves);
    for (const Point x : geometry_.samples(a.curves)) compare(x, second.nearest(motion.image(x)).distance, true);
    for (const Point x : geometry_.samples(b.curves)) compare(x, first.nearest(motion.original(x)).distance, false);
    if (worst.distance <= relative_fit * geometry_.diameter()) return;
    throw FormatError(fmt::format(
        "{}: the sides are not equal up to {} motion: the point {} of '{}' would be {:.3g} ({:.2g} diameters) away "
        "from '{}', and {:g} diameters are allowed; the ends of the sides give {}. Draw one side as a copy of the "
        "other{}",
        request_.where, request_.motion ? "this" : "a", geometry_.place(worst.at), worst.is_on_first ? a.name : b.name,
        worst.distance, worst.distance / geometry_.diameter(), worst.is_on_first ? b.name : a.name, relative_fit,
        geometry_.text(geometry_.motion_between(a, b)), request_.motion ? ", or leave out the motion" : ""));
  }

  // Of the joints inside parts.
  std::vector<Point> images_of_joints(const PeriodicSide& side, const Motion& motion, bool is_first) const {
    std::vector<Point> images;
    for (const SidePart& part : side)
      for (std::size_t k = 1; k < part.curves.size(); ++k) {
        const Point joint = geometry_.start(part.curves[k]);
        images.push_back(is_first ? motion.image(joint) : motion.original(joint));
      }
    return images;
  }

  void split_at_joints(const std::string& name, const std::vector<Point>& joints) {
    for (const Point x : joints) {
      const std::vector<int> curves = finder_.curves_named(name);
      const auto starts_there = [&](int c) { return distance(geometry_.start(c), x) <= same(); };
      if (std::any_of(curves.begin(), curves.end(), starts_there)) continue;
      const auto foot = geometry_.feet_on(curves).nearest(x);
      geometry_.split(curves[foot.curve], foot.t);
    }
  }

  CadFace& face_;
  const PeriodicRequest& request_;
  Geometry& geometry_;
  SideFinder finder_;
};

}  // namespace quadrille::cad
