#include "layers/arc_sizes.hpp"

#include "layers/layer_rules.hpp"

namespace quadrille::layers {
namespace {

double mean_size(const sizing::SizeField& sizes, const curve::Chain& chain, int region) {
  constexpr int samples = layer_constants.size_samples;
  if (sizes.is_uniform()) return sizes.greatest();
  double sum = 0;
  for (int k = 0; k < samples; ++k) sum += 1 / sizes.at(chain.position((k + 0.5) / samples), region);
  return samples / sum;
}

}  // namespace

ArcSizes arc_sizes(const WallInput& input) {
  ArcSizes sizes;
  for (int arc = 0; arc < input.measured.num_arcs(); ++arc)
    sizes.prescribed.push_back(mean_size(input.sizes, input.measured.chain(arc), input.measured.region_of(arc)));
  sizes.scale.assign(sizes.prescribed.size(), 1);
  return sizes;
}

}  // namespace quadrille::layers
