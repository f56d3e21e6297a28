#include "adapt/order_policy.hpp"

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

struct DecayConstants {
  int measured_degrees = 3;
  double least_change = 0.7, greatest_change = 1.4;  // of the rate, expected from its change so far
  double slowest = 0.2, fastest = 8;                 // decay of the squared sensor by degree, natural logarithm
};
constexpr DecayConstants decay_constants;

// Minus the slope of the line of least squares through the values.
double decay(const double* values, int count) {
  const double middle = (count - 1) / 2.0;
  double products = 0, squares = 0;
  for (int i = 0; i < count; ++i) {
    products += (i - middle) * values[i];
    squares += (i - middle) * (i - middle);
  }
  return squares > 0 ? -products / squares : 0;
}

// A solution is kept although sensors exceed their limit, if they are those of at most one element of so many and
// exceed it by at most this factor, of a squared norm.
constexpr std::size_t elements_per_excess = 1000;
constexpr double greatest_excess = 10;

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

bool is_good_enough(const std::vector<double>& sensors, double limit) {
  const auto exceeds = [&](double sensor) { return sensor > limit; };
  const auto num_above = static_cast<std::size_t>(std::count_if(sensors.begin(), sensors.end(), exceeds));
  const auto exceeds_far = [&](double sensor) { return sensor > greatest_excess * limit; };
  return num_above * elements_per_excess <= sensors.size() && std::none_of(sensors.begin(), sensors.end(), exceeds_far);
}

OrderChange decide(double sensor, int order, bool was_raised, const AdaptOptions& options) {
  if (sensor > options.raise_above) return order < options.max_order ? OrderChange::raise : OrderChange::keep;
  if (sensor < options.lower_below && order > options.min_order && !was_raised) return OrderChange::lower;
  return OrderChange::keep;
}

double predicted_order(const std::vector<double>& sensors, double target, double trusted_rate) {
  const int order = static_cast<int>(sensors.size()) - 1;
  std::vector<double> logs(sensors.size());  // of the sensor over the target, at most those of lower degrees
  double greatest = std::numeric_limits<double>::min();
  for (int d = order; d >= 0; --d) {
    greatest = std::max(greatest, sensors[d] / target);
    logs[d] = std::log(greatest);
  }
  const int last = std::max(order - 1, 0);  // what follows the highest degree is not known
  if (logs[last] <= 0) {
    int d = last;
    while (d > 0 && logs[d - 1] <= 0) --d;
    return d == 0 ? 0 : d - 1 + logs[d - 1] / (logs[d - 1] - logs[d]);
  }
  const int before_last = decay_constants.measured_degrees - 1;
  const int middle = std::max(last - before_last, 0), first = std::max(middle - before_last, 0);
  const double now = decay(&logs[middle], last - middle + 1), before = decay(&logs[first], middle - first + 1);
  const double change =
      before > 0 ? std::clamp(now / before, decay_constants.least_change, decay_constants.greatest_change) : 1;
  const double rate = std::clamp(trusted_rate * change * now, decay_constants.slowest, decay_constants.fastest);
  const double predicted = last + logs[last] / rate;
  return logs[order] > 0 ? std::max({predicted, order + logs[order] / rate, order + 0.01}) : predicted;
}

}  // namespace quadrille::adapt
