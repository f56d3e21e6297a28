#include "field/explicit_terms.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "field/corner_lifting.hpp"
#include "field/hole_foci.hpp"
#include "field/hole_points.hpp"
#include "field/mirror_images.hpp"

namespace quadrille::field {
namespace {

// Smaller jumps of the phase at corners are rounding of the tangents in the CAD file (see corner_lifting.cpp).
constexpr double jump_tol = 1e-10;

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

void add_corner_angles(const CadFace& face, const BoundaryApexes& apexes, const std::vector<HoleFocus>& foci,
                       ExplicitTerms& result) {
  for (const BoundaryApex& apex : apexes.apexes) {
    result.apex2corner_angle.push_back(-1);
    const double angle = apex.interior_angle, jump = 4 * angle - 2 * pi * apex.valence;
    if (std::abs(jump) <= jump_tol) continue;
    const Vec2 x = curve::point(face.curves[apex.curve], apex.t);
    const Vec2 pole = pole_of(face, foci, face.loop_of(apex.curve), x, tangents_at(face, apex).out, angle);
    result.apex2corner_angle.back() = static_cast<int>(result.terms.corner_angles.size());
    result.terms.corner_angles.push_back({x, pole, jump / angle});
  }
}

// Adds D_j, the turns that make the data of hole j single-valued, initially centred at one point of the hole.
void add_holes(const CadFace& face, const BoundaryApexes& apexes, ExplicitTerms& result) {
  std::vector<PhaseTurn>& holes = result.terms.holes;
  for (const Vec2 x : hole_points(face)) holes.push_back({x, 4});
  for (const BoundaryApex& apex : apexes.apexes) {
    const int loop = face.loop_of(apex.curve);
    if (loop > 0) holes[loop - 1].turns += 2 - apex.valence;
  }
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
std::vector<int> add_nodes_and_images(const CadFace& face, const std::vector<HoleFocus>& foci,
                                      const std::vector<PhaseNode>& nodes, PhaseTerms& terms) {
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
    for (const MirrorImage& image : mirror_images(face, node.position)) {
      terms.images.push_back({image.position, turns});
      image_loops.push_back(image.loop);
      if (image.loop > 0) nearest_centre(foci, image, terms).turns -= turns;
    }
  }
  return image_loops;
}

}  // namespace

ExplicitTerms explicit_terms(const CadFace& face, const BoundaryApexes& apexes, const std::vector<PhaseNode>& nodes) {
  const std::vector<HoleFocus> foci = hole_foci(face);
  ExplicitTerms result;
  PhaseTerms& terms = result.terms;
  add_corner_angles(face, apexes, foci, result);
  add_holes(face, apexes, result);
  const std::vector<int> image_loops = add_nodes_and_images(face, foci, nodes, terms);
  const auto add_centre = [&](const PhaseTurn& turn, int loop) {
    result.centres.push_back({turn.position, turn.turns, loop});
  };
  for (const PhaseTurn& node : terms.nodes) add_centre(node, -1);
  for (std::size_t j = 0; j < terms.holes.size(); ++j) add_centre(terms.holes[j], static_cast<int>(j) + 1);
  for (std::size_t i = 0; i < terms.images.size(); ++i) add_centre(terms.images[i], image_loops[i]);
  return result;
}

}  // namespace quadrille::field
