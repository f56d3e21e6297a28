#include "layers/column.hpp"

#include <algorithm>
#include <cmath>

#include "spectral/quadrature.hpp"

namespace quadrille::layers {
namespace {

constexpr int max_steps = 60;
/// Heights are met to this share of themselves.
constexpr double height_tol = 1e-11;

/// A parameter and the height there.
struct Mark {
  double u = 0, height = 0;
};

class HeightSearch {
 public:
  HeightSearch(const ColumnCurve& curve, const WallLine& wall, WallFoot foot)
      : curve_(curve), wall_(wall), foot_(foot) {}

  /// The next parameter, from that of the last height; -1 where there is none.
  double next(double height) {
    Mark low = last_, high;
    double step = last_.u > 0 ? 1.1 * (height - last_.height) * rate_ : first_step(height);
    for (;; step *= 1.5) {
      high = mark(std::min(1.0, low.u + step));
      if (high.height >= height) break;
      if (high.u >= 1 || high.height < low.height) return -1;
      low = high;
    }
    const Mark found = between(low, high, height);
    rate_ = (found.u - last_.u) / (found.height - last_.height);
    return (last_ = found).u;
  }

 private:
  Mark mark(double u) { return {u, wall_.distance(curve_(u), foot_)}; }

  double first_step(double height) const {
    const double probe = 1e-4, speed = distance(curve_(probe), curve_(0)) / probe;
    return speed > 0 ? std::min(1.0, 1.1 * height / speed) : probe;
  }

  /// Regula falsi, with the weight of an end that stays halved (Illinois).
  Mark between(Mark low, Mark high, double height) {
    double a = low.height - height, b = high.height - height;
    Mark best = high;
    for (int step = 0; step < max_steps && std::abs(best.height - height) > height_tol * height; ++step) {
      const Mark trial = mark(high.u - b * (high.u - low.u) / (b - a));
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

  const ColumnCurve& curve_;
  const WallLine& wall_;
  WallFoot foot_;
  Mark last_;
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

std::vector<double> parameters_at_heights(const ColumnCurve& curve, const WallLine& wall, WallFoot foot,
                                          const std::vector<double>& heights) {
  HeightSearch search(curve, wall, foot);
  std::vector<double> parameters;
  for (const double height : heights) {
    const double u = search.next(height);
    if (u < 0) break;
    parameters.push_back(u);
  }
  return parameters;
}

}  // namespace quadrille::layers
