#include "adapt/sensor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/error.hpp"
#include "field/error_estimate.hpp"

namespace quadrille::adapt {

namespace {

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

std::vector<std::vector<double>> degree_sensors(const Field& field, SensorKind kind, SensorScale scale) {
  const bool is_absolute = scale == SensorScale::absolute;
  const bool is_phase = field.kind == FieldKind::phase;
  const double least_norm = is_absolute ? 2 : std::numeric_limits<double>::min();  // 2: |1|^2, reference triangle
  const std::vector<double> weights =
      is_absolute ? fan_weights(field.mesh) : std::vector<double>(field.mesh.num_elems(), 1.0);
  std::vector<std::vector<double>> sensors(field.mesh.num_elems());
  for (int e = 0; e < field.mesh.num_elems(); ++e) {
    std::vector<double>& norms = sensors[e];
    norms.assign(field.elem_order[e] + 1, 0.0);
    for (const auto* component : {&field.u, &field.v, &field.phase.s}) {
      if (component->empty()) continue;
      if (kind == SensorKind::u && component == &field.v) continue;
      if (kind == SensorKind::v && component == &field.u) continue;
      field::add_squared_norms(&(*component)[field.coef_offsets[e]], norms);
    }
    // The norm of s is no reference scale: hole winding makes it large, and adding 2 pi to s does not change the field.
    const double all = std::accumulate(norms.begin(), norms.end(), 0.0);
    const double reference = is_phase && is_absolute ? least_norm : std::max(all, least_norm);
    for (double& norm : norms) norm *= weights[e] / reference;
  }
  return sensors;
}

std::vector<double> element_sensors(const Field& field, SensorKind kind, SensorScale scale) {
  std::vector<double> last;
  for (const std::vector<double>& sensors : degree_sensors(field, kind, scale)) last.push_back(sensors.back());
  return last;
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
