#include "sweep/layer_ends.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/tolerance.hpp"
#include "prescribe/log_spacing.hpp"

namespace quadrille::sweep {

namespace {

constexpr int most_layers = 100000;

/// `count` layers of a geometric series along [0, 1].
std::vector<double> geometric_ends(int count, double growth) {
  std::vector<double> ends{0};
  if (std::abs(growth - 1) <= tolerance::round_off) {
    for (int k = 1; k <= count; ++k) ends.push_back(static_cast<double>(k) / count);
    return ends;
  }
  for (int k = 1; k <= count; ++k)
    ends.push_back(std::expm1(k * std::log(growth)) / std::expm1(count * std::log(growth)));
  ends.back() = 1;
  return ends;
}

/// Throws UsageError above most_layers.
int least_count(double length, double usual) {
  const double count = std::max(1.0, std::ceil(length / usual * (1 - tolerance::tied)));
  if (!(count <= most_layers))
    throw UsageError(fmt::format(
        "layers as high as the quads are long would be {:.3g}, more than {}: give --layers or a shorter sweep", count,
        most_layers));
  return static_cast<int>(count);
}

std::vector<double> heights_of(const std::optional<layers::WallSpec>& spec) {
  return spec ? layers::layer_heights(*spec, layers::requested_layers(*spec)) : std::vector<double>{};
}

/// Ends of `count` layers between walls, whose first and last are about `first` and `last` high; 0: free.
std::vector<double> middle_ends(int count, double length, double first, double last) {
  const std::vector<double> all = prescribe::LogSpacing(count, length, first, last).positions();
  const std::size_t steps = (all.size() - 1) / static_cast<std::size_t>(count);
  std::vector<double> ends;
  for (int k = 0; k <= count; ++k) ends.push_back(all[k * steps]);
  return ends;
}

/// Whether no layer is higher than `usual`, nor more than `growth` times as high as a neighbour.
bool is_smooth(const std::vector<double>& ends, double usual, double growth) {
  double before = 0;
  for (std::size_t k = 1; k < ends.size(); ++k) {
    const double height = ends[k] - ends[k - 1];
    if (height > usual * (1 + tolerance::tied)) return false;
    if (before > 0 && std::max(height / before, before / height) > growth * (1 + tolerance::tied)) return false;
    before = height;
  }
  return true;
}

}  // namespace

std::vector<double> layer_ends(const LayerPlan& plan, double length, double usual) {
  if (!plan.bottom && !plan.top)
    return geometric_ends(plan.layers > 0 ? plan.layers : least_count(length, usual), plan.growth);
  const std::vector<double> bottom = heights_of(plan.bottom), top = heights_of(plan.top);
  const double low = bottom.empty() ? 0 : bottom.back(), high = top.empty() ? 0 : top.back(),
               room = length - low - high;
  if (!(room > tolerance::round_off * length))
    throw UsageError(
        fmt::format("--bottom-layers and --top-layers are {:.6g} thick, but the sweep is {:.6g} long: lower layers, "
                    "first or growth",
                    low + high, length));
  const double first = bottom.empty() ? 0 : layers::next_layer(bottom),
               last = top.empty() ? 0 : layers::next_layer(top);
  const double growth = std::max(bottom.empty() ? 0 : layers::growth_beyond(*plan.bottom),
                                 top.empty() ? 0 : layers::growth_beyond(*plan.top));
  int count = plan.layers;
  for (int n = count > 0 ? 0 : least_count(room, usual); count == 0; n += 1 + n / 50)
    if (n >= most_layers || is_smooth(middle_ends(n, room, first, last), usual, growth)) count = n;
  std::vector<double> ends{0};
  for (const double height : bottom) ends.push_back(height / length);
  const std::vector<double> middle = middle_ends(count, room, first, last);
  for (std::size_t k = 1; k + 1 < middle.size(); ++k) ends.push_back((low + middle[k]) / length);
  for (std::size_t k = top.size(); k > 0; --k) ends.push_back(1 - top[k - 1] / length);
  ends.push_back(1);
  return ends;
}

}  // namespace quadrille::sweep
