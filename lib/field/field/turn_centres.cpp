#include "field/turn_centres.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "field/boundary_values.hpp"

namespace quadrille::field {
namespace {

// Sufficient fraction of the greatest clearance: the farther h_j is from the boundary, the smoother the data.
constexpr double good_clearance = 0.8;

using Polygon = std::vector<Vec2>;

Polygon sampled_loop(const CadFace& face, int loop) {
  constexpr int samples = 32;
  Polygon polygon;
  for (int c = face.loop_offsets[loop]; c < face.loop_offsets[loop + 1]; ++c) {
    const Nurbs& curve = face.curves[c];
    for (int i = 0; i < samples; ++i)
      polygon.push_back(curve::point(curve, curve.begin() + (curve.end() - curve.begin()) * i / samples));
  }
  return polygon;
}

// Area and first moments from triangles about the first point.
Vec2 centroid_of(const Polygon& polygon) {
  const Vec2 base = polygon.front();
  double area = 0;
  Vec2 moment;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Vec2 a = polygon[i] - base, b = polygon[i + 1] - base;
    area += cross(a, b);
    moment += cross(a, b) * (a + b) / 3.0;
  }
  return base + moment / area;
}

Vec2 hole_point(const curve::FaceBoundary& boundary, int loop) {
  const CadFace& face = boundary.face();
  const Vec2 centre = centroid_of(sampled_loop(face, loop));
  Vec2 best;
  double most = -INFINITY;
  for (int c = face.loop_offsets[loop]; c < face.loop_offsets[loop + 1]; ++c) {
    if (face.is_interface(c)) continue;  // behind a slit is the face
    const Nurbs& curve = face.curves[c];
    for (const double f : {0.5, 0.25, 0.75, 0.1, 0.9}) {
      const double t = curve.begin() + f * (curve.end() - curve.begin());
      const Vec2 x = half_way(face, curve::point(curve, t), -left_of(curve::tangent(curve, t)));
      const double clearance = -boundary.signed_distance(x);
      if (clearance > most * (1 + tolerance::tied)) most = clearance, best = x;
    }
  }
  return -boundary.signed_distance(centre) >= good_clearance * most ? centre : best;
}

// Of a slit: the joint whose sector is farthest from whole quarter turns. There the data jump in any case, and a fan
// resolves what their bridges disturb.
Vec2 slit_point(const CadFace& face, int loop) {
  int best = face.loop_offsets[loop];
  double most = -1;
  for (int joint = best; joint < face.loop_offsets[loop + 1]; ++joint) {
    const double off = std::abs(std::remainder(face.joints[joint].interior_angle, half_pi));
    if (off > most + tolerance::same_angle) most = off, best = joint;
  }
  return face.joints[best].position;
}

struct BendConstants {
  double sharp = 1.5;         // a bend: curvature above this multiple of the mean curvature around the hole
  double corner_turn = 1e-3;  // a joint with a greater turn (radians) is a corner
  double part_turn = 0.05;    // greatest turn of a part, radians
  int deepest = 20;           // bisection into parts
  int parts_of_curve = 32;
};
constexpr BendConstants bend_constants;

/// A short part of the boundary: clockwise around the hole, so that the tangent turns to the right where the hole is
/// convex.
struct Part {
  Vec2 middle, tangent;
  double length = 0;
  double turn = 0;  ///< radians, positive to the right
  bool begins_at_corner = false;
};

double turn_between(Vec2 before, Vec2 after) { return -std::atan2(cross(before, after), dot(before, after)); }

// Bisects [t0, t1] until each part turns by a small angle.
void add_parts(const Nurbs& curve, double t0, double t1, int depth, std::vector<Part>& parts) {
  const double middle = (t0 + t1) / 2;
  const Vec2 along = curve::tangent(curve, middle);
  const double turn =
      turn_between(curve::tangent(curve, t0), along) + turn_between(along, curve::tangent(curve, t1, true));
  if (std::abs(turn) > bend_constants.part_turn && depth < bend_constants.deepest) {
    add_parts(curve, t0, middle, depth + 1, parts);
    add_parts(curve, middle, t1, depth + 1, parts);
    return;
  }
  const Vec2 x = curve::point(curve, middle);
  parts.push_back({x, along, distance(curve::point(curve, t0), x) + distance(x, curve::point(curve, t1)), turn, false});
}

std::vector<Part> parts_of(const CadFace& face, int loop) {
  std::vector<Part> parts;
  for (int c = face.loop_offsets[loop]; c < face.loop_offsets[loop + 1]; ++c) {
    const Nurbs& curve = face.curves[c];
    const double begin = curve.begin(), step = (curve.end() - begin) / bend_constants.parts_of_curve;
    const Joint& joint = face.joints[c];
    const std::size_t first = parts.size();
    for (int i = 0; i < bend_constants.parts_of_curve; ++i)
      add_parts(curve, begin + i * step, begin + (i + 1) * step, 0, parts);
    parts[first].begins_at_corner =
        std::abs(wrap_pi(joint.tangent_out - joint.tangent_in)) > bend_constants.corner_turn;
  }
  return parts;
}

// Rotates the list to start at a corner, or else where the curvature is least, so that no bend extends across the end.
void rotate_to_start(std::vector<Part>& parts) {
  const auto is_flatter = [](const Part& a, const Part& b) { return a.turn * b.length < b.turn * a.length; };
  auto start = std::find_if(parts.begin(), parts.end(), [](const Part& part) { return part.begins_at_corner; });
  if (start == parts.end()) start = std::min_element(parts.begin(), parts.end(), is_flatter);
  std::rotate(parts.begin(), start, parts.end());
}

/// Parts [begin, end).
struct Run {
  std::size_t begin, end;
};

std::vector<Run> sharp_runs(const std::vector<Part>& parts) {
  double length = 0;
  for (const Part& part : parts) length += part.length;
  const double least = bend_constants.sharp * 2 * pi / length;
  std::vector<Run> runs;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!(parts[i].turn > least * parts[i].length)) continue;
    const bool goes_on = !runs.empty() && runs.back().end == i && !parts[i].begins_at_corner;
    if (goes_on) {
      runs.back().end = i + 1;
    } else {
      runs.push_back({i, i + 1});
    }
  }
  return runs;
}

double turn_of(const std::vector<Part>& parts, Run run) {
  double turn = 0;
  for (std::size_t i = run.begin; i < run.end; ++i) turn += parts[i].turn;
  return turn;
}

// The run, extended on both sides over parts that turn in the same direction, at most half the way to the next run and
// not beyond a corner.
Run extended(const std::vector<Part>& parts, Run run, std::size_t first, std::size_t last) {
  while (run.begin > first && !parts[run.begin].begins_at_corner && parts[run.begin - 1].turn > 0) --run.begin;
  while (run.end < last && !parts[run.end].begins_at_corner && parts[run.end].turn > 0) ++run.end;
  return run;
}

// The focus: at half the radius of curvature inside the hole, beside the part in the middle of the bend's turn.
Vec2 focus_of(const CadFace& face, const std::vector<Part>& parts, Run run) {
  const double half = (1 - 1e-6) * turn_of(parts, run) / 2;
  std::size_t i = run.begin, j = run.end - 1;  // one part, or two neighbours that are mirror images of each other
  for (double sum = parts[i].turn; sum < half; sum += parts[i].turn) ++i;
  for (double sum = parts[j].turn; sum < half; sum += parts[j].turn) --j;
  const Vec2 middle = (parts[i].middle + parts[j].middle) / 2;
  const Vec2 inward = -left_of(normalized(parts[i].tangent + parts[j].tangent));
  const double radius = (parts[i].length + parts[j].length) / (parts[i].turn + parts[j].turn);
  const double clearance = distance(half_way(face, parts[i].middle, inward), parts[i].middle);
  return middle + std::min(radius / 2, clearance) * inward;
}

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

std::vector<Vec2> hole_points(const CadFace& face) {
  const curve::FaceBoundary boundary(face);
  std::vector<Vec2> points;
  for (int loop = 1; loop < face.num_loops(); ++loop)
    points.push_back(face.is_slit_loop(loop) ? slit_point(face, loop) : hole_point(boundary, loop));
  return points;
}

std::vector<HoleFocus> hole_foci(const CadFace& face) {
  std::vector<HoleFocus> foci;
  for (int loop = 1; loop < face.num_loops(); ++loop) {
    if (face.is_slit_loop(loop)) continue;
    std::vector<Part> parts = parts_of(face, loop);
    rotate_to_start(parts);
    const std::vector<Run> runs = sharp_runs(parts);
    for (std::size_t r = 0; r < runs.size(); ++r) {
      const std::size_t first = r == 0 ? 0 : (runs[r - 1].end + runs[r].begin) / 2;
      const std::size_t last = r + 1 == runs.size() ? parts.size() : (runs[r].end + runs[r + 1].begin) / 2;
      const int turns = static_cast<int>(std::lround(2 * turn_of(parts, extended(parts, runs[r], first, last)) / pi));
      if (turns > 0) foci.push_back({focus_of(face, parts, runs[r]), loop, turns});
    }
  }
  return foci;
}

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
