#include "adapt/order_policy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille::adapt {
namespace {

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
