#include "field/phase_boundary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"
#include "field/corner_lifting.hpp"
#include "field/hole_foci.hpp"
#include "field/hole_points.hpp"
#include "field/mirror_images.hpp"
#include "field/phase_value.hpp"

namespace quadrille::field {

namespace {

// Corner angles of a smaller jump are the rounding of tangents in the CAD file (see corner_lifting.cpp).
constexpr double jump_tol = 1e-10;
// Gap of the data that round-off and jumps left out can explain.
constexpr double closure_tol = 1e-7;
// Parameters this near (as a share of the curve's interval) are the same point of the curve.
constexpr double parameter_tol = 1e-12;
// Nodes nearer to a joint or to each other than this are at one place: the angle under which one sees the other from
// nearer is rounding error.
constexpr double same_place_tol = 1e-8;
// A node that cannot be told from the boundary at this share of the diameter lies on it.
constexpr double node_tol = 1e-9;
// Angles from a piece's references stay below acos(0.1) < pi / 2.
constexpr double least_cosine = 0.1;

/// `angle` plus the multiple of 2 pi that brings it nearest to `reference`.
double near(double reference, double angle) { return reference + wrap_pi(angle - reference); }

double range_of(const Nurbs& curve) { return curve.end() - curve.begin(); }

double extent(const Nurbs& piece) {
  double most = 0;
  for (const Vec2 pole : piece.poles) most = std::max(most, distance(pole, piece.poles.front()));
  return most;
}

bool is_within(Vec2 a, Vec2 axis) { return dot(a, axis) >= least_cosine * norm(a) * norm(axis); }

Vec2 middle_of_ends(const Nurbs& piece) { return (piece.poles.front() + piece.poles.back()) / 2; }

// The tangents of a curve with positive weights lie in the cone of the differences of its poles: B-splines are totally
// positive, so (sum w N P)' sum w N - ... is a positive combination of P_j - P_i, i < j.
bool tangents_are_near_chord(const Nurbs& piece) {
  const Vec2 chord = piece.poles.back() - piece.poles.front();
  if (chord == Vec2{}) return false;
  for (std::size_t i = 1; i < piece.poles.size(); ++i) {
    if (!is_within(piece.poles[i] - piece.poles[i - 1], chord)) return false;
  }
  return true;
}

// The curve lies in the hull of its poles.
bool is_seen_within_a_quarter_turn(const Nurbs& piece, Vec2 from) {
  const Vec2 axis = middle_of_ends(piece) - from;
  if (axis == Vec2{}) return false;
  return std::all_of(piece.poles.begin(), piece.poles.end(), [&](Vec2 pole) { return is_within(pole - from, axis); });
}

int round_to_turns(double angle) { return static_cast<int>(std::lround(angle / (2 * pi))); }

// The joint that a boundary node at the end of a curve is, -1 for one inside.
int joint_of(const CadFace& face, const BoundaryNode& node) {
  if (node.curve < 0 || node.curve >= face.num_curves())
    throw ComputeError(fmt::format("curve {} does not exist: the face has {}", node.curve, face.num_curves()));
  const Nurbs& curve = face.curves[node.curve];
  const double tol = parameter_tol * range_of(curve);
  if (!(node.t >= curve.begin() - tol && node.t <= curve.end() + tol))
    throw ComputeError(fmt::format("a boundary node at parameter {} is not on curve {}", node.t, node.curve));
  const double near = same_place_tol * range_of(curve);
  if (node.t <= curve.begin() + near) return node.curve;
  return node.t >= curve.end() - near ? face.next_in_loop(node.curve) : -1;
}

std::vector<int> joint_valences(const CadFace& face, const PhaseNodes& asked) {
  std::vector<CornerValence> corners = asked.corners;
  for (const BoundaryNode& node : asked.boundary_nodes) {
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

// Boundary nodes inside curves, by curve, then t.
std::vector<BoundaryNode> inner_nodes(const CadFace& face, const PhaseNodes& asked) {
  std::vector<BoundaryNode> inner;
  for (const BoundaryNode& node : asked.boundary_nodes) {
    if (joint_of(face, node) < 0) inner.push_back(node);
  }
  std::sort(inner.begin(), inner.end(), [](const BoundaryNode& a, const BoundaryNode& b) {
    return a.curve != b.curve ? a.curve < b.curve : a.t < b.t;
  });
  return inner;
}

// p_c: for a hole with bends the focus nearest to the usual place of those that c sees. What is at c and p_c is a part
// of the hole's turns, too.
Vec2 pole_of(const CadFace& face, const std::vector<HoleFocus>& foci, int loop, Vec2 apex, Vec2 tangent_out,
             double interior_angle) {
  const Vec2 usual = exterior_pole(face, apex, tangent_out, interior_angle);
  Vec2 pole = usual;
  double nearest = INFINITY;
  for (const HoleFocus& focus : foci) {
    const double away = distance(focus.position, apex), from_usual = distance(focus.position, usual);
    if (focus.loop != loop || !(from_usual < nearest)) continue;
    const Vec2 turn = (focus.position - apex) / away;
    const Vec2 side = wrap_two_pi(angle_of(turn) - angle_of(tangent_out)) > interior_angle ? turn : Vec2{};
    if (side == Vec2{} || away >= 1.9999 * distance(half_way(face, apex, turn), apex)) continue;
    pole = focus.position;
    nearest = from_usual;
  }
  return pole;
}

}  // namespace

void require_index_sum(const CadFace& face, const PhaseNodes& asked) {
  int inside = 0, corners = 0, boundary = 0;
  for (const PhaseNode& node : asked.nodes) inside += 4 - node.valence;
  for (const CornerValence& corner : asked.corners) corners += 2 - corner.valence;
  for (const BoundaryNode& node : asked.boundary_nodes) boundary += 2 - node.valence;
  const int sum = inside + corners + boundary, expected = 4 * face.euler_characteristic();
  if (sum == expected) return;
  throw ComputeError(
      fmt::format("the valences do not add up: sum (4 - V) over {} interior nodes is {}, sum (2 - V) over {} corners "
                  "is {}, over {} "
                  "boundary nodes {}; together {}, but a face with {} {} needs {}",
                  asked.nodes.size(), inside, asked.corners.size(), corners, asked.boundary_nodes.size(), boundary, sum,
                  face.num_loops() - 1, face.num_loops() == 2 ? "hole" : "holes", expected));
}

struct PhaseBoundary::Walk {
  double tangent_angle = 0;
  int corner_index = 0;
  std::vector<double> turn_angles;
};

PhaseBoundary::PhaseBoundary(const CadFace& face, const PhaseNodes& asked)
    : face_(&face), foci_(hole_foci(face)), pieces_(face.num_curves()) {
  require_index_sum(face, asked);
  make_apexes(asked);
  make_turns(asked);
  for (int loop = 0; loop < face.num_loops(); ++loop) walk_loop(loop);
}

void PhaseBoundary::make_apexes(const PhaseNodes& asked) {
  const std::vector<int> valences = joint_valences(*face_, asked);
  const std::vector<BoundaryNode> inner = inner_nodes(*face_, asked);
  auto next = inner.begin();
  for (int c = 0; c < face_->num_curves(); ++c) {
    const Nurbs &curve = face_->curves[c], &before = face_->curves[face_->previous_in_loop(c)];
    apex_offsets_.push_back(static_cast<int>(apexes_.size()));
    apexes_.push_back({c, curve.begin(), face_->joints[c].interior_angle, valences[c], -1, 0});
    make_corner_angle(apexes_.back(), curve::tangent(before, before.end(), true), curve::tangent(curve, curve.begin()));
    for (; next != inner.end() && next->curve == c; ++next) {
      if (next->t - apexes_.back().t <= same_place_tol * range_of(curve))
        throw ComputeError(fmt::format("two boundary nodes are at the same place of curve {}", c));
      apexes_.push_back({c, next->t, pi, next->valence, -1, 0});
      make_corner_angle(apexes_.back(), curve::tangent(curve, next->t, true), curve::tangent(curve, next->t));
    }
  }
  apex_offsets_.push_back(static_cast<int>(apexes_.size()));
}

// omega is taken from the very tangents that the data follow; the joint only tells which branch.
void PhaseBoundary::make_corner_angle(Apex& apex, Vec2 tangent_in, Vec2 tangent_out) {
  apex.angle = near(apex.angle, pi - (angle_of(tangent_out) - angle_of(tangent_in)));
  const double jump = 4 * apex.angle - 2 * pi * apex.valence;
  if (std::abs(jump) <= jump_tol) return;
  const Vec2 x = curve::point(face_->curves[apex.curve], apex.t);
  apex.term = static_cast<int>(terms_.corner_angles.size());
  terms_.corner_angles.push_back(
      {x, pole_of(*face_, foci_, face_->loop_of(apex.curve), x, tangent_out, apex.angle), jump / apex.angle});
}

void PhaseBoundary::make_turns(const PhaseNodes& asked) {
  for (const Vec2 x : hole_points(*face_)) terms_.holes.push_back({x, 4});
  for (const Apex& apex : apexes_) {
    const int loop = face_->loop_of(apex.curve);
    if (loop > 0) terms_.holes[loop - 1].turns += 2 - apex.valence;
  }
  for (const HoleFocus& focus : foci_) {
    PhaseTurn& hole = terms_.holes[focus.loop - 1];
    const int turns = std::clamp(focus.turns, 0, std::max(hole.turns, 0));
    hole.turns -= turns;
    terms_.images.push_back({focus.position, turns});
    image_loops_.push_back(focus.loop);
  }
  for (const PhaseNode& node : asked.nodes) {
    const int turns = 4 - node.valence;
    terms_.nodes.push_back({node.position, turns});
    for (const MirrorImage& image : mirror_images(*face_, node.position)) {
      terms_.images.push_back({image.position, turns});
      image_loops_.push_back(image.loop);
      if (image.loop > 0) centre_of_turns(image).turns -= turns;
    }
  }
}

// What an image's turns are taken from: of the hole's centre and foci the nearest.
PhaseTurn& PhaseBoundary::centre_of_turns(const MirrorImage& image) {
  PhaseTurn* nearest = &terms_.holes[image.loop - 1];
  for (std::size_t i = 0; i < foci_.size(); ++i) {
    if (foci_[i].loop != image.loop) continue;
    const bool is_nearer = distance(foci_[i].position, image.position) < distance(nearest->position, image.position);
    if (is_nearer) nearest = &terms_.images[i];
  }
  return *nearest;
}

const PhaseTurn& PhaseBoundary::turn(int i) const {
  const int num_nodes = static_cast<int>(terms_.nodes.size()), num_holes = static_cast<int>(terms_.holes.size());
  if (i < num_nodes) return terms_.nodes[i];
  return i < num_nodes + num_holes ? terms_.holes[i - num_nodes] : terms_.images[i - num_nodes - num_holes];
}

// How often a loop must wind round the place of turn i: the outline (counter-clockwise) once round all but what lies
// beyond it, a hole (clockwise) round what lies inside it.
int PhaseBoundary::winding(int i, int loop) const {
  const int num_nodes = static_cast<int>(terms_.nodes.size()), num_holes = static_cast<int>(terms_.holes.size());
  if (i < num_nodes) return loop == 0 ? 1 : 0;
  const int home = i < num_nodes + num_holes ? i - num_nodes + 1 : image_loops_[i - num_nodes - num_holes];
  if (loop == 0) return home == 0 ? 0 : 1;
  return home == loop ? -1 : 0;
}

void PhaseBoundary::walk_loop(int loop) {
  const int first = face_->loop_offsets[loop], last = face_->loop_offsets[loop + 1];
  const Vec2 x = curve::point(face_->curves[first], face_->curves[first].begin());
  Walk start;
  start.tangent_angle = angle_of(curve::tangent(face_->curves[first], face_->curves[first].begin()));
  for (int i = 0; i < num_turns(); ++i) start.turn_angles.push_back(angle_of(x - turn(i).position));

  Walk walk = start;
  for (int a = apex_offsets_[first]; a < apex_offsets_[last]; ++a) {
    if (a > apex_offsets_[first]) pass_apex(apexes_[a], walk);
    const int curve = apexes_[a].curve;
    const bool is_last = a + 1 == apex_offsets_[curve + 1];
    walk_curve(curve, apexes_[a].t, is_last ? face_->curves[curve].end() : apexes_[a + 1].t, walk);
  }
  pass_apex(apexes_[apex_offsets_[first]], walk);
  require_inside(loop, start, walk);
  require_closure(loop, start, walk);
}

// The change of g round the loop in whole turns: exact. The audit and D_j make it 0.
void PhaseBoundary::require_closure(int loop, const Walk& start, const Walk& end) const {
  int turns = 4 * round_to_turns(end.tangent_angle - start.tangent_angle) - end.corner_index;
  for (int i = 0; i < num_turns(); ++i)
    turns -= turn(i).turns * round_to_turns(end.turn_angles[i] - start.turn_angles[i]);
  if (turns != 0) throw Defect(fmt::format("phase data of loop {} do not close: {} turns", loop, turns));
}

// Sets g at the apex from its outgoing side, which must agree with the incoming one.
void PhaseBoundary::pass_apex(Apex& apex, Walk& walk) {
  const Nurbs& curve = face_->curves[apex.curve];
  const bool is_joint = apex.t == curve.begin();
  const Nurbs& before = is_joint ? face_->curves[face_->previous_in_loop(apex.curve)] : curve;
  const Vec2 x = curve::point(curve, apex.t), out = curve::tangent(curve, apex.t);
  const Vec2 in = curve::tangent(before, is_joint ? before.end() : apex.t, true);
  const auto g = [&](Vec2 inward) {
    double value = 4 * walk.tangent_angle - 2 * pi * walk.corner_index - corner_angles(x, apex.term, inward);
    for (int i = 0; i < num_turns(); ++i) value -= turn(i).turns * walk.turn_angles[i];
    return value;
  };
  const double incoming = g(-in);
  walk.tangent_angle = near(walk.tangent_angle + pi - apex.angle, angle_of(out));
  walk.corner_index += 2 - apex.valence;
  apex.remainder = g(out);
  if (std::abs(apex.remainder - incoming) > closure_tol)
    throw Defect(fmt::format("phase data jump by {} at joint {}", apex.remainder - incoming, apex.curve));
}

void PhaseBoundary::walk_curve(int curve, double t0, double t1, Walk& walk) {
  walk_piece(curve::trimmed(face_->curves[curve], t0, t1), curve, walk);
}

void PhaseBoundary::walk_piece(const Nurbs& piece, int curve, Walk& walk) {
  if (!is_monotone_piece(piece)) {
    const double middle = (piece.begin() + piece.end()) / 2;
    if (extent(piece) <= node_tol * face_->diameter || middle <= piece.begin() || middle >= piece.end()) refuse(piece);
    walk_piece(curve::trimmed(piece, piece.begin(), middle), curve, walk);
    walk_piece(curve::trimmed(piece, middle, piece.end()), curve, walk);
    return;
  }
  Piece p{piece.begin(), piece.end(), 0, walk.corner_index, {}};
  p.tangent_angle = near(walk.tangent_angle, angle_of(piece.poles.back() - piece.poles.front()));
  walk.tangent_angle = near(p.tangent_angle, angle_of(curve::tangent(piece, piece.end(), true)));
  for (int i = 0; i < num_turns(); ++i) {
    const Vec2 from = turn(i).position;
    p.turn_angles.push_back(near(walk.turn_angles[i], angle_of(middle_of_ends(piece) - from)));
    walk.turn_angles[i] = near(p.turn_angles[i], angle_of(piece.poles.back() - from));
  }
  pieces_[curve].push_back(std::move(p));
}

bool PhaseBoundary::is_monotone_piece(const Nurbs& piece) const {
  if (!tangents_are_near_chord(piece)) return false;
  for (int i = 0; i < num_turns(); ++i) {
    if (!is_seen_within_a_quarter_turn(piece, turn(i).position)) return false;
  }
  return true;
}

void PhaseBoundary::refuse(const Nurbs& piece) const {
  const Vec2 x = piece.poles.front() + face_->origin;
  if (!tangents_are_near_chord(piece))
    throw ComputeError(fmt::format("the boundary has a cusp near ({:.6g}, {:.6g})", x.x, x.y));
  throw ComputeError(
      fmt::format("the irregular node near ({:.6g}, {:.6g}) is on the boundary; it must be inside", x.x, x.y));
}

void PhaseBoundary::require_inside(int loop, const Walk& start, const Walk& end) const {
  for (int i = 0; i < num_turns(); ++i) {
    if (round_to_turns(end.turn_angles[i] - start.turn_angles[i]) == winding(i, loop)) continue;
    const Vec2 x = turn(i).position + face_->origin;
    if (i >= static_cast<int>(terms_.nodes.size()))
      throw Defect(fmt::format("({:.6g}, {:.6g}) was taken for a point outside the face", x.x, x.y));
    throw ComputeError(fmt::format("the irregular node at ({:.6g}, {:.6g}) is {}", x.x, x.y,
                                   loop == 0 ? "outside the face" : "in a hole"));
  }
}

double PhaseBoundary::corner_angles(Vec2 x, int apex_term, Vec2 inward) const {
  double sum = 0;
  for (std::size_t c = 0; c < terms_.corner_angles.size(); ++c) {
    const CornerAngle& corner = terms_.corner_angles[c];
    const bool at_apex = static_cast<int>(c) == apex_term;
    sum += corner.beta * corner_angle(corner, at_apex ? corner.apex : x, inward);
  }
  return sum;
}

std::vector<double> PhaseBoundary::interior_angles() const {
  std::vector<double> angles(terms_.corner_angles.size());
  for (const Apex& apex : apexes_) {
    if (apex.term >= 0) angles[apex.term] = apex.angle;
  }
  return angles;
}

const PhaseBoundary::Piece& PhaseBoundary::piece_at(int curve, double t, bool from_left) const {
  const std::vector<Piece>& pieces = pieces_[curve];
  const auto next = std::partition_point(pieces.begin(), pieces.end() - 1,
                                         [&](const Piece& p) { return from_left ? p.t1 < t : p.t1 <= t; });
  return *next;
}

const PhaseBoundary::Apex* PhaseBoundary::apex_at(int curve, double t) const {
  const Nurbs& nurbs = face_->curves[curve];
  const double tol = parameter_tol * range_of(nurbs);
  if (t >= nurbs.end() - tol) return &apexes_[apex_offsets_[face_->next_in_loop(curve)]];
  for (int a = apex_offsets_[curve]; a < apex_offsets_[curve + 1]; ++a) {
    if (std::abs(t - apexes_[a].t) <= tol) return &apexes_[a];
  }
  return nullptr;
}

double PhaseBoundary::phase(int curve, double t) const {
  const Nurbs& nurbs = face_->curves[curve];
  const bool from_left = t >= nurbs.end();
  const Piece& piece = piece_at(curve, t, from_left);
  return 4 * near(piece.tangent_angle, angle_of(curve::tangent(nurbs, t, from_left))) - 2 * pi * piece.corner_index;
}

double PhaseBoundary::remainder(int curve, double t) const {
  if (const Apex* apex = apex_at(curve, t)) return apex->remainder;
  const Vec2 x = curve::point(face_->curves[curve], t);
  const Piece& piece = piece_at(curve, t, false);
  double value = phase(curve, t) - corner_angles(x, -1, {});
  for (int i = 0; i < num_turns(); ++i) {
    const PhaseTurn& term = turn(i);
    if (term.turns != 0) value -= term.turns * near(piece.turn_angles[i], angle_of(x - term.position));
  }
  return value;
}

}  // namespace quadrille::field
