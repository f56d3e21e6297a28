#include "field/explicit_terms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "curve/pole_box.hpp"
#include "field/boundary_values.hpp"
#include "field/explicit_value.hpp"
#include "model/interfaces.hpp"

namespace quadrille::field {
namespace {

// Parameters that differ by less than this (relative to the curve's interval) denote the same point of the curve.
constexpr double parameter_tol = 1e-12;
// Nodes nearer than this to a joint or to each other coincide: at a smaller distance the direction from one to the
// other is rounding error.
constexpr double same_position_tol = 1e-8;

double range_of(const Nurbs& curve) { return curve.end() - curve.begin(); }

// The joint at which a boundary node lies; -1 for a node inside its curve.
int joint_of(const CadFace& face, const BoundaryNode& node) {
  if (node.curve < 0 || node.curve >= face.num_curves())
    throw ComputeError(fmt::format("curve {} does not exist: the face has {}", node.curve, face.num_curves()));
  const Nurbs& curve = face.curves[node.curve];
  const double tol = parameter_tol * range_of(curve);
  if (!(node.t >= curve.begin() - tol && node.t <= curve.end() + tol))
    throw ComputeError(fmt::format("a boundary node at parameter {} is not on curve {}", node.t, node.curve));
  const double near = same_position_tol * range_of(curve);
  if (node.t <= curve.begin() + near) return node.curve;
  return node.t >= curve.end() - near ? face.next_in_loop(node.curve) : -1;
}

std::vector<int> joint_valences(const CadFace& face, const PhaseNodes& prescribed) {
  std::vector<CornerValence> corners = prescribed.corners;
  for (const BoundaryNode& node : prescribed.boundary_nodes) {
    if (const int joint = joint_of(face, node); joint >= 0) corners.push_back({joint, node.valence});
  }
  std::vector<int> valences(face.num_curves(), 2);
  std::vector<bool> is_listed(face.num_curves(), false);
  for (const CornerValence& corner : corners) {
    if (corner.joint < 0 || corner.joint >= face.num_curves())
      throw ComputeError(
          fmt::format("corner {} does not exist: the face has {} joints", corner.joint, face.num_curves()));
    if (is_listed[corner.joint])
      throw ComputeError(fmt::format("the corner at joint {} is listed twice", corner.joint));
    is_listed[corner.joint] = true;
    valences[corner.joint] = corner.valence;
  }
  return valences;
}

// The boundary nodes inside curves, sorted by curve, then t.
std::vector<BoundaryNode> inner_nodes(const CadFace& face, const PhaseNodes& prescribed) {
  std::vector<BoundaryNode> inner;
  for (const BoundaryNode& node : prescribed.boundary_nodes) {
    if (joint_of(face, node) < 0) inner.push_back(node);
  }
  std::sort(inner.begin(), inner.end(), [](const BoundaryNode& a, const BoundaryNode& b) {
    return a.curve != b.curve ? a.curve < b.curve : a.t < b.t;
  });
  return inner;
}

// `branch` is the interior angle up to multiples of 2 pi and rounding. The angle is computed from the same tangents as
// the boundary data, so that the data of both sides of an apex agree to round-off.
BoundaryApex make_apex(const CadFace& face, int curve, double t, double branch, int valence, bool is_enclosed) {
  BoundaryApex apex{curve, t, branch, valence, is_enclosed};
  const auto [in, out] = tangents_at(face, apex);
  apex.interior_angle = branch + wrap_pi(pi - (angle_of(out) - angle_of(in)) - branch);
  return apex;
}

// The pole p_c. For a hole with bends, the focus nearest to the exterior pole among those visible from the apex c, if
// any: the terms centred at c and at p_c then belong to the turns around the same hole.
Vec2 pole_of(const CadFace& face, const std::vector<HoleFocus>& foci, int loop, Vec2 apex, Vec2 tangent_out,
             double interior_angle) {
  const Vec2 usual = exterior_pole(face, apex, tangent_out, interior_angle);
  Vec2 pole = usual;
  double nearest = INFINITY;
  for (const HoleFocus& focus : foci) {
    const double away = distance(focus.position, apex), from_usual = distance(focus.position, usual);
    if (focus.loop != loop || !(from_usual < nearest)) continue;
    const Vec2 direction = (focus.position - apex) / away;
    const bool points_outside = wrap_two_pi(angle_of(direction) - angle_of(tangent_out)) > interior_angle;
    if (!points_outside || away >= 1.9999 * distance(half_way(face, apex, direction), apex)) continue;
    pole = focus.position;
    nearest = from_usual;
  }
  return pole;
}

void add_corner_angles(const CadFace& face, CornerTerms& result) {
  for (const BoundaryApex& apex : result.apexes.apexes) {
    result.apex2corner_angle.push_back(-1);
    const double angle = apex.interior_angle, jump = 4 * angle - 2 * pi * apex.valence;
    if (std::abs(jump) <= jump_tol || apex.is_enclosed) continue;
    const Vec2 x = curve::point(face.curves[apex.curve], apex.t);
    const Vec2 pole = pole_of(face, result.foci, face.loop_of(apex.curve), x, tangents_at(face, apex).out, angle);
    result.apex2corner_angle.back() = static_cast<int>(result.corner_angles.size());
    result.corner_angles.push_back({x, pole, jump / angle});
  }
}

// Adds D_j, the turns that make the data of hole j single-valued, initially centred at one point of the hole.
void add_holes(const CadFace& face, CornerTerms& result) {
  for (const Vec2 x : hole_points(face)) result.holes.push_back({x, 4});
  for (const BoundaryApex& apex : result.apexes.apexes) {
    const int loop = face.loop_of(apex.curve);
    if (loop > 0) result.holes[loop - 1].turns += 2 - apex.valence;
  }
}

BoundarySamples samples_at(const CadFace& face, const CornerTerms& corners, int curve, std::span<const double> t) {
  const Nurbs& nurbs = face.curves[curve];
  BoundarySamples samples;
  samples.t.assign(t.begin(), t.end());
  for (const double at : t) {
    const int apex = find_apex(face, corners.apexes, curve, at);
    const Vec2 x = curve::point(nurbs, at);
    samples.apexes.push_back(apex);
    samples.x.push_back(x);
    samples.tangent_angles.push_back(angle_of(curve::tangent(nurbs, at)));
    samples.corner_angles.push_back(apex < 0 ? sum_of_corner_angles(corners.corner_angles, x, -1, {}) : 0);
  }
  return samples;
}

// The term (point or focus of a hole) that is nearest to the position of an image: the turns of the image are taken
// from it.
PhaseTurn& nearest_centre(const std::vector<HoleFocus>& foci, const MirrorImage& image, PhaseTerms& terms) {
  PhaseTurn* nearest = &terms.holes[image.loop - 1];
  for (std::size_t i = 0; i < foci.size(); ++i) {
    if (foci[i].loop != image.loop) continue;
    const bool is_nearer = distance(foci[i].position, image.position) < distance(nearest->position, image.position);
    if (is_nearer) nearest = &terms.images[i];
  }
  return *nearest;
}

// Adds terms.nodes and terms.images; returns for each image the loop behind which it lies.
std::vector<int> add_nodes_and_images(SharedCorners& corners, const std::vector<PhaseNode>& nodes, PhaseTerms& terms) {
  const std::vector<HoleFocus>& foci = corners.terms().foci;
  std::vector<int> image_loops;
  for (const HoleFocus& focus : foci) {
    PhaseTurn& hole = terms.holes[focus.loop - 1];
    const int turns = std::clamp(focus.turns, 0, std::max(hole.turns, 0));
    hole.turns -= turns;
    terms.images.push_back({focus.position, turns});
    image_loops.push_back(focus.loop);
  }
  for (const PhaseNode& node : nodes) {
    const int turns = 4 - node.valence;
    terms.nodes.push_back({node.position, turns});
    for (const MirrorImage& image : corners.images(node.position)) {
      terms.images.push_back({image.position, turns});
      image_loops.push_back(image.loop);
      if (image.loop > 0) nearest_centre(foci, image, terms).turns -= turns;
    }
  }
  return image_loops;
}

// An empty expansion in a disc that contains the loop.
AngleExpansion expansion_around(const CadFace& face, int loop) {
  const int first = face.loop_offsets[loop], last = face.loop_offsets[loop + 1];
  curve::PoleBox box = curve::pole_box(face.curves[first]);
  for (int c = first + 1; c < last; ++c) box.extend(curve::pole_box(face.curves[c]));
  const Vec2 middle = box.centre();
  double radius = 0;
  for (int c = first; c < last; ++c)
    for (const Vec2 pole : face.curves[c].poles) radius = std::max(radius, distance(pole, middle));
  return {middle, radius};
}

}  // namespace

void require_valence_sum(const CadFace& face, const PhaseNodes& prescribed) {
  int inside = 0, corners = 0, boundary = 0;
  for (const PhaseNode& node : prescribed.nodes) inside += 4 - node.valence;
  for (const CornerValence& corner : prescribed.corners) corners += 2 - corner.valence;
  for (const BoundaryNode& node : prescribed.boundary_nodes) boundary += 2 - node.valence;
  const int sum = inside + corners + boundary, expected = 4 * face.euler_characteristic();
  if (sum == expected) return;
  throw ComputeError(
      fmt::format("the valences do not add up: sum (4 - V) over {} interior nodes is {}, sum (2 - V) over {} corners "
                  "is {}, over {} boundary nodes {}; together {}, but a face with {} {} needs {}",
                  prescribed.nodes.size(), inside, prescribed.corners.size(), corners, prescribed.boundary_nodes.size(),
                  boundary, sum, face.num_loops() - 1, face.num_loops() == 2 ? "hole" : "holes", expected));
}

BoundaryApexes boundary_apexes(const CadFace& face, const PhaseNodes& prescribed) {
  const std::vector<int> valences = joint_valences(face, prescribed);
  const std::vector<BoundaryNode> inner = inner_nodes(face, prescribed);
  BoundaryApexes result;
  std::vector<BoundaryApex>& apexes = result.apexes;
  const std::vector<bool> are_enclosed = enclosed_joints(face);
  auto next = inner.begin();
  for (int c = 0; c < face.num_curves(); ++c) {
    const Nurbs& curve = face.curves[c];
    result.offsets.push_back(static_cast<int>(apexes.size()));
    apexes.push_back(make_apex(face, c, curve.begin(), face.joints[c].interior_angle, valences[c], are_enclosed[c]));
    for (; next != inner.end() && next->curve == c; ++next) {
      if (next->t - apexes.back().t <= same_position_tol * range_of(curve))
        throw ComputeError(fmt::format("two boundary nodes are at the same position on curve {}", c));
      apexes.push_back(make_apex(face, c, next->t, pi, next->valence, false));
    }
  }
  result.offsets.push_back(static_cast<int>(apexes.size()));
  return result;
}

int find_apex(const CadFace& face, const BoundaryApexes& apexes, int curve, double t) {
  const Nurbs& nurbs = face.curves[curve];
  const double tol = parameter_tol * range_of(nurbs);
  if (t >= nurbs.end() - tol) return apexes.offsets[face.next_in_loop(curve)];
  for (int a = apexes.offsets[curve]; a < apexes.offsets[curve + 1]; ++a) {
    if (std::abs(t - apexes.apexes[a].t) <= tol) return a;
  }
  return -1;
}

ApexTangents tangents_at(const CadFace& face, const BoundaryApex& apex) {
  const Nurbs& curve = face.curves[apex.curve];
  const bool is_joint = apex.t == curve.begin();
  const Nurbs& before = is_joint ? face.curves[face.previous_in_loop(apex.curve)] : curve;
  return {curve::tangent(before, is_joint ? before.end() : apex.t, true), curve::tangent(curve, apex.t)};
}

CornerTerms corner_terms(const CadFace& face, const PhaseNodes& prescribed) {
  CornerTerms result;
  result.apexes = boundary_apexes(face, prescribed);
  result.foci = hole_foci(face);
  add_corner_angles(face, result);
  add_holes(face, result);
  return result;
}

double sum_of_corner_angles(const std::vector<CornerAngle>& corner_angles, Vec2 x, int at_apex, Vec2 inward) {
  double sum = 0;
  for (std::size_t c = 0; c < corner_angles.size(); ++c) {
    const CornerAngle& corner = corner_angles[c];
    sum += corner.beta * corner_angle(corner, static_cast<int>(c) == at_apex ? corner.apex : x, inward);
  }
  return sum;
}

SharedCorners::SharedCorners(const CadFace& face, const PhaseNodes& prescribed)
    : corners_(prescribed.corners),
      boundary_nodes_(prescribed.boundary_nodes),
      face_(&face),
      mirror_images_(face),
      terms_(corner_terms(face, prescribed)),
      samples_(face.num_curves()) {}

bool SharedCorners::fit(const PhaseNodes& prescribed) const {
  return prescribed.corners == corners_ && prescribed.boundary_nodes == boundary_nodes_;
}

const BoundarySamples& SharedCorners::samples(int curve, std::span<const double> t) {
  BoundarySamples& samples = samples_[curve][t.front()];
  if (!std::equal(t.begin(), t.end(), samples.t.begin(), samples.t.end()))
    samples = samples_at(*face_, terms_, curve, t);
  return samples;
}

const std::vector<MirrorImage>& SharedCorners::images(Vec2 x) {
  const auto [entry, is_new] = images_.try_emplace({x.x, x.y});
  if (is_new) entry->second = mirror_images_.of(x);
  return entry->second;
}

double SharedCorners::extent_of_centre(int loop) const {
  return face_->is_slit_loop(loop) ? tolerance::round_off * face_->diameter : 0;
}

LoopCentres::LoopCentres(const CadFace& face, int loop, const std::vector<TurnCentre>& centres)
    : far_(expansion_around(face, loop)) {
  const Vec2 start = face.curves[face.loop_offsets[loop]].poles.front();
  for (const TurnCentre& centre : centres) {
    if (centre.winding_number(loop) != 0 || !far_.is_far(centre.position, centre.position)) {
      followed_.push_back(centre);
    } else if (centre.turns != 0) {
      far_.add(centre.position, {static_cast<double>(centre.turns), 0});
      constant_ += centre.turns * angle_of(start - centre.position);
    }
  }
  constant_ -= far_.at(start).x;
}

ExplicitTerms explicit_terms(SharedCorners& corners, const std::vector<PhaseNode>& nodes) {
  ExplicitTerms result;
  PhaseTerms& terms = result.terms;
  terms.corner_angles = corners.terms().corner_angles;
  terms.holes = corners.terms().holes;
  const std::vector<int> image_loops = add_nodes_and_images(corners, nodes, terms);
  const auto add_centre = [&](const PhaseTurn& turn, int loop, double extent) {
    result.centres.push_back({turn.position, turn.turns, loop, extent});
  };
  for (const PhaseTurn& node : terms.nodes) add_centre(node, -1, 0);
  for (std::size_t j = 0; j < terms.holes.size(); ++j)
    add_centre(terms.holes[j], static_cast<int>(j) + 1, corners.extent_of_centre(static_cast<int>(j) + 1));
  for (std::size_t i = 0; i < terms.images.size(); ++i) add_centre(terms.images[i], image_loops[i], 0);
  return result;
}

}  // namespace quadrille::field
