#pragma once
// Options of the adaptation, sensors, and how one round changes the order of an element: the decision table of
// Algorithm 1, and the prediction from the decay of its modes.
//
// The error indicator is S_e = |v_P - v_{P-1}|^2 / |v_P|^2 of an element, as in the paper (Persson and Peraire 2006).
//
// The projection onto order P - 1 drops the modes of degree P: the basis is orthonormal and sorted by degree. Norms are
// taken over the reference triangle, whose area 2 replaces |Omega_e|. The denominator is at least the squared norm of a
// field with |v| = 1 on the element: since |v| <= 1 everywhere, the scale is absolute and 0/0 cannot occur. Only the
// polynomial part enters: liftings are exact. A field of kind "phase" has one component, s, whichever component is
// selected; its scale is 1 radian, because |v - v_h| = |s - s_h| to first order.

#include <array>
#include <vector>

#include "base/enum_names.hpp"
#include "model/field.hpp"

namespace quadrille::adapt {

/// The components that enter the sensor.
enum class SensorKind { vector, u, v };
constexpr auto enum_names(SensorKind) { return std::to_array({"vector", "u", "v"}); }

/// The reference scale of the tail.
enum class SensorScale {
  absolute,  ///< as above; elements of a corner fan are weighted by fan_weights(), as is their effect on the far field:
             ///< otherwise the sensor near a singularity would never decrease
  relative   ///< as in the paper: norm of the selected components on the element, no weights; 0/0 counts as 0
};

constexpr auto enum_names(SensorScale) { return std::to_array({"absolute", "relative"}); }

/// For every element and each degree d = 0 .. P: the S_e that the modes of degree d give.
std::vector<std::vector<double>> degree_sensors(const Field& field, SensorKind kind, SensorScale scale);

/// S_e of every element, by element number: that of its highest degree.
std::vector<double> element_sensors(const Field& field, SensorKind kind, SensorScale scale = SensorScale::absolute);

/// The weights of squared errors in the sensor: 1 outside fans, in fans the element's area divided by the largest
/// element area.
std::vector<double> fan_weights(const TriMesh& mesh);

/// Replaces sensors that differ by less than 5 % by the greatest of them, so that a threshold treats the elements of a
/// symmetry orbit alike, independently of rounding errors.
std::vector<double> equalized(std::vector<double> sensors);

/// How orders follow from the sensors.
enum class AdaptPolicy {
  predict,  ///< to the order that the decay of the modes predicts; later rounds only raise
  paper     ///< by one in each round: Algorithm 1 of the paper
};
constexpr auto enum_names(AdaptPolicy) { return std::to_array({"predict", "paper"}); }

struct AdaptOptions {
  AdaptPolicy policy = AdaptPolicy::predict;
  double raise_above = 1e-16;         ///< epsilon_u on the squared sensor S_e
  double lower_below = 1e-22;         ///< epsilon_l, below raise_above
  int num_threads = 1;                ///< the result does not depend on it
  int min_order = 2, max_order = 20;  ///< at most max_field_order of the field's method
  int max_steps = 20;                 ///< greatest number of new solutions; reaching it causes a warning
  double target_error = 1e-8;         ///< on |v - v_h|; elements at max_order that miss it cause a warning
  SensorKind sensor = SensorKind::vector;
  SensorScale scale = SensorScale::absolute;
  void validate() const;  ///< throws UsageError
};

enum class OrderChange { lower = -1, keep = 0, raise = 1 };

/// Raise when the sensor exceeds raise_above and the order is below max_order; lower when it is below lower_below, the
/// order is above min_order and the element has never been raised, so that no order oscillates.
OrderChange decide(double sensor, int order, bool was_raised, const AdaptOptions& options);

/// Whether no sensor of an element exceeds the limit, or at most one of 1000, each at most tenfold: a field is not
/// worth another solution of all elements for these, and the error estimate contains what they leave.
bool is_good_enough(const std::vector<double>& sensors, double limit);

/// The order, not rounded, at which the sensor of an element reaches `target`: where its modes already do, interpolated
/// between two degrees; else extrapolated at `trusted_rate` times the rate at which they decay over the last degrees,
/// times the ratio of that rate to the one before: the decay of smooth fields accelerates, that of rough ones slows
/// down. `sensors`: by degree (degree_sensors). The maximum over all higher degrees stands for each degree, because by
/// symmetry every other degree may vanish; so the highest degree, which may vanish, is extrapolated too but never
/// lowers the result: where the decay slows down at that degree, it is the only sign of it.
double predicted_order(const std::vector<double>& sensors, double target, double trusted_rate);

}  // namespace quadrille::adapt
