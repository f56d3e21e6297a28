#include "layers/layer_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "layers/layer_rules.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::layers {
namespace {

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
  double low = 1e-3, high = 50;  // the first height falls as d rises
  for (int step = 0; step < 100; ++step) {
    const double d = (low + high) / 2;
    (tanh_height(thickness, d, 1.0 / layers) > first ? low : high) = d;
  }
  std::vector<double> heights;
  for (int k = 1; k <= layers; ++k) heights.push_back(tanh_height(thickness, low, static_cast<double>(k) / layers));
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

std::vector<double> layer_heights(const WallSpec& spec, int layers) {
  std::vector<double> geometric =
      geometric_heights(spec.first, spec.law == LayerLaw::uniform ? 1 : spec.growth, layers);
  if (layers <= 1) return geometric;
  if (spec.law == LayerLaw::gll) return gll_heights(spec.first, layers);
  // Without growth all layers are equal: tanh has no solution.
  const bool grows = geometric.back() > (1 + 1e-6) * layers * spec.first;
  return spec.law == LayerLaw::tanh && grows ? tanh_heights(spec.first, geometric.back(), layers) : geometric;
}

double next_layer(const std::vector<double>& heights) {
  const std::size_t count = heights.size();
  const double last = count > 1 ? heights[count - 1] - heights[count - 2] : heights.back();
  const double below = count > 2 ? heights[count - 2] - heights[count - 3] : count > 1 ? heights.front() : last;
  return last * last / below;
}

std::vector<double> compressed_heights(const std::vector<double>& heights, double room, int above) {
  const double next = next_layer(heights), first = heights.front(), count = static_cast<double>(heights.size());
  if (room >= (heights.back() + next) * (1 - layer_constants.equal_tol)) return heights;
  std::vector<double> ratios;  // of the layers and the first one
  for (std::size_t k = 0; k < heights.size(); ++k)
    ratios.push_back((heights[k] - (k > 0 ? heights[k - 1] : 0)) / first);
  ratios.insert(ratios.end(), above, next / (above * first));
  const double least = std::min(first, room / (count + 1));
  const auto total = [&](double power) {
    double sum = 0;
    for (const double ratio : ratios) sum += least * std::pow(ratio, power);
    return sum;
  };
  double low = 0, high = least < first ? 0 : 1;
  for (int step = 0; step < 60; ++step) (total((low + high) / 2) < room ? low : high) = (low + high) / 2;
  std::vector<double> compressed;
  double height = 0;
  for (std::size_t k = 0; k < heights.size(); ++k) compressed.push_back(height += least * std::pow(ratios[k], low));
  return compressed;
}

int requested_layers(const WallSpec& spec) {
  if (spec.layers > 0) return spec.layers;
  for (int layers = 1; layers <= layer_constants.max_layers; ++layers)
    if (layer_heights(spec, layers).back() >= (1 - 1e-6) * spec.thickness) return layers;
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
