#include "layers/layer_law.hpp"

#include <fmt/format.h>

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

int requested_layers(const WallSpec& spec) {
  if (spec.layers > 0) return spec.layers;
  for (int layers = 1; layers <= layer_constants.max_layers; ++layers)
    if (layer_heights(spec, layers).back() >= (1 - 1e-6) * spec.thickness) return layers;
  throw UsageError(fmt::format("--wall {}: a thickness of {:g} needs more than {} layers: raise first or growth",
                               fmt::join(spec.names, ","), spec.thickness, layer_constants.max_layers));
}

}  // namespace quadrille::layers
