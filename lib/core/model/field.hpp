#pragma once
// The guiding field v = (u, v) as solved on a triangle mesh (formats/field.md).
//
//   v(x) = sum_n c_n phi_n(xi) + sum_c lifting_c.jump * theta_c(x)
//
// phi_n: the orthonormal Dubiner basis of the reference triangle (spectral/orthogonal_basis), degree P_e on element e,
// sorted by total degree, so that the highest order is the tail. theta_c: lib/method.md §8.4,
// theta_c = Arg((z - c) / (z - p_c)), principal value, p_c outside the domain; its cut is the segment [c, p_c].
//
// A field of kind "phase" (lib/method.md §8) is a unit field with exactly the prescribed irregular nodes:
//
//   v(x) = e^(i phi),   phi(x) = explicit part (model/phase_nodes.hpp) + s(x),   s(x) = sum_n s_n phi_n(xi)
//
// Both are harmonic, v and s, unless the field is aligned with prescribed directions (model/alignment.hpp).

#include <array>
#include <vector>

#include "base/enum_names.hpp"
#include "base/vec2.hpp"
#include "model/alignment.hpp"
#include "model/phase_nodes.hpp"
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
  std::vector<int> elem_order;  ///< of the solution at the start of the round
  std::vector<double> elem_sensor;
};

/// Data of a field of kind "phase", instead of u, v and liftings.
struct PhaseForm {
  PhaseNodes prescribed;
  PhaseTerms terms;
  std::vector<double> s;                  ///< coefficients, as u and v
  std::vector<int> hole_winding_offsets;  ///< as prescribed, one per hole; may be empty
  /// The boundary data of hole j are determined up to 2 pi m_j. The m_j are counted from the branch of the data
  /// (field/phase_boundary.hpp), so only differences have a meaning: the real m* = -K^-1 r / (2 pi) of least energy and
  /// the integers that were chosen.
  std::vector<double> best_hole_winding;
  std::vector<int> hole_winding;
  /// Period of lambda round each hole, (r + 2 pi K m)_j / 4: if it is not 0 the conformal map is only local.
  std::vector<double> hole_periods;
  double hole_winding_energy = 0;  ///< 2 pi^2 (m - m*)^T K (m - m*): energy of the integer winding above the real one
};

/// Meaning of the coefficients: u and v of a harmonic field, or s of the phase of a unit field.
enum class FieldKind { harmonic, phase };
constexpr auto enum_names(FieldKind) { return std::to_array({"harmonic", "phase"}); }

/// How the field was discretised: continuous Galerkin, or hybridised discontinuous Galerkin.
enum class FieldMethod { cg, dg };
constexpr auto enum_names(FieldMethod) { return std::to_array({"cg", "dg"}); }

/// A prescribed polynomial order for every element (formats/order-map.md).
struct OrderMap {
  std::vector<int> elem_order;     ///< one for each element, in the order of the mesh
  bool of_harmonic_field = false;  ///< those of a field of kind "harmonic"
};

struct Field {
  Provenance provenance;
  TriMesh mesh;
  FieldKind kind = FieldKind::harmonic;
  FieldMethod method = FieldMethod::cg;
  std::vector<int> elem_order;    ///< P_e
  std::vector<int> coef_offsets;  ///< element e has the coefficients [coef_offsets[e], coef_offsets[e+1])
  std::vector<double> u, v;       ///< coefficients c_n of both components
  std::vector<Lifting> liftings;
  PhaseForm phase;                       ///< of kind "phase"; u, v and liftings are then empty
  std::vector<PhaseForm> region_phases;  ///< of kind "phase" on several regions: one each, instead of `phase`
  std::vector<double> elem_sensor;       ///< last sensor of each element; empty before padapt
  std::vector<double> elem_error;  ///< estimated |v - v_h| on each element (field/error_estimate); empty: not estimated
  std::vector<AdaptStep> adapt_steps;
  Alignment alignment;  ///< with which v, or the phase, was solved for; empty: none
};

}  // namespace quadrille
