#include "field/boundary_misfit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

#include "base/angle.hpp"
#include "curve/arc_length.hpp"
#include "curve/nurbs.hpp"
#include "field/boundary_values.hpp"
#include "field/lifting.hpp"
#include "field/phase_boundary.hpp"
#include "field/phase_value.hpp"
#include "mesh/tri_maps.hpp"
#include "spectral/orthogonal_basis.hpp"

namespace quadrille::field {

namespace {

constexpr std::array fractions{0.1, 0.37, 0.63, 0.9};

struct EdgePoint {
  double t;
  Vec2 xi;
  double phase_data;  ///< of a phase: its boundary data without the hole winding
};

/// `phase`: null for a harmonic field.
std::array<EdgePoint, fractions.size()> edge_points(const BoundaryEdge& edge, const curve::ArcLength& length,
                                                    const PhaseBoundary* phase) {
  const double begin = length.at(edge.t0), whole = length.at(edge.t1) - begin;
  std::array<double, fractions.size()> t{}, data{};
  for (std::size_t i = 0; i < t.size(); ++i) t[i] = length.parameter(begin + fractions[i] * whole);
  if (phase) phase->remainders(edge.curve, t, data.data());
  std::array<EdgePoint, fractions.size()> points;
  for (std::size_t i = 0; i < t.size(); ++i)
    points[i] = {t[i], spectral::tri_edge_point(edge.edge, fractions[i]), data[i]};
  return points;
}

double misfit_at(const Field& field, const BoundaryValues& values, const spectral::TriMap& map,
                 const BoundaryEdge& edge, const EdgePoint& at) {
  const CadFace& face = field.mesh.face;
  const int offset = field.coef_offsets[edge.elem];
  Vec2 x_h;
  Mat2 dx_dxi, dv_dxi;
  map.evaluate(at.xi, x_h, dx_dxi);
  const Vec2 value =
      spectral::orthogonal_sum(field.elem_order[edge.elem], &field.u[offset], &field.v[offset], at.xi, dv_dxi);
  const Vec2 data = values(edge.curve, at.t);
  const Nurbs& curve = face.curves[edge.curve];
  const Vec2 across = left_of(curve::tangent(curve, at.t));
  Vec2 slope = (dv_dxi * inverse(dx_dxi)) * across;
  for (const Lifting& lifting : field.liftings) slope += lifting.jump * dot(lifting_gradient(lifting, x_h), across);
  return distance(value, data) + norm(slope) * std::abs(dot(x_h - curve::point(curve, at.t), across));
}

// |phi_h - Phi| of a phase, radians; equal to |v - v_h| to first order, because v is a unit vector.
double phase_misfit_at(const Field& field, const spectral::TriMap& map, const BoundaryEdge& edge, const EdgePoint& at) {
  const CadFace& face = field.mesh.face;
  const double* s = &field.phase.s[field.coef_offsets[edge.elem]];
  Vec2 x_h;
  Mat2 dx_dxi, ds_dxi;
  map.evaluate(at.xi, x_h, dx_dxi);
  const double value = spectral::orthogonal_sum(field.elem_order[edge.elem], s, s, at.xi, ds_dxi).x;
  const int loop = face.loop_of(edge.curve);
  const double data = at.phase_data + (loop > 0 ? 2 * pi * field.phase.hole_winding[loop - 1] : 0);
  const Mat2 ds_dx = ds_dxi * inverse(dx_dxi);
  const Vec2 slope = Vec2{ds_dx.xx, ds_dx.xy} + explicit_phase_gradient(field.phase.terms, x_h);
  const Nurbs& curve = face.curves[edge.curve];
  const Vec2 across = left_of(curve::tangent(curve, at.t));
  return std::abs(value - data) + std::abs(dot(slope, across) * dot(x_h - curve::point(curve, at.t), across));
}

}  // namespace

std::vector<double> boundary_misfit(const Field& field, const PhaseBoundary* phase) {
  const TriMesh& mesh = field.mesh;
  const std::vector<spectral::TriMap> maps = mesh::tri_maps(mesh);
  std::vector<curve::ArcLength> lengths;
  lengths.reserve(mesh.face.curves.size());
  for (const Nurbs& curve : mesh.face.curves) lengths.emplace_back(curve);
  std::optional<PhaseBoundary> made;
  if (field.kind == FieldKind::phase && !phase)
    phase =
        &made.emplace(mesh, field.phase.prescribed, std::make_shared<SharedCorners>(mesh.face, field.phase.prescribed));
  const BoundaryValues values(mesh, field.liftings);
  std::vector<double> misfits(mesh.num_elems(), 0.0);
  for (const BoundaryEdge& edge : mesh.boundary_edges) {
    const spectral::TriMap& map = maps[edge.elem];
    for (const EdgePoint& at : edge_points(edge, lengths[edge.curve], phase)) {
      const double misfit = phase ? phase_misfit_at(field, map, edge, at) : misfit_at(field, values, map, edge, at);
      misfits[edge.elem] = std::max(misfits[edge.elem], misfit);
    }
  }
  return misfits;
}

}  // namespace quadrille::field
