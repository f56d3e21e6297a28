#include "layers/normal_line.hpp"

#include <algorithm>
#include <cmath>

#include "spectral/quadrature.hpp"

namespace quadrille::layers {
namespace {

constexpr int max_steps = 60;
/// Relative accuracy of the heights.
constexpr double height_tol = 1e-11;

/// A parameter of the line and the height there.
struct LineSample {
  double u = 0, height = 0;
};

class HeightSearch {
 public:
  HeightSearch(const NormalLine& line, const WallLine& wall, WallPoint foot) : line_(line), wall_(wall), foot_(foot) {}

  /// The first parameter, beyond the parameter of the last height, at which this height is reached; -1 if there is
  /// none.
  double next(double height) {
    LineSample low = last_, high;
    double step = last_.u > 0 ? 1.1 * (height - last_.height) * rate_ : first_step(height);
    for (;; step *= 1.5) {
      high = sample(std::min(1.0, low.u + step));
      if (high.height >= height) break;
      if (high.u >= 1 || high.height < low.height) return -1;
      low = high;
    }
    const LineSample found = between(low, high, height);
    rate_ = (found.u - last_.u) / (found.height - last_.height);
    return (last_ = found).u;
  }

 private:
  LineSample sample(double u) { return {u, wall_.distance(line_(u), foot_)}; }

  double first_step(double height) const {
    const double probe = 1e-4, speed = distance(line_(probe), line_(0)) / probe;
    return speed > 0 ? std::min(1.0, 1.1 * height / speed) : probe;
  }

  /// The Illinois algorithm: regula falsi that halves the weight of an end that stays.
  LineSample between(LineSample low, LineSample high, double height) {
    double a = low.height - height, b = high.height - height;
    LineSample best = high;
    for (int step = 0; step < max_steps && std::abs(best.height - height) > height_tol * height; ++step) {
      const LineSample trial = sample(high.u - b * (high.u - low.u) / (b - a));
      const double miss = trial.height - height;
      if (miss < 0) {
        low = trial, a = miss;
        if (best.height < height) b /= 2;
      } else {
        high = trial, b = miss;
        if (best.height >= height && step > 0) a /= 2;
      }
      best = trial;
      if (high.u - low.u <= 1e-15) break;
    }
    return best;
  }

  const NormalLine& line_;
  const WallLine& wall_;
  WallPoint foot_;
  LineSample last_;
  double rate_ = 0;  ///< of u by the height, at the last one
};

}  // namespace

std::vector<double> node_heights(const std::vector<double>& layer_heights, int order) {
  const std::vector<double>& gll = spectral::gll_points(order);
  std::vector<double> heights;
  double low = 0;
  for (const double high : layer_heights) {
    for (int i = 1; i < order; ++i) heights.push_back(low * (1 - gll[i]) / 2 + high * (1 + gll[i]) / 2);
    heights.push_back(low = high);
  }
  return heights;
}

double height_of_end(const NormalLine& line, const WallLine& wall, WallPoint foot) {
  constexpr int steps = 16;
  double height = 0;
  for (int k = 1; k <= steps; ++k) height = wall.distance(line(static_cast<double>(k) / steps), foot);
  return height;
}

std::vector<double> parameters_at_heights(const NormalLine& line, const WallLine& wall, WallPoint foot,
                                          const std::vector<double>& heights) {
  HeightSearch search(line, wall, foot);
  std::vector<double> parameters;
  for (const double height : heights) {
    const double u = search.next(height);
    if (u < 0) break;
    parameters.push_back(u);
  }
  return parameters;
}

}  // namespace quadrille::layers
