#include "triangulate/triangle_sizes.hpp"

#include <algorithm>
#include <limits>

#include "base/vec2.hpp"

namespace quadrille::triangulate {
namespace {

constexpr int most_in_leaf = 8;
constexpr double rounding = 1e-14;  // relative, of a sum of a size and a distance

}  // namespace

double segment_distance(const Segment& a, const Segment& b) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      least = std::min(least, distance_of_segments(a.samples[i], a.samples[i + 1], b.samples[j], b.samples[j + 1]));
  return least;
}

TriangleSizes::TriangleSizes(const std::vector<Segment>& segments, double size, double growth,
                             const std::vector<SizePoint>& further)
    : sources_(further), size_(size), growth_(growth) {
  sources_.reserve(further.size() + 3 * segments.size());
  for (const Segment& segment : segments)
    for (const int k : {0, 2, 4}) sources_.push_back({segment.samples[k], segment.length(), 0});
  nodes_.emplace_back(0, static_cast<int>(sources_.size()));
  for (int node = 0; node < static_cast<int>(nodes_.size()); ++node) split(node);
}

// Measures the node, and cuts it in the middle of its box's longer side where it holds too many sources for a leaf.
void TriangleSizes::split(int id) {
  Node node = nodes_[id];
  if (node.first == node.last) return;
  const auto begin = sources_.begin() + node.first, end = sources_.begin() + node.last;
  node.box = {begin->position, begin->position};
  node.least_size = begin->size;
  for (auto source = begin; source != end; ++source) {
    node.box.extend({source->position, source->position});
    node.least_size = std::min(node.least_size, source->size);
  }
  if (node.last - node.first > most_in_leaf) {
    const Vec2 size = node.box.high - node.box.low;
    const bool is_wide = size.x > size.y;
    const int middle = (node.first + node.last) / 2;
    std::nth_element(begin, sources_.begin() + middle, end, [is_wide](const SizePoint& a, const SizePoint& b) {
      return is_wide ? a.position.x < b.position.x : a.position.y < b.position.y;
    });
    node.left = static_cast<int>(nodes_.size());
    nodes_.emplace_back(node.first, middle);
    nodes_.emplace_back(middle, node.last);
  }
  nodes_[id] = node;
}

// No source of the node prescribes less at x.
double TriangleSizes::lower_bound(const Node& node, Vec2 x) const {
  return (1 - rounding) * (node.least_size + growth_ * node.box.distance_from(x));
}

void TriangleSizes::search(int id, Vec2 x, double& least) const {
  const Node& node = nodes_[id];
  if (node.left < 0) {
    for (int i = node.first; i < node.last; ++i) {
      // Only sources that can still attain the minimum need a square root.
      const SizePoint& source = sources_[i];
      const double reach = (least - source.size) / growth_;
      if (reach > 0 && norm2(x - source.position) < reach * reach)
        least = std::min(least, source.size + growth_ * norm(x - source.position));
    }
    return;
  }
  const double bounds[] = {lower_bound(nodes_[node.left], x), lower_bound(nodes_[node.left + 1], x)};
  const int nearer = bounds[1] < bounds[0] ? 1 : 0;
  for (const int half : {nearer, 1 - nearer})
    if (bounds[half] < least) search(node.left + half, x, least);
}

double TriangleSizes::at(Vec2 x) const {
  double least = size_;
  search(0, x, least);
  return least;
}

}  // namespace quadrille::triangulate
