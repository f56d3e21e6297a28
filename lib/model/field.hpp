#pragma once
// The guiding field v = (u, v) as solved on a triangle mesh (formats/field.md).
//
//   v(x) = sum_n c_n phi_n(xi) + sum_c lifting_c.jump * theta_c(x)
//
// phi_n: the orthonormal Dubiner basis of the reference triangle (spectral/orthogonal_basis), degree P_e on element e,
// sorted by total degree, so that the highest order is the tail. theta_c: phase-field.md point 4,
// theta_c = Arg((z - c) / (z - p_c)), principal value, p_c outside the domain; its cut is the segment [c, p_c].

#include <string>
#include <vector>

#include "base/vec2.hpp"
#include "model/provenance.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille {

/// One exact harmonic lifting for a tangent jump: value(x) = jump * theta_c(x).
struct Lifting {
  int joint = 0;  ///< index into face.joints
  Vec2 apex;      ///< c, the joint's position
  Vec2 pole;      ///< p_c, outside the domain
  Vec2 jump;      ///< field value per radian of theta_c
};

/// One round of p-adaptation.
struct AdaptStep {
  int num_unknowns = 0;
  int num_raised = 0, num_lowered = 0;
  int min_order = 0, max_order = 0;
  double max_sensor = 0;
  std::vector<int> elem_order;  ///< of the solution that the round began with
  std::vector<double> elem_sensor;
};

struct Field {
  Provenance provenance;
  TriMesh mesh;
  std::string kind = "harmonic";  ///< "harmonic"; a later version adds "phase"
  std::string method = "cg";
  std::vector<int> elem_order;    ///< P_e
  std::vector<int> coef_offsets;  ///< element e owns coefficients [coef_offsets[e], coef_offsets[e+1])
  std::vector<double> u, v;       ///< coefficients c_n of both components
  std::vector<Lifting> liftings;
  std::vector<double> elem_sensor;  ///< last sensor of each element; empty before padapt
  std::vector<double> elem_error;  ///< estimated |v - v_h| on each element (field/error_estimate); empty: not estimated
  std::vector<AdaptStep> adapt_steps;
};

}  // namespace quadrille
