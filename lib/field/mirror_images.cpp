#include "field/mirror_images.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "curve/project.hpp"
#include "field/corner_lifting.hpp"

namespace quadrille::field {

namespace {

// Limits of the distance of a foot, relative to the diameter and to the nearest distance: farther feet leave data that
// any mesh resolves.
constexpr double farthest_foot = 0.25, farthest_ratio = 3;
// An image gets a term if its distance is at most this multiple of the distance of its foot.
constexpr double farthest_image = 5;
// Beyond a distance of (this - 1) times the radius of a convex bend, the data around the bend are smooth without an
// image, and its circle of curvature does not approximate the rest of the boundary.
constexpr double greatest_shrink = 2.5;
// An image nearer to another curve than this multiple of its node's depth degrades the data there by more than it
// improves them elsewhere.
constexpr double least_clearance = 0.6;
// Images nearer to each other than this fraction of the depth are the same: they come from both sides of a smooth
// joint.
constexpr double same_image = 1e-3;

// Feet at corners are excluded: there the normal of one side may point back into the domain.
bool is_at_corner(const CadFace& face, int c, double t) {
  const Nurbs& curve = face.curves[c];
  const double tol = 1e-9 * (curve.end() - curve.begin());
  if (t > curve.begin() + tol && t < curve.end() - tol) return false;
  const Joint& joint = face.joints[t <= curve.begin() + tol ? c : face.next_in_loop(c)];
  return std::abs(wrap_pi(joint.tangent_out - joint.tangent_in)) > 1e-3;
}

struct Candidate {
  MirrorImage image;
  double depth;
};

void add_candidate(const CadFace& face, int c, Vec2 x, std::vector<Candidate>& candidates) {
  const Nurbs& curve = face.curves[c];
  const curve::Projection foot = curve::project(curve, x);
  const double depth = foot.distance;
  if (!(depth > 0 && depth <= farthest_foot * face.diameter) || is_at_corner(face, c, foot.t)) return;
  const Vec2 along = curve::tangent(curve, foot.t, foot.t >= curve.end()), from_foot = x - foot.position;
  if (std::abs(dot(along, from_foot)) > 1e-6 * depth || cross(along, from_foot) <= 0) return;
  const double shrink = 1 - curve::curvature(curve, foot.t, foot.t >= curve.end()) * depth;
  if (shrink * farthest_image < 1 || shrink > greatest_shrink) return;
  const Vec2 outward = -left_of(along);
  const double beyond = depth / shrink;
  const double to_boundary = 2 * distance(half_way(face, foot.position, outward), foot.position);
  if (beyond > 0.9 * to_boundary) return;
  const Vec2 image = foot.position + beyond * outward;
  for (int other = 0; other < face.num_curves(); ++other) {
    if (other != c && curve::project(face.curves[other], image).distance < least_clearance * std::min(depth, beyond))
      return;
  }
  candidates.push_back({{image, face.loop_of(c)}, depth});
}

}  // namespace

std::vector<MirrorImage> mirror_images(const CadFace& face, Vec2 x) {
  std::vector<Candidate> candidates;
  for (int c = 0; c < face.num_curves(); ++c) add_candidate(face, c, x, candidates);
  double nearest = INFINITY;
  for (const Candidate& candidate : candidates) nearest = std::min(nearest, candidate.depth);
  std::vector<MirrorImage> images;
  for (const auto& [image, depth] : candidates) {
    const auto is_same = [&, at = image.position, tol = same_image * depth](const MirrorImage& other) {
      return distance(other.position, at) <= tol;
    };
    if (depth <= farthest_ratio * nearest * (1 + 1e-6) && std::none_of(images.begin(), images.end(), is_same))
      images.push_back(image);
  }
  return images;
}

}  // namespace quadrille::field
