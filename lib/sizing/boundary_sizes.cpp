#include "sizing/boundary_sizes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <set>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/name_text.hpp"
#include "curve/nurbs.hpp"
#include "model/interfaces.hpp"

namespace quadrille::sizing {
namespace {

constexpr double resolution = 1e-5;
constexpr int least_depth = 2, max_depth = 13;

/// Size at a parameter, from the left or the right of it.
using SizeAt = std::function<double(double t, bool from_left)>;

struct Sample {
  double t;
  Vec2 position;
  double size;
};

/// Halves a smooth part of a curve until segments are near enough.
class Segmenter {
 public:
  Segmenter(const Nurbs& curve, SizeAt size, double slope) : curve_(curve), size_(std::move(size)), slope_(slope) {}

  void add_span(double low, double high) { divide(sample(low, false), sample(high, true), 0); }
  std::vector<SizeSegment> segments() { return std::move(segments_); }

 private:
  Sample sample(double t, bool from_left) const { return {t, curve::point(curve_, t), size_(t, from_left)}; }

  void divide(const Sample& a, const Sample& b, int depth) {
    const Sample middle = sample((a.t + b.t) / 2, false);
    const double off = std::abs(middle.size - (a.size + b.size) / 2);
    // The size at the curve, from a segment that lies the sagitta away from it, is greater by slope times that.
    const double sagitta = distance_to_line(middle.position, a.position, b.position);
    const double error = std::max(off, slope_ * sagitta);
    if (depth >= max_depth || (depth >= least_depth && error <= resolution * std::min(a.size, b.size))) {
      segments_.push_back({a.position, middle.position, a.size, middle.size});
      segments_.push_back({middle.position, b.position, middle.size, b.size});
      return;
    }
    divide(a, middle, depth + 1);
    divide(middle, b, depth + 1);
  }

  static double distance_to_line(Vec2 x, Vec2 a, Vec2 b) {
    const double length = distance(a, b);
    return length > 0 ? std::abs(cross(b - a, x - a)) / length : distance(x, a);
  }

  const Nurbs& curve_;
  SizeAt size_;
  double slope_;
  std::vector<SizeSegment> segments_;
};

std::vector<SizeSegment> segments_of(const Nurbs& curve, const SizeAt& size, double slope) {
  Segmenter segmenter(curve, size, slope);
  for (std::size_t i = 1; i < curve.knots.size(); ++i)
    if (curve.knots[i - 1] < curve.knots[i]) segmenter.add_span(curve.knots[i - 1], curve.knots[i]);
  return segmenter.segments();
}

bool is_straight(const Nurbs& curve) { return curve.degree == 1; }

}  // namespace

namespace {

/// The region of this name or else of this number; -1: none.
int region_of_name(const CadFace& face, const std::string& name) {
  for (int r = 0; r < face.num_regions(); ++r)
    if (face.region_names[r] == name) return r;
  for (int r = 0; r < face.num_regions(); ++r)
    if (std::to_string(r) == name) return r;
  return -1;
}

/// The part behind the last @ is the name of a region, or its number.
std::vector<int> curves_of_region(const CadFace& face, const std::string& name, std::size_t at,
                                  const std::string& option) {
  const std::string region = name.substr(at + 1);
  const std::vector<int> curve_region = curve_regions(face);
  const int number = region_of_name(face, region);
  const auto is_in_region = [&](int c) { return curve_region[c] == number; };
  std::vector<int> curves = named_curves(face, name.substr(0, at), option);
  std::erase_if(curves, [&](int c) { return !is_in_region(c); });
  if (!curves.empty()) return curves;
  throw UsageError(fmt::format("{}: the boundary \"{}\" does not belong to a region \"{}\"{}; the regions are {}",
                               option, name.substr(0, at), region, did_you_mean(region, face.region_names),
                               fmt::join(face.region_names, ", ")));
}

}  // namespace

std::vector<int> named_curves(const CadFace& face, const std::string& name, const std::string& option) {
  std::vector<int> curves;
  for (int c = 0; c < face.num_curves(); ++c)
    if (face.curve_names[c] == name) curves.push_back(c);
  int number = -1;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  const bool is_number = error == std::errc() && end == name.data() + name.size();
  if (curves.empty() && is_number && number >= 0 && number < face.num_curves()) curves.push_back(number);
  if (!curves.empty()) return curves;
  if (const std::size_t at = name.rfind('@'); at != std::string::npos && face.num_regions() > 1)
    return curves_of_region(face, name, at, option);
  const std::set<std::string> known(face.curve_names.begin(), face.curve_names.end());
  throw UsageError(fmt::format("{}: there is no boundary \"{}\"{}; the names are {} (or use the numbers 0 to {})",
                               option, name, did_you_mean(name, face.curve_names), fmt::join(known, ", "),
                               face.num_curves() - 1));
}

int named_region(const CadFace& face, const std::string& name) {
  const std::size_t at = name.rfind('@');
  if (at == std::string::npos || face.num_regions() == 1) return -1;
  if (std::find(face.curve_names.begin(), face.curve_names.end(), name) != face.curve_names.end()) return -1;
  return region_of_name(face, name.substr(at + 1));
}

std::vector<SizeSegment> segments_near(const Nurbs& curve, double size, double slope) {
  if (!is_straight(curve))
    return segments_of(
        curve, [size](double, bool) { return size; }, slope);
  std::vector<SizeSegment> segments;
  for (std::size_t i = 1; i < curve.poles.size(); ++i)
    segments.push_back({curve.poles[i - 1], curve.poles[i], size, size});
  return segments;
}

std::vector<SizeSegment> segments_by_curvature(const Nurbs& curve, double elements_per_turn, double least,
                                               double greatest, double slope) {
  if (is_straight(curve)) return {};
  const auto size = [&](double t, bool from_left) {
    const double bend = std::abs(curve::curvature(curve, t, from_left));
    return bend * greatest * elements_per_turn > 2 * pi ? std::max(least, 2 * pi / (elements_per_turn * bend))
                                                        : greatest;
  };
  std::vector<SizeSegment> segments = segments_of(curve, size, slope);
  std::erase_if(segments, [&](const SizeSegment& s) { return std::min(s.size_a, s.size_b) >= greatest; });
  return segments;
}

}  // namespace quadrille::sizing
