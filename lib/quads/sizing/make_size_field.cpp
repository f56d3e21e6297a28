#include "sizing/make_size_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/number_list.hpp"
#include "curve/named_places.hpp"
#include "curve/symmetry_lines.hpp"
#include "model/name_rules.hpp"
#include "sizing/curve_sizes.hpp"
#include "sizing/element_limit.hpp"

namespace quadrille::sizing {
namespace {

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
    runs.back().length += boundary_length(face, curve);
  }
  return runs;
}

constexpr double least_curvature_size = 1e-4;  // diameters

/// A finite number above 0.
std::optional<double> length_of(const std::string& text) {
  const std::optional<double> length = finite_number_of(text);
  return length && *length > 0 ? length : std::nullopt;
}

/// The parts of a text before and behind the last =.
std::pair<std::string, std::string> halves(const std::string& text) {
  const std::size_t at = std::min(text.rfind('='), text.size());
  return {text.substr(0, at), text.substr(std::min(at + 1, text.size()))};
}

/// Whether sources prescribe sizes everywhere: tables cover the whole face.
bool cover_face(const SizeSources& sources) { return sources.is_table || !sources.metric.empty(); }

/// The diameter, of a curved face in space, of the whole of which the face may be a half.
double diameter_of_whole(const CadFace& face, const CadFace& whole) {
  return face.chart ? diameter_in_space(face) * (whole.diameter / face.diameter) : whole.diameter;
}

/// Without a prescribed one.
double greatest_size(double diameter, const SizeSources& sources, const ChartScale* scale) {
  if (!cover_face(sources)) return diameter / 20;
  double greatest = 0;
  if (sources.is_table)
    for (const SizeBall& point : sources.points) greatest = std::max(greatest, point.size);
  for (const MetricSample& sample : sources.metric) {
    const double in_space = scale ? scale->at(sample.position).scale : 1;
    greatest = std::max({greatest, in_space * sample.h1, in_space * sample.h2});
  }
  return greatest;
}

/// Times as many elements as without sizes along curves.
constexpr double most_refined = 2;
/// From one trial of s to the next finer one, and the halvings of that factor's logarithm.
constexpr double coarsening = 4;
constexpr int num_bisections = 3;
constexpr double wake_growth = 1.05;

/// Whether a boundary with sizes of its own is the wake, in any region.
bool is_wake(const NearSize& near) { return near.boundary.substr(0, near.boundary.find('@')) == wake_name; }

SizeOptions with_wake(const CadFace& face, SizeOptions options) {
  const std::vector<int> curves = wake_curves(face);
  if (curves.empty() || std::ranges::any_of(options.near, is_wake)) return options;
  const SizeField sizes = make_size_field(face, options);
  const GrowingSize ends = growing_size(face, curves, 0, 0);
  const auto size_at = [&](Vec3 x) { return sizes.at({x.x, x.y}); };
  const double left = size_at(ends.end), right = size_at(ends.other_end), least = std::min(left, right);
  const double most = least + std::log(wake_growth) * distance(ends.end, ends.other_end);
  options.near.push_back(left <= right ? NearSize{wake_name, least, most} : NearSize{wake_name, most, least});
  return options;
}

/// Infinite if there are none.
double least_size(const std::vector<SizeSegment>& segments) {
  double least = std::numeric_limits<double>::infinity();
  for (const SizeSegment& segment : segments) least = std::min({least, segment.size_a, segment.size_b});
  return least;
}

}  // namespace

std::vector<SizeSegment> segments_by_curves(const CadFace& face, int per_curve, double least, double greatest,
                                            double slope) {
  std::vector<SizeSegment> segments;
  for (int loop = 0; loop < face.num_loops(); ++loop)
    for (const Run& run : runs_of_loop(face, loop)) {
      const int number = run.is_closed ? closed_factor * per_curve : per_curve;
      const double size = std::max({run.length / number, least, least_curve_size * diameter_in_space(face)});
      if (size >= greatest) continue;
      for (const int curve : run.curves) {
        const std::vector<SizeSegment> own = segments_near({face, curve}, size, slope);
        segments.insert(segments.end(), own.begin(), own.end());
      }
    }
  return segments;
}

void SizeOptions::validate() const {
  if (!(size >= 0)) throw UsageError("--size must not be negative");
  if (growth != 0 && !(growth > 1)) throw UsageError("--growth must be greater than 1");
  if (per_curve < 0 && per_curve != automatic) throw UsageError("--per-curve must not be negative");
  if (!(curvature >= 0)) throw UsageError("--curvature must not be negative");
}

double growth(const SizeOptions& options) {
  if (options.growth > 0) return options.growth;
  return options.sources.growth > 0 ? options.sources.growth : SizeField::default_growth;
}

SizeField make_size_field(const CadFace& face, const SizeOptions& options) {
  options.validate();
  const CadFace whole = curve::whole_of(face, options.symmetry);
  const double greatest = options.size > 0
                              ? options.size
                              : greatest_size(diameter_of_whole(face, whole), options.sources, options.scale.get());
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
      std::vector<SizeSegment> own = near.other_size > 0 ? segments_near({face, curve}, growing, slope)
                                                         : segments_near({face, curve}, near.size, slope);
      for (SizeSegment& segment : own) segment.region = region;
      add(own);
    }
  }
  for (const SagLimit& limit : options.sags) add(segments_by_sag(limit.curve, limit.sag, greatest, slope));
  if (options.per_curve > 0)
    add(segments_by_curves(whole, options.per_curve, options.least_along_curves, greatest, slope));
  if (options.curvature > 0)
    for (int curve = 0; curve < face.num_curves(); ++curve)
      add(segments_by_curvature({face, curve}, options.curvature, least_curvature_size * diameter_in_space(face),
                                greatest, slope));
  return SizeField(greatest, options.sources, segments, growth(options)).in_chart(options.scale);
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

SizeOptions with_curve_sizes(const MeasuredLayout& measured, const SizeOptions& options, SizeRule rule) {
  if (options.per_curve != SizeOptions::automatic) return options;
  SizeOptions none = options;
  none.per_curve = 0;
  if (options.size > 0 || cover_face(options.sources)) return none;
  const CadFace& face = measured.blocks().face;
  const auto with_least = [&](double least) {
    SizeOptions finer = options;
    finer.per_curve = SizeField::default_per_curve;
    finer.least_along_curves = least;
    return finer;
  };
  if (has_far_field(face)) return with_wake(face, with_least(0));

  const auto num_elements = [&](const SizeOptions& sizes) {
    return num_planned(measured, grade_chords(measured, make_size_field(face, sizes), rule, {}));
  };
  const double greatest = make_size_field(face, none).greatest_in_space();
  const CadFace whole = curve::whole_of(face, options.symmetry);
  const double shortest = least_size(segments_by_curves(whole, SizeField::default_per_curve, 0, greatest, 1));
  if (shortest >= greatest) return none;
  const double most = most_refined * num_elements(none);
  const auto are_few = [&](const SizeOptions& sizes) { return num_elements(sizes) <= most; };
  // Coarse sizes, whose chords need few samples, come first.
  const double least = std::max(shortest, least_curve_size * diameter_in_space(face));
  SizeOptions best = none;
  double fine = greatest, coarse = greatest;
  while (fine > least) {
    fine = std::max(least, fine / coarsening);
    if (!are_few(with_least(fine))) break;
    best = with_least(fine), coarse = fine;
  }
  for (int k = 0; k < num_bisections && fine < coarse; ++k) {
    const double middle = std::sqrt(fine * coarse);
    if (are_few(with_least(middle)))
      best = with_least(middle), coarse = middle;
    else
      fine = middle;
  }
  return best;
}

}  // namespace quadrille::sizing
