#include "adapt/sensor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/error.hpp"
#include "spectral/orthogonal_basis.hpp"

namespace quadrille::adapt {

namespace {

struct Norms {
  double tail = 0, all = 0;
};

Norms squared_norms(const double* coefs, int order) {
  Norms norms;
  const int first_of_tail = spectral::num_tri_modes(order - 1), n = spectral::num_tri_modes(order);
  for (int i = 0; i < n; ++i) {
    norms.all += coefs[i] * coefs[i];
    if (i >= first_of_tail) norms.tail += coefs[i] * coefs[i];
  }
  return norms;
}

double area(const TriMesh& mesh, int elem) {
  const auto& [a, b, c] = mesh.elem2vertices[elem];
  return cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]) / 2;
}

}  // namespace

std::vector<double> fan_weights(const TriMesh& mesh) {
  std::vector<double> weights(mesh.num_elems(), 1.0);
  double greatest = 0;
  for (int e = 0; e < mesh.num_elems(); ++e) greatest = std::max(greatest, area(mesh, e));
  for (int e = 0; e < mesh.num_elems(); ++e) {
    if (mesh.elem_layer[e] >= 0) weights[e] = area(mesh, e) / greatest;
  }
  return weights;
}

std::vector<double> element_sensors(const Field& field, SensorKind kind, SensorScale scale) {
  const bool is_absolute = scale == SensorScale::absolute;
  const bool is_phase = field.kind == FieldKind::phase;
  const double least_norm = is_absolute ? 2 : std::numeric_limits<double>::min();  // 2: |1|^2, reference triangle
  std::vector<double> sensors =
      is_absolute ? fan_weights(field.mesh) : std::vector<double>(field.mesh.num_elems(), 1.0);
  for (int e = 0; e < field.mesh.num_elems(); ++e) {
    const int order = field.elem_order[e], offset = field.coef_offsets[e];
    Norms norms;
    for (const auto* component : {&field.u, &field.v, &field.phase.s}) {
      if (component->empty()) continue;
      if (kind == SensorKind::u && component == &field.v) continue;
      if (kind == SensorKind::v && component == &field.u) continue;
      const Norms part = squared_norms(&(*component)[offset], order);
      norms.tail += part.tail;
      norms.all += part.all;
    }
    // The norm of s is no reference scale: hole winding makes it large, and adding 2 pi to s does not change the field.
    sensors[e] *= norms.tail / (is_phase && is_absolute ? least_norm : std::max(norms.all, least_norm));
  }
  return sensors;
}

std::vector<double> equalized(std::vector<double> sensors) {
  constexpr double same = 0.95;
  std::vector<int> ranking(sensors.size());
  std::iota(ranking.begin(), ranking.end(), 0);
  std::stable_sort(ranking.begin(), ranking.end(), [&](int a, int b) { return sensors[a] > sensors[b]; });
  double greatest = INFINITY;
  for (const int e : ranking) {
    if (sensors[e] < same * greatest) greatest = sensors[e];
    sensors[e] = greatest;
  }
  return sensors;
}

}  // namespace quadrille::adapt
