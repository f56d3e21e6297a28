#include "field/mirror_images.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "curve/project.hpp"
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

std::optional<MirrorImages::Candidate> MirrorImages::candidate(int c, Vec2 x) const {
  const CadFace& face = *face_;
  const Nurbs& curve = face.curves[c];
  const curve::Projection foot = curve::project(curve, x);
  const double depth = foot.distance;
  if (!(depth > 0 && depth <= image_limits.farthest_foot * face.diameter) || is_at_corner(face, c, foot.t)) return {};
  const Vec2 along = curve::tangent(curve, foot.t, foot.t >= curve.end()), from_foot = x - foot.position;
  if (std::abs(dot(along, from_foot)) > 1e-6 * depth || cross(along, from_foot) <= 0) return {};
  const double shrink = 1 - curve::curvature(curve, foot.t, foot.t >= curve.end()) * depth;
  if (shrink * image_limits.farthest_image < 1 || shrink > image_limits.greatest_shrink) return {};
  const Vec2 outward = -left_of(along);
  const double beyond = depth / shrink;
  const Vec2 image = foot.position + beyond * outward;
  const double clearance = image_limits.least_clearance * std::min(depth, beyond);
  for (int other = 0; other < face.num_curves(); ++other) {
    if (other != c && boxes_[other].contains(image, clearance) && boxes_[other].distance_from(image) < clearance &&
        curve::project(face.curves[other], image).distance < clearance)
      return {};
  }
  const double to_boundary = 2 * distance(half_way(face, foot.position, outward), foot.position);
  if (beyond > 0.9 * to_boundary) return {};
  return Candidate{{image, face.loop_of(c)}, depth, c};
}

// Curves that may be near come first: a near candidate excludes the curves beyond it.
std::vector<MirrorImages::Candidate> MirrorImages::candidates(Vec2 x) const {
  std::vector<std::pair<double, int>> order;
  for (int c = 0; c < face_->num_curves(); ++c) {
    if (face_->is_interface(c)) continue;  // behind a slit is the face
    const double bound = boxes_[c].distance_from(x);
    if (bound <= image_limits.farthest_foot * face_->diameter) order.emplace_back(bound, c);
  }
  std::make_heap(order.begin(), order.end(), std::greater<>());  // few of many curves are taken from it
  std::vector<Candidate> candidates;
  double reach = INFINITY;
  for (; !order.empty(); order.pop_back()) {
    std::pop_heap(order.begin(), order.end(), std::greater<>());
    const auto [bound, c] = order.back();
    if (bound > reach) break;
    const std::optional<Candidate> found = candidate(c, x);
    if (!found) continue;
    reach = std::min(reach, image_limits.farthest_ratio * found->depth * (1 + 1e-6));
    candidates.push_back(*found);
  }
  std::erase_if(candidates, [&](const Candidate& found) { return found.depth > reach; });
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.curve < b.curve; });
  return candidates;
}

MirrorImages::MirrorImages(const CadFace& face) : face_(&face), boxes_(curve::pole_boxes(face.curves)) {}

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
