#include "sizing/make_size_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "curve/chain.hpp"
#include "curve/named_places.hpp"
#include "curve/nurbs.hpp"
#include "curve/pole_box.hpp"
#include "curve/symmetry_lines.hpp"

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

/// The halves of the spans, each less than a right angle. `size`: all along.
std::vector<SizeSegment> arcs_of(const Nurbs& curve, const curve::Carrier& circle, double size) {
  std::vector<SizeSegment> arcs;
  for (std::size_t i = 1; i < curve.knots.size(); ++i) {
    const double low = curve.knots[i - 1], high = curve.knots[i], middle = (low + high) / 2;
    if (!(low < high)) continue;
    for (const auto& [from, to] : {std::pair(low, middle), std::pair(middle, high)}) {
      Vec2 a = curve::point(curve, from), b = curve::point(curve, to);
      if (cross(a - circle.point, b - circle.point) < 0) std::swap(a, b);
      arcs.push_back({a, b, size, size, -1, circle.radius, circle.point});
    }
  }
  return arcs;
}

constexpr int closed_factor = 3;

struct Run {
  std::vector<int> curves;
  double length = 0;
  bool is_closed = false;
};

/// Whether every mesh has a vertex at the start of the curve.
bool begins_run(const CadFace& face, int curve) {
  const int before = face.previous_in_loop(curve);
  return face.joints[curve].is_corner || (face.curve_names[before] != face.curve_names[curve] &&
                                          (face.has_given_name(before) || face.has_given_name(curve)));
}

std::vector<Run> runs_of_loop(const CadFace& face, int loop) {
  const int begin = face.loop_offsets[loop], end = face.loop_offsets[loop + 1];
  int first = begin;
  while (first < end && !begins_run(face, first)) ++first;
  std::vector<Run> runs;
  if (first == end) runs.push_back({{}, 0, true});
  for (int k = 0; k < end - begin; ++k) {
    const int curve = begin + (first - begin + k) % (end - begin);
    if (begins_run(face, curve)) runs.emplace_back();
    runs.back().curves.push_back(curve);
    runs.back().length += curve::ArcLength(face.curves[curve]).total();
  }
  return runs;
}

/// The size by the curvature, |1 / radius|, between `least` and `greatest`; segments all at `greatest` are omitted.
template <class Size>
std::vector<SizeSegment> segments_by_bend(const Nurbs& curve, const Size& size_at, double least, double greatest,
                                          double slope) {
  if (is_straight(curve)) return {};
  const auto size = [&](double t, bool from_left) {
    const double bend = std::abs(curve::curvature(curve, t, from_left));
    return bend > 0 ? std::clamp(size_at(bend), least, greatest) : greatest;
  };
  std::vector<SizeSegment> segments = segments_of(curve, size, slope);
  std::erase_if(segments, [&](const SizeSegment& s) { return std::min(s.size_a, s.size_b) >= greatest; });
  return segments;
}

constexpr double least_curvature_size = 1e-4;  // diameters

/// A finite number above 0.
std::optional<double> length_of(const std::string& text) {
  const std::optional<double> length = number_of<double>(text);
  return length && *length > 0 && std::isfinite(*length) ? length : std::nullopt;
}

/// The parts of a text before and behind the last =.
std::pair<std::string, std::string> halves(const std::string& text) {
  const std::size_t at = std::min(text.rfind('='), text.size());
  return {text.substr(0, at), text.substr(std::min(at + 1, text.size()))};
}

/// Without a prescribed one: a table covers the whole face, and so has it.
double greatest_size(const CadFace& face, const SizeSources& sources) {
  double greatest = sources.is_table ? 0 : face.diameter / 20;
  if (sources.is_table)
    for (const SizePoint& point : sources.points) greatest = std::max(greatest, point.size);
  return greatest;
}

}  // namespace

std::vector<SizeSegment> segments_near(const Nurbs& curve, double size, double slope) {
  if (const curve::Carrier carrier = curve::carrier_of(curve); carrier.kind == curve::CurveKind::arc)
    return arcs_of(curve, carrier, size);
  if (!is_straight(curve))
    return segments_of(
        curve, [size](double, bool) { return size; }, slope);
  std::vector<SizeSegment> segments;
  for (std::size_t i = 1; i < curve.poles.size(); ++i)
    segments.push_back({curve.poles[i - 1], curve.poles[i], size, size});
  return segments;
}

GrowingSize growing_size(const CadFace& face, const std::vector<int>& curves, double size, double other_size) {
  GrowingSize growing{face.joints[curves[0]].position, face.joints[curves[0]].position, size, other_size};
  const auto is_before = [&](Vec2 a, Vec2 b) {
    const double tol = tolerance::same_point * face.diameter;
    return std::abs(a.x - b.x) > tol ? a.x < b.x : a.y < b.y - tol;
  };
  for (const int c : curves)
    for (const int joint : {c, face.next_in_loop(c)}) {
      const Vec2 x = face.joints[joint].position;
      if (is_before(x, growing.end)) growing.end = x;
      if (is_before(growing.other_end, x)) growing.other_end = x;
    }
  return growing;
}

std::vector<SizeSegment> segments_near(const Nurbs& curve, const GrowingSize& size, double slope) {
  const double whole = distance(size.end, size.other_end);
  const auto at = [&](double t, bool) {
    const double part = whole > 0 ? std::min(1.0, distance(curve::point(curve, t), size.end) / whole) : 0;
    return size.size + part * (size.other_size - size.size);
  };
  return segments_of(curve, at, slope);
}

std::vector<SizeSegment> segments_by_curvature(const Nurbs& curve, double elements_per_turn, double least,
                                               double greatest, double slope) {
  return segments_by_bend(
      curve, [&](double bend) { return 2 * pi / (elements_per_turn * bend); }, least, greatest, slope);
}

std::vector<SizeSegment> segments_by_sag(const Nurbs& curve, double sag, double greatest, double slope) {
  return segments_by_bend(
      curve, [&](double bend) { return std::sqrt(8 * sag / bend); }, sag, greatest, slope);
}

std::vector<SizeSegment> segments_by_curves(const CadFace& face, int per_curve, double least, double greatest,
                                            double slope) {
  std::vector<SizeSegment> segments;
  for (int loop = 0; loop < face.num_loops(); ++loop)
    for (const Run& run : runs_of_loop(face, loop)) {
      const int number = run.is_closed ? closed_factor * per_curve : per_curve;
      const double size = std::max({run.length / number, least, least_curve_size * face.diameter});
      if (size >= greatest) continue;
      for (const int curve : run.curves) {
        const std::vector<SizeSegment> own = segments_near(face.curves[curve], size, slope);
        segments.insert(segments.end(), own.begin(), own.end());
      }
    }
  return segments;
}

void SizeOptions::validate() const {
  if (size < 0) throw UsageError("--size must not be negative");
  if (growth != 0 && !(growth > 1)) throw UsageError("--growth must be greater than 1");
  if (per_curve < 0 && per_curve != automatic) throw UsageError("--per-curve must not be negative");
  if (curvature < 0) throw UsageError("--curvature must not be negative");
}

double growth(const SizeOptions& options) {
  if (options.growth > 0) return options.growth;
  return options.sources.growth > 0 ? options.sources.growth : SizeField::default_growth;
}

SizeField make_size_field(const CadFace& face, const SizeOptions& options) {
  options.validate();
  const CadFace whole = curve::whole_of(face, options.symmetry);
  const double greatest = options.size > 0 ? options.size : greatest_size(whole, options.sources);
  const double slope = std::log(growth(options));
  std::vector<SizeSegment> segments;
  const auto add = [&](const std::vector<SizeSegment>& more) {
    segments.insert(segments.end(), more.begin(), more.end());
  };
  for (const NearSize& near : options.near) {
    const int region = curve::named_region(face, near.boundary);
    const std::vector<int> curves = curve::named_curves(face, near.boundary, "--size-near");
    const GrowingSize growing = growing_size(face, curves, near.size, near.other_size);
    for (const int curve : curves) {
      std::vector<SizeSegment> own = near.other_size > 0 ? segments_near(face.curves[curve], growing, slope)
                                                         : segments_near(face.curves[curve], near.size, slope);
      for (SizeSegment& segment : own) segment.region = region;
      add(own);
    }
  }
  for (const SagLimit& limit : options.sags) add(segments_by_sag(limit.curve, limit.sag, greatest, slope));
  if (options.per_curve > 0)
    add(segments_by_curves(whole, options.per_curve, options.least_along_curves, greatest, slope));
  if (options.curvature > 0)
    for (const Nurbs& curve : face.curves)
      add(segments_by_curvature(curve, options.curvature, least_curvature_size * face.diameter, greatest, slope));
  return {greatest, options.sources, segments, growth(options)};
}

int parse_per_curve(const std::string& text) {
  if (text == "auto") return SizeOptions::automatic;
  const std::optional<int> number = number_of<int>(text);
  if (!number || *number < 0 || *number > 10000)
    throw UsageError(fmt::format("--per-curve: '{}' is not \"auto\" or an integer from 0 to 10000", text));
  return *number;
}

NearSize parse_near_size(const std::string& text) {
  const auto [name, value] = halves(text);
  const auto colon = std::find(value.begin(), value.end(), ':');
  const bool is_one = colon == value.end();
  const std::optional<double> size = length_of({value.begin(), colon});
  const std::optional<double> other = is_one ? size : length_of({colon + 1, value.end()});
  if (name.empty() || !size || !other)
    throw UsageError(fmt::format("--size-near: '{}' is not NAME=H or NAME=H:H2 with lengths above 0", text));
  return {name, *size, is_one ? 0 : *other};
}

}  // namespace quadrille::sizing
