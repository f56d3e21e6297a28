#include "offset/offset_profile.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "curve/chain.hpp"
#include "curve/nurbs.hpp"
#include "model/interfaces.hpp"
#include "offset/wall_chains.hpp"

namespace quadrille::offset {

namespace {

/// Half of the length over which ratios are averaged.
double half_width(const RatioSamples& samples) { return std::min(samples.distance, samples.lengths.back() / 2) / 2; }

/// The least ratio within twice that length and two intervals, so that averages are not above the ratios.
std::vector<double> least_around(const RatioSamples& samples) {
  const std::vector<double>& lengths = samples.lengths;
  double interval = 0;
  for (std::size_t k = 1; k < lengths.size(); ++k) interval = std::max(interval, lengths[k] - lengths[k - 1]);
  const double reach = 2 * (half_width(samples) + interval);
  std::vector<double> least;
  for (const double s : lengths) {
    double value = 1;
    for (std::size_t k = 0; k < lengths.size(); ++k) {
      const double apart = std::abs(lengths[k] - s);
      const double shortest = samples.is_closed ? std::min(apart, lengths.back() - apart) : apart;
      if (shortest <= reach) value = std::min(value, samples.ratios[k]);
    }
    least.push_back(value);
  }
  return least;
}

void limit_slope(const RatioSamples& samples, std::vector<double>& ratios) {
  const double slope = offset_constants.greatest_slope / samples.distance;
  const std::size_t last = ratios.size() - 1;
  const auto step = [&](std::size_t from, std::size_t to) {
    ratios[to] = std::min(ratios[to], ratios[from] + slope * std::abs(samples.lengths[to] - samples.lengths[from]));
  };
  for (int round = 0; round < (samples.is_closed ? 2 : 1); ++round) {
    for (std::size_t k = 0; k < last; ++k) step(k, k + 1);
    for (std::size_t k = last; k > 0; --k) step(k, k - 1);
    if (samples.is_closed) ratios.front() = ratios.back() = std::min(ratios.front(), ratios.back());
  }
}

/// A piecewise linear function, continued periodically or by its end values, and its integral.
class LinearFunction {
 public:
  LinearFunction(const RatioSamples& samples, const std::vector<double>& values)
      : samples_(samples), values_(values), integrals_{0} {
    for (std::size_t k = 1; k < values.size(); ++k)
      integrals_.push_back(integrals_.back() +
                           (samples.lengths[k] - samples.lengths[k - 1]) * (values[k] + values[k - 1]) / 2);
  }

  double value(double s) const {
    const auto [k, rest] = place(wrapped(s).second);
    const double h = samples_.lengths[k + 1] - samples_.lengths[k];
    return values_[k] + (values_[k + 1] - values_[k]) * std::clamp(rest / h, 0.0, 1.0);
  }

  /// From the start of the chain.
  double integral(double s) const {
    const double total = samples_.lengths.back();
    const auto [turns, inside] = wrapped(s);
    if (!samples_.is_closed && s < 0) return s * values_.front();
    if (!samples_.is_closed && s > total) return integrals_.back() + (s - total) * values_.back();
    const auto [k, rest] = place(inside);
    return turns * integrals_.back() + integrals_[k] + rest * (values_[k] + value(inside)) / 2;
  }

 private:
  /// Whole turns, and the length in [0, total].
  std::pair<double, double> wrapped(double s) const {
    const double total = samples_.lengths.back();
    if (!samples_.is_closed) return {0, std::clamp(s, 0.0, total)};
    const double turns = std::floor(s / total);
    return {turns, std::clamp(s - turns * total, 0.0, total)};
  }
  std::pair<std::size_t, double> place(double s) const {
    const auto above = std::upper_bound(samples_.lengths.begin() + 1, samples_.lengths.end() - 1, s);
    const std::size_t k = static_cast<std::size_t>(above - samples_.lengths.begin()) - 1;
    return {k, s - samples_.lengths[k]};
  }

  const RatioSamples& samples_;
  const std::vector<double>& values_;
  std::vector<double> integrals_;
};

SmoothRatios averaged(const RatioSamples& samples, const std::vector<double>& values) {
  const LinearFunction function(samples, values);
  const double half = half_width(samples);
  SmoothRatios smooth;
  for (const double s : samples.lengths) {
    smooth.ratios.push_back((function.integral(s + half) - function.integral(s - half)) / (2 * half));
    smooth.slopes.push_back((function.value(s + half) - function.value(s - half)) / (2 * half));
  }
  return smooth;
}

}  // namespace

SmoothRatios smoothed_ratios(const RatioSamples& samples) {
  std::vector<double> ratios = least_around(samples);
  limit_slope(samples, ratios);
  return averaged(samples, averaged(samples, ratios).ratios);
}

namespace {

struct BoundarySample : WallFoot {
  int curve = -1;
  double distance = 0;  ///< the prescribed one, in the plane or the chart; 0: of no wall
};

struct WallDistances {
  const std::vector<double>& of_curves;  ///< lengths in space of a curved face
  const ChartHeights& heights;

  BoundarySample sample(const WallFoot& foot, int curve) const {
    return {foot, curve, of_curves[curve] > 0 ? heights.in_chart(foot, of_curves[curve]) : 0};
  }
};

/// Equally spaced by arc length, with both ends; `distance`: the least of the chain.
std::vector<BoundarySample> samples_of(const CadFace& face, int curve, const WallDistances& walls, double distance) {
  const Nurbs& nurbs = face.curves[curve];
  const curve::ArcLength length(nurbs);
  const double wanted = offset_constants.samples_per_distance * length.total() / distance;
  const int count = static_cast<int>(
      std::clamp(std::ceil(wanted), 1.0 * offset_constants.least_samples, 1.0 * offset_constants.most_samples));
  std::vector<BoundarySample> samples;
  for (int i = 0; i <= count; ++i) {
    const double t = length.parameter(length.total() * i / count);
    samples.push_back(walls.sample({curve::point(nurbs, t), left_of(curve::tangent(nurbs, t, i == count))}, curve));
  }
  return samples;
}

bool is_convex_corner(const CadFace& face, int joint) {
  return face.joints[joint].is_corner && face.joints[joint].interior_angle < pi;
}

/// Whether points of the curve `other` limit the distance from `wall`.
bool faces(const CadFace& face, int wall, int other) {
  if (other == wall) return true;
  const int next = face.next_in_loop(wall);
  return !(other == next && is_convex_corner(face, next)) &&
         !(other == face.previous_in_loop(wall) && is_convex_corner(face, wall));
}

class Allowance {
 public:
  Allowance(const CadFace& face, int region, const WallDistances& walls, double distance) : face_(face), walls_(walls) {
    const std::vector<int> curve_region = curve_regions(face);
    for (int c = 0; c < face.num_curves(); ++c)
      if (curve_region[c] == region)
        for (const BoundarySample& sample : samples_of(face, c, walls, distance)) boundary_.push_back(sample);
  }

  /// The distance at the sample of a wall, over the prescribed one; at most 1.
  double ratio(const BoundarySample& sample) const { return ratio(sample, 1); }

  /// The same at the corner above 180 degrees in which the curve starts.
  double corner_ratio(const Joint& joint, int curve) const {
    if (!joint.is_corner || joint.interior_angle < pi) return 1;
    double least = 1;
    for (int k = 0; k <= offset_constants.corner_directions; ++k) {
      const double turn = (joint.interior_angle - pi) * k / offset_constants.corner_directions;
      const BoundarySample towards = walls_.sample({joint.position, left_of(unit(joint.tangent_in - turn))}, curve);
      least = std::min(least, ratio(towards, offset_constants.corner_reach));
    }
    return least;
  }

 private:
  double ratio(const BoundarySample& sample, double reach) const {
    const double distance = reach * sample.distance;
    double least = distance;
    for (const BoundarySample& other : boundary_) {
      const Vec2 d = other.position - sample.position;
      const double height = dot(sample.normal, d), squared = norm2(d);
      if (height <= 1e-10 * face_.diameter) continue;
      if (!faces(face_, sample.curve, other.curve)) continue;
      least = std::min(least, share(sample.distance, other.distance) * squared / (2 * height));
    }
    return walls_.heights.in_space(sample, least) / walls_.heights.in_space(sample, distance);
  }

  static double share(double own, double other) {
    return other > 0 ? offset_constants.share_of_facing_wall * 2 * own / (own + other)
                     : offset_constants.share_of_boundary;
  }

  const CadFace& face_;
  const WallDistances& walls_;
  std::vector<BoundarySample> boundary_;
};

/// Adds those of one curve, and those of its corners.
void add_ratios(const CadFace& face, int curve, const WallDistances& walls, const Allowance& allowance,
                RatioSamples& samples) {
  const std::vector<BoundarySample> own = samples_of(face, curve, walls, samples.distance);
  const double step = curve::ArcLength(face.curves[curve]).total() / (static_cast<double>(own.size()) - 1);
  const double start = samples.lengths.empty() ? 0 : samples.lengths.back();
  const bool is_first = samples.lengths.empty();
  for (std::size_t k = 0; k < own.size(); ++k) {
    double ratio = allowance.ratio(own[k]);
    if (k == 0) ratio = std::min(ratio, allowance.corner_ratio(face.joints[curve], curve));
    if (k + 1 == own.size())
      ratio = std::min(ratio, allowance.corner_ratio(face.joints[face.next_in_loop(curve)], curve));
    if (k == 0 && !is_first) {
      samples.ratios.back() = std::min(samples.ratios.back(), ratio);
      continue;
    }
    samples.lengths.push_back(start + step * static_cast<double>(k));
    samples.ratios.push_back(ratio);
    samples.positions.push_back(own[k].position);
  }
  samples.first.push_back(static_cast<int>(samples.ratios.size()) - 1);
}

/// The least of the chain, where its curves start.
double least_distance(const CadFace& face, const WallChain& chain, const WallDistances& walls) {
  double least = HUGE_VAL;
  for (const int c : chain.curves) {
    const Joint& joint = face.joints[c];
    least = std::min(least, walls.sample({joint.position, left_of(unit(joint.tangent_out))}, c).distance);
  }
  return least;
}

RatioSamples allowed_ratios(const CadFace& face, const WallChain& chain, const WallDistances& walls) {
  const double least = least_distance(face, chain, walls);
  const Allowance allowance(face, curve_regions(face)[chain.curves.front()], walls, least);
  RatioSamples samples{chain.is_closed, {}, {}, {}, {0}, least};
  for (const int curve : chain.curves) add_ratios(face, curve, walls, allowance, samples);
  if (chain.is_closed)
    samples.ratios.front() = samples.ratios.back() = std::min(samples.ratios.front(), samples.ratios.back());
  return samples;
}

OffsetProfile profile_of(const SmoothRatios& smooth, const RatioSamples& samples, std::size_t i, double distance) {
  OffsetProfile profile{distance, true, {}};
  std::vector<double> lengths;
  std::vector<Vec2> values;
  const int first = samples.first[i], last = samples.first[i + 1];
  for (int k = first; k <= last; ++k) {
    lengths.push_back(samples.lengths[k] - samples.lengths[first]);
    values.push_back({distance * smooth.ratios[k], 0});
    profile.is_constant = profile.is_constant && smooth.ratios[k] > 1 - 1e-9;
  }
  if (!profile.is_constant)
    profile.by_length =
        curve::cubic_spline(lengths, values, {distance * smooth.slopes[first], 0}, {distance * smooth.slopes[last], 0});
  return profile;
}

}  // namespace

double OffsetProfile::at(double length) const { return is_constant ? distance : curve::point(by_length, length).x; }

double OffsetProfile::slope(double length) const { return is_constant ? 0 : curve::derivative(by_length, length).x; }

ChainProfile chain_profile(const CadFace& face, const WallChain& chain, const std::vector<double>& wall_distance,
                           const ChartHeights& heights) {
  const RatioSamples samples = allowed_ratios(face, chain, {wall_distance, heights});
  const SmoothRatios smooth = smoothed_ratios(samples);
  ChainProfile profile;
  for (std::size_t i = 0; i < chain.curves.size(); ++i)
    profile.curves.push_back(profile_of(smooth, samples, i, chain.distances[i]));
  const auto least = std::min_element(smooth.ratios.begin(), smooth.ratios.end());
  const bool is_constant =
      std::all_of(profile.curves.begin(), profile.curves.end(), [](const OffsetProfile& p) { return p.is_constant; });
  profile.least_ratio = is_constant ? 1 : *least;
  profile.narrowest = samples.positions[least - smooth.ratios.begin()];
  return profile;
}

}  // namespace quadrille::offset
