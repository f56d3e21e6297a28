#include "cad/periodic_sides.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/name_text.hpp"
#include "curve/face_boundary.hpp"
#include "curve/nurbs.hpp"
#include "model/periodic.hpp"

namespace quadrille::cad {
namespace {

constexpr double relative_fit = 1e-9;   // of the diameter: the greatest distance of the image from the other side
constexpr double relative_same = 1e-8;  // of the diameter: points nearer than this are one joint
constexpr double angle_tol = 1e-9;      // radians: an angle nearer to a whole fraction of a turn is that
constexpr int max_fraction = 720;       // of a turn
constexpr int samples_per_span = 8;

/// A part of a side: curves that follow each other along the boundary of the whole, in its direction.
struct Part {
  std::string name;  ///< of the side
  std::vector<int> curves;
};

using Side = std::vector<Part>;

// From its own start on.
Nurbs from_zero(Nurbs curve) {
  const double begin = curve.begin();
  for (double& knot : curve.knots) knot -= begin;
  return curve;
}

/// Divides a curve of the boundary at the parameter t inside it, where its tangent is continuous: later curves are
/// renumbered. Both parts have its name and its edge.
void split_curve(CadFace& face, int curve, double t) {
  const Nurbs whole = face.curves[curve];
  const int added = curve + 1;
  const double tangent = angle_of(curve::tangent(whole, t));
  const auto renumber = [added](int& c) { c += c >= added; };
  face.curves[curve] = curve::trimmed(whole, whole.begin(), t);
  Nurbs rest = from_zero(curve::trimmed(whole, t, whole.end()));
  rest.poles.front() = face.curves[curve].poles.back();
  face.joints.insert(face.joints.begin() + added, {rest.poles.front(), tangent, tangent, pi, false});
  face.curves.insert(face.curves.begin() + added, std::move(rest));
  face.curve_names.insert(face.curve_names.begin() + added, std::string(face.curve_names[curve]));
  face.curve_cad_edges.insert(face.curve_cad_edges.begin() + added, int(face.curve_cad_edges[curve]));
  const bool is_unnamed = !face.has_given_name(curve);
  for (int& c : face.unnamed_curves) renumber(c);
  if (is_unnamed)
    face.unnamed_curves.insert(std::upper_bound(face.unnamed_curves.begin(), face.unnamed_curves.end(), curve), added);
  for (int& offset : face.loop_offsets) offset += offset > curve;
  if (!face.partners.empty()) {
    for (int& partner : face.partners) renumber(partner);
    face.partners.insert(face.partners.begin() + added, -1);
  }
  for (PeriodicPair& pair : face.periodic_pairs)
    for (int& c : pair.curves) renumber(c);
}

class PeriodicPairing {
 public:
  PeriodicPairing(CadFace& face, const PeriodicRequest& request)
      : face_(face), request_(request), same_(relative_same * face.diameter) {}

  void pair() {
    const Side first = side(request_.first), second = side(request_.second);
    require_two_sides(first, second);
    const GivenMotion given = request_.motion ? *request_.motion : motion_between(first, second);
    const PeriodicMotion motion(given.angle, given.shift, face_.origin);
    const Side images = images_of(first, second, motion);
    for (std::size_t k = 0; k < first.size(); ++k) require_fit(first[k], images[k], motion);
    split_at_joints(request_.second, images_of_joints(first, motion, true));
    split_at_joints(request_.first, images_of_joints(side(request_.second), motion, false));
    const Side from = side(request_.first), to = images_of(from, side(request_.second), motion);
    for (std::size_t k = 0; k < from.size(); ++k) pair_parts(from[k], to[k], given, motion);
  }

 private:
  void pair_parts(const Part& a, const Part& b, const GivenMotion& given, const PeriodicMotion& motion) {
    if (a.curves.size() != b.curves.size()) throw Defect("periodic sides with different numbers of curves");
    for (std::size_t k = 0; k < a.curves.size(); ++k) {
      const int from = a.curves[k], to = b.curves[b.curves.size() - 1 - k];
      replace_by_image(from, to, motion);
      face_.periodic_pairs.push_back({{from, to}, given.angle, given.shift});
    }
  }

  Vec2 start(int curve) const { return face_.curves[curve].poles.front(); }
  Vec2 end(int curve) const { return face_.curves[curve].poles.back(); }
  Vec2 start(const Part& part) const { return start(part.curves.front()); }
  Vec2 end(const Part& part) const { return end(part.curves.back()); }
  bool are_same(Vec2 a, Vec2 b) const { return distance(a, b) <= same_; }
  std::string place(Vec2 x) const { return position_text(x + face_.origin); }

  /// `name` may be a pattern.
  std::vector<int> curves_named(const std::string& name) const {
    std::vector<int> curves;
    for (int c = 0; c < face_.num_curves(); ++c)
      if (matches_wildcard(face_.curve_names[c], name)) curves.push_back(c);
    if (curves.empty())
      throw UsageError(fmt::format("{}: no curve is named '{}'; the names are: {}", request_.where, name,
                                   fmt::join(std::set(face_.curve_names.begin(), face_.curve_names.end()), ", ")));
    for (const int c : curves)
      if (face_.is_interface(c))
        throw UsageError(
            fmt::format("{}: '{}' at {} is not on the boundary: the face is on both sides of it, and free "
                        "periodic curves, which no side follows, are not supported; cut the shape there",
                        request_.where, name, place(start(c))));
    const std::vector<int> partners = periodic_partners(face_);
    for (const int c : curves)
      if (partners[c] >= 0)
        throw UsageError(fmt::format("{}: '{}' is already a side of another periodic pair", request_.where, name));
    return curves;
  }

  /// The parts of a side, each in the order of the boundary, also of several regions, whose loops it belongs to.
  Side side(const std::string& name) const {
    std::vector<int> rest = curves_named(name);
    Side side;
    while (!rest.empty()) {
      const auto follows_another = [&](int c) {
        return std::any_of(rest.begin(), rest.end(), [&](int o) { return are_same(end(o), start(c)); });
      };
      auto next = std::find_if_not(rest.begin(), rest.end(), follows_another);
      if (next == rest.end())
        throw UsageError(
            fmt::format("{}: the curves '{}' at {} are closed: no motion in the plane maps a closed side onto another "
                        "from outside; "
                        "cut the shape along two lines that repeat each other, and name these",
                        request_.where, name, place(start(rest.front()))));
      side.push_back({name, {}});
      for (; next != rest.end();
           next = std::find_if(rest.begin(), rest.end(), [&](int c) { return are_same(end(side.back()), start(c)); })) {
        side.back().curves.push_back(*next);
        rest.erase(next);
      }
    }
    return side;
  }

  void require_two_sides(const Side& a, const Side& b) const {
    for (const Part& part : a)
      for (const Part& other : b)
        for (const int c : part.curves)
          if (std::find(other.curves.begin(), other.curves.end(), c) != other.curves.end())
            throw UsageError(fmt::format("{}: '{}' is on both sides", request_.where, face_.curve_names[c]));
    if (a.size() != b.size())
      throw UsageError(fmt::format(
          "{}: '{}' has {} and '{}' has {} that do not follow each other ({}; {}): each part needs an image",
          request_.where, request_.first, counted(a.size(), "part"), request_.second, counted(b.size(), "part"),
          places(a), places(b)));
  }

  /// "(0, 0) to (1, 0), (2, 0) to (3, 0)"
  std::string places(const Side& side) const {
    std::vector<std::string> texts;
    for (const Part& part : side) texts.push_back(place(start(part)) + " to " + place(end(part)));
    return fmt::format("{}", fmt::join(texts, ", "));
  }

  /// How far the ends of the second part are from the images of those of the first one.
  double distance_of_ends(const Part& a, const Part& b, const PeriodicMotion& motion) const {
    return std::max(distance(motion.image(start(a)), end(b)), distance(motion.image(end(a)), start(b)));
  }

  /// The parts of b in the order of those of a whose images they are, by their ends.
  Side images_of(const Side& a, Side b, const PeriodicMotion& motion) const {
    for (std::size_t k = 0; k < a.size(); ++k) {
      const auto is_nearer = [&](const Part& x, const Part& y) {
        return distance_of_ends(a[k], x, motion) < distance_of_ends(a[k], y, motion);
      };
      std::iter_swap(b.begin() + k, std::min_element(b.begin() + k, b.end(), is_nearer));
    }
    return b;
  }

  /// The motion of the first part onto one of the second side with which the ends of all parts fit best.
  GivenMotion motion_between(const Side& a, const Side& b) const {
    GivenMotion best;
    double least = std::numeric_limits<double>::infinity();
    for (const Part& image : b) {
      const GivenMotion given = motion_between(a.front(), image);
      const PeriodicMotion motion(given.angle, given.shift, face_.origin);
      const Side images = images_of(a, b, motion);
      double worst = 0;
      for (std::size_t k = 0; k < a.size(); ++k) worst = std::max(worst, distance_of_ends(a[k], images[k], motion));
      if (worst < least - same_) least = worst, best = given;
    }
    return best;
  }

  // The motion that maps the line between the ends of the first part onto that of the second one.
  GivenMotion motion_between(const Part& a, const Part& b) const {
    const Vec2 a0 = start(a), a1 = end(a), b0 = start(b), b1 = end(b);
    const Vec2 from = (a0 + a1) / 2 + face_.origin, to = (b0 + b1) / 2 + face_.origin;
    double angle = wrap_pi(angle_of(b0 - b1) - angle_of(a1 - a0));
    for (int n = 1; n <= max_fraction; ++n)
      if (const double whole = 2 * pi * std::round(angle * n / (2 * pi)) / n; std::abs(angle - whole) < angle_tol) {
        angle = whole;
        break;
      }
    if (angle == 0) return {0, to - from};
    const Vec2 turn = unit(angle);
    return {angle, to - Vec2{turn.x * from.x - turn.y * from.y, turn.y * from.x + turn.x * from.y}};
  }

  curve::CurveTree tree_of(const std::vector<int>& curves) const {
    return curve::CurveTree(curves, [this](int c) -> const Nurbs& { return face_.curves[c]; });
  }

  std::vector<Vec2> samples(const Part& side) const {
    std::vector<Vec2> points;
    for (const int c : side.curves) {
      const Nurbs& curve = face_.curves[c];
      curve::for_each_span(curve, [&](double a, double b) {
        for (int i = 0; i < samples_per_span; ++i)
          points.push_back(curve::point(curve, a + (b - a) * i / samples_per_span));
      });
      points.push_back(curve.poles.back());
    }
    return points;
  }

  struct Worst {
    Vec2 at;
    double distance = 0;
    bool is_on_first = true;
  };

  void require_fit(const Part& a, const Part& b, const PeriodicMotion& motion) const {
    Worst worst;
    const auto compare = [&](Vec2 x, double d, bool is_on_first) {
      if (!(d <= worst.distance)) worst = {x, d, is_on_first};
    };
    compare(start(a), distance(motion.image(start(a)), end(b)), true);
    compare(end(a), distance(motion.image(end(a)), start(b)), true);
    const curve::CurveTree first = tree_of(a.curves), second = tree_of(b.curves);
    for (const Vec2 x : samples(a)) compare(x, second.nearest(motion.image(x)).distance, true);
    for (const Vec2 x : samples(b)) compare(x, first.nearest(motion.original(x)).distance, false);
    if (worst.distance <= relative_fit * face_.diameter) return;
    const GivenMotion own = motion_between(a, b);
    const std::string found =
        own.angle == 0 ? fmt::format("translate={:.9g},{:.9g}", own.shift.x, own.shift.y)
                       : fmt::format("rotate={:.9g}, about the point that maps their ends", degrees(own.angle));
    throw FormatError(fmt::format(
        "{}: the sides are not equal up to {} motion: the point {} of '{}' would be {:.3g} ({:.2g} diameters) away "
        "from '{}', and {:g} diameters are allowed; the ends of the sides give {}. Draw one side as a copy of the "
        "other{}",
        request_.where, request_.motion ? "this" : "a", place(worst.at), worst.is_on_first ? a.name : b.name,
        worst.distance, worst.distance / face_.diameter, worst.is_on_first ? b.name : a.name, relative_fit, found,
        request_.motion ? ", or leave out the motion" : ""));
  }

  // Of the joints inside parts.
  std::vector<Vec2> images_of_joints(const Side& side, const PeriodicMotion& motion, bool is_first) const {
    std::vector<Vec2> images;
    for (const Part& part : side)
      for (std::size_t k = 1; k < part.curves.size(); ++k) {
        const Vec2 joint = start(part.curves[k]);
        images.push_back(is_first ? motion.image(joint) : motion.original(joint));
      }
    return images;
  }

  void split_at_joints(const std::string& name, const std::vector<Vec2>& joints) {
    for (const Vec2 x : joints) {
      const std::vector<int> curves = curves_named(name);
      if (std::any_of(curves.begin(), curves.end(), [&](int c) { return are_same(start(c), x); })) continue;
      const curve::NearestPoint foot = tree_of(curves).nearest(x);
      split_curve(face_, curves[foot.curve], foot.t);
    }
  }

  // Whatever meets a joint meets it in its new place.
  void move_joint(Vec2 from, Vec2 to) {
    for (Nurbs& curve : face_.curves) {
      if (are_same(curve.poles.front(), from)) curve.poles.front() = to;
      if (are_same(curve.poles.back(), from)) curve.poles.back() = to;
    }
    for (Joint& joint : face_.joints)
      if (are_same(joint.position, from)) joint.position = to;
  }

  void turn_tangents(int joint, double change_in, double change_out) {
    Joint& j = face_.joints[joint];
    j.tangent_in = wrap_pi(j.tangent_in + change_in);
    j.tangent_out = wrap_pi(j.tangent_out + change_out);
    j.interior_angle += change_in - change_out;
  }

  void replace_by_image(int from, int to, const PeriodicMotion& motion) {
    Nurbs image = curve::reversed(face_.curves[from]);
    for (Vec2& pole : image.poles) pole = motion.image(pole);
    const Vec2 old_start = start(to), old_end = end(to);
    const int next = face_.next_in_loop(to);
    const double old_out = face_.joints[to].tangent_out, old_in = face_.joints[next].tangent_in;
    face_.curves[to] = image;
    move_joint(old_start, image.poles.front());
    move_joint(old_end, image.poles.back());
    const auto angle_at = [&](double t, bool from_left) { return angle_of(curve::tangent(image, t, from_left)); };
    turn_tangents(to, 0, wrap_pi(angle_at(image.begin(), false) - old_out));
    turn_tangents(next, wrap_pi(angle_at(image.end(), true) - old_in), 0);
  }

  CadFace& face_;
  const PeriodicRequest& request_;
  double same_;
};

}  // namespace

void pair_periodic_sides(CadFace& face, const std::vector<PeriodicRequest>& requests) {
  for (const PeriodicRequest& request : requests) PeriodicPairing(face, request).pair();
}

}  // namespace quadrille::cad
