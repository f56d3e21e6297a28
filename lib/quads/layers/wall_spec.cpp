#include "layers/wall_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string_view>

#include "base/bracketed_root.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/name_text.hpp"
#include "base/tolerance.hpp"
#include "base/warning_codes.hpp"
#include "curve/named_places.hpp"
#include "layers/layer_rules.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::layers {
namespace {

class Parser {
 public:
  Parser(std::string option, const std::string& text) : option_(std::move(option)), text_(text) {}

  WallSpec parse(double yplus) {
    const std::size_t colon = text_.rfind(':');
    if (colon == std::string::npos || colon == 0) fail("expected NAME:first=H,layers=N");
    spec_.names = split_at_commas(std::string_view(text_).substr(0, colon));
    return parse_keys(std::string_view(text_).substr(colon + 1), yplus);
  }

  WallSpec parse_keys(std::string_view keys, double yplus) {
    for (const std::string& pair : split_at_commas(keys)) {
      const std::size_t equals = pair.find('=');
      if (equals == std::string::npos) fail(fmt::format("'{}' is not key=value", pair));
      const std::string key = pair.substr(0, equals);
      if (!seen_.insert(key).second) fail(fmt::format("{} is given twice", key));
      set(key, pair.substr(equals + 1));
    }
    if (!seen_.contains("first") && !seen_.contains("yplus")) spec_.yplus = yplus;
    require_complete();
    return spec_;
  }

 private:
  void set(const std::string& key, const std::string& value) {
    if (key == "first")
      spec_.first = number(key, value, 0, 1e300);
    else if (key == "yplus")
      spec_.yplus = number(key, value, 0, 1e300);
    else if (key == "thickness")
      spec_.thickness = number(key, value, 0, 1e300);
    else if (key == "growth")
      spec_.growth = number(key, value, 1, 2);
    else if (key == "layers")
      set_layers(value);
    else if (key == "law")
      set_law(value);
    else if (key == "blocks")
      set_blocks(value);
    else
      fail(fmt::format("unknown key '{}': expected first, yplus, growth, layers, thickness, law or blocks", key));
  }

  void set_layers(const std::string& value) {
    spec_.as_many_as_fit = value == "fit";
    if (spec_.as_many_as_fit) return;
    const double layers = number("layers", value, 1, layer_constants.max_layers);
    spec_.layers = static_cast<int>(layers);
    if (spec_.layers != layers) fail("layers must be a whole number or 'fit'");
  }

  void set_law(const std::string& value) {
    const std::optional<LayerLaw> law = enum_value<LayerLaw>(value);
    if (!law) fail(fmt::format("unknown law '{}': expected {}", value, alternatives(all_enum_names<LayerLaw>())));
    spec_.law = *law;
  }

  void set_blocks(const std::string& value) {
    if (value != "own" && value != "shared") fail(fmt::format("blocks={}: expected own or shared", value));
    spec_.own_blocks = value == "own";
  }

  double number(const std::string& key, const std::string& value, double low, double high) const {
    const std::optional<double> result = number_of<double>(value);
    if (!result) fail(fmt::format("{}: '{}' is not a number", key, value));
    if (!(*result >= low && *result <= high)) fail(fmt::format("{} must lie in {:g}..{:g}", key, low, high));
    return *result;
  }

  void require_complete() const {
    if (seen_.contains("first") && seen_.contains("yplus")) fail("one of first and yplus must be given, not both");
    if (!(spec_.first > 0 || spec_.yplus > 0))
      fail("first, the height of the first layer, or yplus must be given and positive");
    if (seen_.count("layers") + seen_.count("thickness") != 1) fail("one of layers and thickness must be given");
    if (seen_.count("thickness") && !(spec_.thickness > 0)) fail("thickness must be positive");
    if (spec_.own_blocks && spec_.as_many_as_fit) fail("blocks=own needs a number of layers, or thickness");
  }

  [[noreturn]] void fail(const std::string& why) const {
    throw UsageError(fmt::format("{} {}: {}", option_, text_, why));
  }

  std::string option_;
  const std::string& text_;
  WallSpec spec_;
  std::set<std::string> seen_;
};

constexpr double least_reynolds = 5e5, greatest_reynolds = 1e9;  ///< of the formula
constexpr double refused_reynolds = 1000;

std::vector<double> geometric_heights(double first, double growth, int layers) {
  std::vector<double> heights;
  double height = 0, layer = first;
  for (int k = 0; k < layers; ++k, layer *= growth) heights.push_back(height += layer);
  return heights;
}

double tanh_height(double thickness, double d, double fraction) {
  return thickness * (1 - std::tanh(d * (1 - fraction)) / std::tanh(d));
}

std::vector<double> tanh_heights(double first, double thickness, int layers) {
  const double d = bisect([&](double x) { return tanh_height(thickness, x, 1.0 / layers) - first; }, 1e-3, 50);
  std::vector<double> heights;
  for (int k = 1; k <= layers; ++k) heights.push_back(tanh_height(thickness, d, static_cast<double>(k) / layers));
  heights.front() = first;
  return heights;
}

std::vector<double> gll_heights(double first, int layers) {
  const std::vector<double> points = spectral::gauss_lobatto(2 * layers + 1).points;
  std::vector<double> heights;
  for (int k = 1; k <= layers; ++k) heights.push_back(first * (1 + points[k]) / (1 + points[1]));
  return heights;
}

}  // namespace

WallSpec parse_wall_spec(const std::string& text, double yplus) { return Parser("--wall", text).parse(yplus); }

WallSpec parse_layer_spec(const std::string& option, const std::string& text) {
  WallSpec spec = Parser(option, text).parse_keys(text, 0);
  if (spec.yplus > 0 || spec.as_many_as_fit || spec.own_blocks)
    throw UsageError(fmt::format("{} {}: yplus, layers=fit and blocks are for --wall of quadrefine", option, text));
  return spec;
}

std::vector<int> curve_walls(const std::vector<WallSpec>& specs, const CadFace& face) {
  std::vector<int> walls(face.curves.size(), -1);
  for (std::size_t i = 0; i < specs.size(); ++i)
    for (const std::string& name : specs[i].names)
      for (const int curve : curve::named_curves(face, name, "--wall")) {
        if (walls[curve] >= 0)
          throw UsageError(
              fmt::format("--wall: the boundary '{}' is named twice: a boundary has one set of layers", name));
        walls[curve] = static_cast<int>(i);
      }
  return walls;
}

double PlateFlow::skin_friction() const { return std::pow(2 * std::log10(reynolds_number()) - 0.65, -2.3); }

double PlateFlow::height(double yplus) const { return yplus * viscosity / (velocity * std::sqrt(skin_friction() / 2)); }

void PlateFlow::validate(bool is_used) const {
  std::vector<std::string> given, missing;
  (velocity > 0 ? given : missing).emplace_back("--velocity");
  (viscosity > 0 ? given : missing).emplace_back("--viscosity");
  (length > 0 ? given : missing).emplace_back("--length");
  if (!is_used && !given.empty())
    throw UsageError(
        fmt::format("{}: used with --yplus or --wall NAME:yplus=Y only, which are not given", fmt::join(given, ", ")));
  if (!is_used) return;
  if (!missing.empty()) throw UsageError(fmt::format("y+ needs the flow as well: give {}", fmt::join(missing, ", ")));
  if (!(reynolds_number() >= refused_reynolds))
    throw UsageError(
        fmt::format("--velocity, --length and --viscosity: their Reynolds number is {:.3g}, for which y+ of "
                    "a turbulent boundary layer means nothing: give first=H in place of yplus",
                    reynolds_number()));
}

void report_flow(const PlateFlow& flow, Report& report) {
  const double reynolds = flow.reynolds_number();
  report.set("flow.reynolds_number", reynolds);
  report.set("flow.skin_friction", flow.skin_friction());
  report.set("flow.friction_velocity", flow.velocity * std::sqrt(flow.skin_friction() / 2));
  if (reynolds < least_reynolds || reynolds > greatest_reynolds)
    report.warn(
        warning::reynolds_number_outside,
        fmt::format("the Reynolds number {:.3g} lies outside {:g} to {:g}, where the skin friction of the first "
                    "height is known: the achieved y+ may differ from the prescribed one",
                    reynolds, least_reynolds, greatest_reynolds));
}

void set_first_heights(std::vector<WallSpec>& specs, const PlateFlow& flow, double unit) {
  for (WallSpec& spec : specs)
    if (spec.yplus > 0) spec.first = flow.height(spec.yplus) * unit;
}

std::vector<double> layer_heights(const WallSpec& spec, int layers) {
  std::vector<double> geometric =
      geometric_heights(spec.first, spec.law == LayerLaw::uniform ? 1 : spec.growth, layers);
  if (layers <= 1) return geometric;
  if (spec.law == LayerLaw::gll) return gll_heights(spec.first, layers);
  // Without growth all layers are equal: tanh has no solution.
  const bool grows = geometric.back() > (1 + tolerance::tied) * layers * spec.first;
  return spec.law == LayerLaw::tanh && grows ? tanh_heights(spec.first, geometric.back(), layers) : geometric;
}

double growth_beyond(const WallSpec& spec) { return std::max(spec.growth, layer_constants.least_growth); }

double next_layer(const std::vector<double>& heights) {
  const std::size_t count = heights.size();
  const double last = count > 1 ? heights[count - 1] - heights[count - 2] : heights.back();
  const double below = count > 2 ? heights[count - 2] - heights[count - 3] : count > 1 ? heights.front() : last;
  return last * last / below;
}

std::vector<double> compressed_heights(const std::vector<double>& heights, double room, int above) {
  const double next = next_layer(heights), first = heights.front(), count = static_cast<double>(heights.size());
  if (room >= (heights.back() + next) * (1 - tolerance::tied)) return heights;
  std::vector<double> ratios;  // of the layers and the first one
  for (std::size_t k = 0; k < heights.size(); ++k)
    ratios.push_back((heights[k] - (k > 0 ? heights[k - 1] : 0)) / first);
  ratios.insert(ratios.end(), above, next / (above * first));
  const double least = std::min(first, room / (count + 1));
  const auto total = [&](double p) {
    double sum = 0;
    for (const double ratio : ratios) sum += least * std::pow(ratio, p);
    return sum;
  };
  const double power = least < first ? 0 : bisect([&](double p) { return total(p) - room; }, 0, 1);
  std::vector<double> compressed;
  double height = 0;
  for (std::size_t k = 0; k < heights.size(); ++k) compressed.push_back(height += least * std::pow(ratios[k], power));
  return compressed;
}

int requested_layers(const WallSpec& spec) {
  if (spec.layers > 0) return spec.layers;
  for (int layers = 1; layers <= layer_constants.max_layers; ++layers)
    if (layer_heights(spec, layers).back() >= (1 - tolerance::tied) * spec.thickness) return layers;
  throw UsageError(fmt::format("--wall {}: a thickness of {:g} needs more than {} layers: raise first or growth",
                               fmt::join(spec.names, ","), spec.thickness, layer_constants.max_layers));
}

double block_height(const WallSpec& spec) {
  const std::string names = fmt::format("--wall {}", fmt::join(spec.names, ","));
  if (!(spec.first > 0))
    throw UsageError(names + ": blocks=own with yplus needs the flow in units of the CAD file: leave --unit out");
  const std::vector<double> heights = layer_heights(spec, requested_layers(spec));
  return heights.back() + next_layer(heights);
}

double node_clearance(const WallSpec& spec) { return layer_constants.node_distance * block_height(spec); }

}  // namespace quadrille::layers
