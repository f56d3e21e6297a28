#include "field/mirror_images.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "field/corner_lifting.hpp"

namespace quadrille::field {

namespace {

struct ImageLimits {
  // Of the distance of a foot, relative to the diameter and to the nearest distance: farther feet leave data that any
  // mesh resolves.
  double farthest_foot = 0.25, farthest_ratio = 3;
  // An image gets a term if its distance is at most this multiple of the distance of its foot.
  double farthest_image = 5;
  // Beyond a distance of (this - 1) times the radius of a convex bend, the data around the bend are smooth without an
  // image, and its circle of curvature does not approximate the rest of the boundary.
  double greatest_shrink = 2.5;
  // An image nearer to another curve than this multiple of its node's depth degrades the data there by more than it
  // improves them elsewhere.
  double least_clearance = 0.6;
  // Images nearer to each other than this fraction of the depth are the same: they come from both sides of a smooth
  // joint.
  double same_image = 1e-3;
};
constexpr ImageLimits image_limits;

// Feet at corners are excluded: there the normal of one side may point back into the domain.
bool is_at_corner(const CadFace& face, int c, double t) {
  const Nurbs& curve = face.curves[c];
  const double tol = 1e-9 * (curve.end() - curve.begin());
  if (t > curve.begin() + tol && t < curve.end() - tol) return false;
  const Joint& joint = face.joints[t <= curve.begin() + tol ? c : face.next_in_loop(c)];
  return std::abs(wrap_pi(joint.tangent_out - joint.tangent_in)) > 1e-3;
}

}  // namespace

/// The image in a curve, and the distance of the node from that curve.
struct MirrorImages::Candidate {
  MirrorImage image;
  double depth;
  int curve;
};

std::optional<MirrorImages::Candidate> MirrorImages::candidate(const curve::NearestPoint& foot, Vec2 x) const {
  const CadFace& face = boundary_.face();
  const Nurbs& curve = face.curves[foot.curve];
  const double depth = foot.distance;
  if (!(depth > 0) || is_at_corner(face, foot.curve, foot.t)) return {};
  const Vec2 along = curve::tangent(curve, foot.t, foot.t >= curve.end()), from_foot = x - foot.position;
  if (std::abs(dot(along, from_foot)) > 1e-6 * depth || cross(along, from_foot) <= 0) return {};
  const double shrink = 1 - curve::curvature(curve, foot.t, foot.t >= curve.end()) * depth;
  if (shrink * image_limits.farthest_image < 1 || shrink > image_limits.greatest_shrink) return {};
  const Vec2 outward = -left_of(along);
  const double beyond = depth / shrink;
  const Vec2 image = foot.position + beyond * outward;
  const double clearance = image_limits.least_clearance * std::min(depth, beyond);
  const auto is_other = [&](int other) { return other != foot.curve; };
  if (boundary_.nearest(image, is_other).distance < clearance) return {};
  const double to_boundary = 2 * distance(half_way(face, foot.position, outward), foot.position);
  if (beyond > 0.9 * to_boundary) return {};
  return Candidate{{image, face.loop_of(foot.curve)}, depth, foot.curve};
}

std::vector<MirrorImages::Candidate> MirrorImages::candidates(Vec2 x) const {
  const CadFace& face = boundary_.face();
  std::vector<Candidate> candidates;
  double farthest = image_limits.farthest_foot * face.diameter;
  const auto add = [&](const curve::NearestPoint& foot, double& reach) {
    const std::optional<Candidate> found = candidate(foot, x);
    if (!found) return;
    candidates.push_back(*found);
    reach = farthest = std::min(farthest, image_limits.farthest_ratio * found->depth * (1 + tolerance::tied));
  };
  boundary_.visit_feet(x, farthest, add, [&](int c) { return !face.is_interface(c); });  // behind a slit is the face
  std::erase_if(candidates, [&](const Candidate& found) { return found.depth > farthest; });
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.curve < b.curve; });
  return candidates;
}

std::vector<MirrorImage> MirrorImages::of(Vec2 x) const {
  std::vector<MirrorImage> images;
  for (const auto& [image, depth, c] : candidates(x)) {
    const auto is_same = [&, at = image.position, tol = image_limits.same_image * depth](const MirrorImage& other) {
      return distance(other.position, at) <= tol;
    };
    if (std::none_of(images.begin(), images.end(), is_same)) images.push_back(image);
  }
  return images;
}

}  // namespace quadrille::field
