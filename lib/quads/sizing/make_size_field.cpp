#include "sizing/make_size_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "curve/named_curves.hpp"
#include "sizing/boundary_sizes.hpp"
#include "sizing/curve_sizes.hpp"

namespace quadrille::sizing {
namespace {

constexpr double least_curvature_size = 1e-4;  // diameters

/// A finite number above 0.
std::optional<double> length_of(const std::string& text) {
  double length = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), length);
  const bool is_length =
      error == std::errc() && end == text.data() + text.size() && length > 0 && std::isfinite(length);
  return is_length ? std::optional<double>(length) : std::nullopt;
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
  const double greatest = options.size > 0 ? options.size : greatest_size(face, options.sources);
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
  if (options.per_curve > 0)
    add(segments_by_curves(face, options.per_curve, options.least_along_curves, greatest, slope));
  if (options.curvature > 0)
    for (const Nurbs& curve : face.curves)
      add(segments_by_curvature(curve, options.curvature, least_curvature_size * face.diameter, greatest, slope));
  return {greatest, options.sources, segments, growth(options)};
}

int parse_per_curve(const std::string& text) {
  if (text == "auto") return SizeOptions::automatic;
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < 0 || number > 10000)
    throw UsageError(fmt::format("--per-curve: '{}' is not \"auto\" or an integer from 0 to 10000", text));
  return number;
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
