#include "field/explicit_terms.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"

namespace quadrille::field {
namespace {

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
  Vec2 low{INFINITY, INFINITY}, high = -low;
  const auto for_each_pole = [&](const auto& use) {
    for (int c = face.loop_offsets[loop]; c < face.loop_offsets[loop + 1]; ++c)
      for (const Vec2 pole : face.curves[c].poles) use(pole);
  };
  for_each_pole([&](Vec2 pole) {
    low = {std::min(low.x, pole.x), std::min(low.y, pole.y)};
    high = {std::max(high.x, pole.x), std::max(high.y, pole.y)};
  });
  const Vec2 middle = (low + high) / 2;
  double radius = 0;
  for_each_pole([&](Vec2 pole) { radius = std::max(radius, distance(pole, middle)); });
  return {middle, radius};
}

}  // namespace

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
  const auto add_centre = [&](const PhaseTurn& turn, int loop) {
    result.centres.push_back({turn.position, turn.turns, loop});
  };
  for (const PhaseTurn& node : terms.nodes) add_centre(node, -1);
  // Slits have no turns and no centre.
  for (std::size_t j = 0; j < terms.holes.size(); ++j)
    if (!corners.is_slit(static_cast<int>(j) + 1)) add_centre(terms.holes[j], static_cast<int>(j) + 1);
  for (std::size_t i = 0; i < terms.images.size(); ++i) add_centre(terms.images[i], image_loops[i]);
  return result;
}

}  // namespace quadrille::field
