#pragma once
// The part of the explicit terms (model/phase_nodes.hpp) that does not depend on the irregular nodes inside the domain:
// apexes, corner angles, and the turns about the holes. One object serves all sets of nodes with the same valences on
// the boundary.

#include <map>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "field/boundary_apexes.hpp"
#include "field/hole_foci.hpp"
#include "field/mirror_images.hpp"
#include "model/cad_face.hpp"
#include "model/phase_nodes.hpp"

namespace quadrille::field {

struct CornerTerms {
  BoundaryApexes apexes;
  std::vector<HoleFocus> foci;
  std::vector<CornerAngle> corner_angles;
  std::vector<int> apex2corner_angle;  ///< position in corner_angles; -1 if the data do not jump at the apex
  std::vector<PhaseTurn> holes;        ///< h_j and the turns D_j that make the data of hole j single-valued
};

/// Throws as boundary_apexes().
CornerTerms corner_terms(const CadFace& face, const PhaseNodes& prescribed);

/// The sum of beta_c theta_c at x. If x is the apex of corner angle `at_apex` (-1: x is no such apex), its limit along
/// the unit vector `inward`.
double sum_of_corner_angles(const std::vector<CornerAngle>& corner_angles, Vec2 x, int at_apex, Vec2 inward);

/// What the data at parameters `t` of a curve need that does not depend on the nodes inside the domain.
struct BoundarySamples {
  std::vector<double> t;
  std::vector<int> apexes;             ///< the apex at the point; -1: none
  std::vector<Vec2> x;                 ///< the points
  std::vector<double> tangent_angles;  ///< on the side of rising t, principal values
  std::vector<double> corner_angles;   ///< the sums of beta_c theta_c; 0 at apexes
};

/// Corner terms, the samples of the boundary asked for so far, and the images of nodes. Not to be used by two threads
/// at once.
class SharedCorners {
 public:
  /// Throws as corner_terms(). `face` must outlive this object.
  SharedCorners(const CadFace& face, const PhaseNodes& prescribed);
  /// Whether `prescribed` has the valences on the boundary for which this was made.
  bool fit(const PhaseNodes& prescribed) const;
  const CornerTerms& terms() const { return terms_; }
  /// Whether the loop runs along slits only (CadFace::is_slit_loop).
  bool is_slit(int loop) const { return face_->is_slit_loop(loop); }
  /// Valid until the next call. `t` is not empty.
  const BoundarySamples& samples(int curve, std::span<const double> t);
  /// The mirror images of a node at x.
  const std::vector<MirrorImage>& images(Vec2 x);

 private:
  std::vector<CornerValence> corners_;
  std::vector<BoundaryNode> boundary_nodes_;
  const CadFace* face_;
  MirrorImages mirror_images_;
  CornerTerms terms_;
  std::vector<std::unordered_map<double, BoundarySamples>> samples_;  ///< by curve, then first parameter
  std::map<std::pair<double, double>, std::vector<MirrorImage>> images_;
};

}  // namespace quadrille::field
