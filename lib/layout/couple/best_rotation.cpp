#include "couple/best_rotation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/angle.hpp"

namespace quadrille::couple {
namespace {

constexpr double tie = 1e-6;  // of angles, and of sums of squares beside 1

/// How far the own ends, rotated by an angle, are from the others.
struct Offsets {
  double mean = 0, squares = 0;
};

Offsets offsets(const std::vector<EndAngles>& loops, double angle) {
  Offsets result;
  int count = 0;
  for (const EndAngles& loop : loops) {
    if (loop.others.empty()) continue;
    for (const double own : loop.own) {
      double least = std::numeric_limits<double>::infinity();
      for (const double other : loop.others)
        if (const double d = wrap_pi(other - own - angle); std::abs(d) < std::abs(least)) least = d;
      result.mean += least, result.squares += least * least, ++count;
    }
  }
  if (count > 0) result.mean /= count;
  return result;
}

bool is_among(const std::vector<double>& angles, double angle) {
  return std::any_of(angles.begin(), angles.end(), [&](double a) { return std::abs(wrap_pi(a - angle)) <= tie; });
}

// Whether a rotation by this angle maps the own ends onto themselves.
bool is_symmetry(const std::vector<EndAngles>& loops, double angle) {
  return std::all_of(loops.begin(), loops.end(), [&](const EndAngles& loop) {
    return std::all_of(loop.own.begin(), loop.own.end(), [&](double own) { return is_among(loop.own, own + angle); });
  });
}

// The best of these angles, up to symmetries of the own ends; of each class the least in magnitude.
std::vector<double> best_of(const std::vector<EndAngles>& loops, std::vector<double> angles) {
  std::stable_sort(angles.begin(), angles.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  double least = std::numeric_limits<double>::infinity();
  for (const double angle : angles) least = std::min(least, offsets(loops, angle).squares);
  std::vector<double> best;
  for (const double angle : angles) {
    const bool is_known =
        std::any_of(best.begin(), best.end(), [&](double b) { return is_symmetry(loops, angle - b); });
    if (!is_known && offsets(loops, angle).squares <= least + tie * (1 + least)) best.push_back(angle);
  }
  return best;
}

// The rotations that bring an own end to another one, each moved to the nearest minimum.
std::vector<double> candidates(const std::vector<EndAngles>& loops) {
  std::vector<double> angles;
  for (const EndAngles& loop : loops)
    for (const double own : loop.own)
      for (const double other : loop.others) {
        const double angle = other - own;
        angles.push_back(wrap_pi(angle + offsets(loops, angle).mean));
      }
  return angles;
}

// In the middle between two neighbours of the equally good angles, their images under symmetries included.
std::vector<double> middles(const std::vector<EndAngles>& loops, const std::vector<double>& all,
                            const std::vector<double>& best) {
  std::vector<double> good, angles;
  for (const double angle : all)
    if (std::any_of(best.begin(), best.end(), [&](double b) { return is_symmetry(loops, angle - b); }))
      if (!is_among(good, angle)) good.push_back(angle);
  std::sort(good.begin(), good.end());
  for (std::size_t i = 0; i < good.size(); ++i) {
    const double next = i + 1 < good.size() ? good[i + 1] : good.front() + 2 * pi;
    angles.push_back(wrap_pi((good[i] + next) / 2));
  }
  return angles;
}

}  // namespace

double best_rotation(const std::vector<EndAngles>& loops) {
  const std::vector<double> all = candidates(loops);
  if (all.empty()) return 0;
  const std::vector<double> best = best_of(loops, all);
  if (best.size() == 1) return best.front();
  const std::vector<double> between = best_of(loops, middles(loops, all, best));
  return between.size() == 1 ? between.front() : best.front();
}

}  // namespace quadrille::couple
