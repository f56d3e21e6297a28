#include "sizing/size_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <variant>

#include "base/error.hpp"
#include "sizing/metric_field.hpp"

namespace quadrille::sizing {
namespace {

constexpr int leaf_size = 4;
/// More than the levels of a tree that halves up to 2^31 sources.
constexpr int max_bisections = 40;

/// A cuboid, in the plane a rectangle, and the least size in it.
struct Bounds {
  Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  double least = 1e300;

  void add(const Bounds& other) {
    low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y), std::min(low.z, other.low.z)};
    high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y), std::max(high.z, other.high.z)};
    least = std::min(least, other.least);
  }
  double distance2_to(Vec3 x) const {
    return norm2(Vec3{std::max({low.x - x.x, 0.0, x.x - high.x}), std::max({low.y - x.y, 0.0, x.y - high.y}),
                      std::max({low.z - x.z, 0.0, x.z - high.z})});
  }
  Vec3 centre() const { return (low + high) / 2; }
};

Bounds bounds_of(Vec3 a, Vec3 b, double least, double radius = 0) {
  Bounds bounds{a, a, least};
  bounds.add({b, b, least});
  const Vec3 margin{radius, radius, radius};
  return {bounds.low - margin, bounds.high + margin, least};
}

Bounds bounds_of(const SizeBall& p) { return bounds_of(p.position, p.position, p.size, p.radius); }
Bounds bounds_of(const SizeBox& box) { return bounds_of(box.low, box.high, box.size); }
Bounds bounds_of(const SizeTriangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  Bounds bounds = bounds_of(a, b, std::ranges::min(triangle.sizes));
  bounds.add(bounds_of(c, c, bounds.least));
  return bounds;
}

Vec2 in_plane(Vec3 x) { return {x.x, x.y}; }

/// Of an arc with its points that have the greatest and the least x and y.
Bounds bounds_of(const SizeSegment& segment) {
  Bounds bounds = bounds_of(segment.a, segment.b, std::min(segment.size_a, segment.size_b));
  if (!segment.is_arc()) return bounds;
  const Vec2 from = in_plane(segment.a) - segment.centre, to = in_plane(segment.b) - segment.centre;
  for (const Vec2 direction : {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}}) {
    const Vec3 end = in_space(segment.centre + segment.radius * direction);
    if (cross(from, direction) > 0 && cross(direction, to) > 0) bounds.add(bounds_of(end, end, bounds.least));
  }
  return bounds;
}

/// min over p on the segment of size(p) + slope |x - p|, the size linear: from the foot of x the least lies towards the
/// smaller size.
double along_segment(Vec3 x, Vec3 a, Vec3 b, double size_a, double size_b, double slope) {
  const double length = distance(a, b);
  if (!(length > 0)) return std::min(size_a, size_b) + slope * distance(x, a);
  const Vec3 along = (b - a) / length;
  const double rise = (size_b - size_a) / length, foot = dot(x - a, along), off = norm(cross(along, x - a));
  const double shift = std::abs(rise) < slope ? off * rise / std::sqrt(slope * slope - rise * rise)
                                              : std::copysign(length + std::abs(foot), rise);
  const double at = std::clamp(foot - shift, 0.0, length);
  return size_a + rise * at + slope * norm(Vec2{foot - at, off});
}

/// The distance from the arc of at most half a turn, counter-clockwise from a to b.
double distance_to_arc(Vec2 x, const SizeSegment& arc) {
  const Vec2 a = in_plane(arc.a), b = in_plane(arc.b);
  const bool is_beside = cross(a - arc.centre, x - arc.centre) >= 0 && cross(x - arc.centre, b - arc.centre) >= 0;
  return is_beside ? std::abs(distance(x, arc.centre) - arc.radius) : std::min(distance(x, a), distance(x, b));
}

double size_from(const SizeBall& p, Vec3 x, double slope) {
  return p.size + slope * std::max(0.0, distance(x, p.position) - p.radius);
}
double size_from(const SizeBox& box, Vec3 x, double slope) {
  return box.size + slope * std::sqrt(bounds_of(box).distance2_to(x));
}
double size_from(const SizeSegment& s, Vec3 x, double slope) {
  return s.is_arc() ? s.size_a + slope * distance_to_arc(in_plane(x), s)
                    : along_segment(x, s.a, s.b, s.size_a, s.size_b, slope);
}
/// min over p in the triangle of size(p) + slope |x - p|: in its plane x itself, if it is inside and the size varies by
/// less than the slope; else p is on a side, because a linear function and a distance have no other stationary points.
double size_from(const SizeTriangle& triangle, Vec3 x, double slope) {
  const auto& [a, b, c] = triangle.corners;
  const auto& [size_a, size_b, size_c] = triangle.sizes;
  const Vec3 normal = cross(b - a, c - a), up = normalized(normal);
  const double area = norm(normal);
  const double beta = dot(cross(x - a, c - a), up) / area, gamma = dot(cross(b - a, x - a), up) / area;
  if (beta >= 0 && gamma >= 0 && beta + gamma <= 1) {
    const double rise_b = size_b - size_a, rise_c = size_c - size_a;
    const Vec3 gradient = (rise_b * cross(c - a, up) + rise_c * cross(up, b - a)) / area;
    if (norm(gradient) <= slope)
      return size_a + beta * rise_b + gamma * rise_c +
             std::abs(dot(x - a, up)) * std::sqrt(slope * slope - norm2(gradient));
  }
  return std::min({along_segment(x, a, b, size_a, size_b, slope), along_segment(x, b, c, size_b, size_c, slope),
                   along_segment(x, c, a, size_c, size_a, slope)});
}

struct Source {
  std::variant<SizeBall, SizeBox, SizeSegment, SizeTriangle> shape;
  Bounds bounds;
  int region = -1;

  bool acts_in(int other) const { return region < 0 || other < 0 || region == other; }
  double at(Vec3 x, double slope) const {
    return std::visit([&](const auto& source) { return size_from(source, x, slope); }, shape);
  }
};

void require_size(double size, const char* what) {
  if (!(size > 0) || !std::isfinite(size))
    throw UsageError(fmt::format("the prescribed size of {} must be positive, not {}", what, size));
}

}  // namespace

/// A tree of cuboids over the sources: children of node n are consecutive from `first`; a leaf has no children but
/// `count` sources from `first`.
struct SizeField::Sources {
  struct Node {
    Bounds bounds;
    int first = 0, count = 0;
  };
  std::vector<Source> items;
  std::vector<Node> nodes;

  void add(const auto& source, const char* what, double greatest, int region = -1) {
    const Bounds bounds = bounds_of(source);
    require_size(bounds.least, what);
    if (bounds.least < greatest) items.push_back({source, bounds, region});
  }
  void add(const std::vector<SizeSegment>& segments, double greatest) {
    for (const SizeSegment& segment : segments) add(segment, "a piece of the boundary", greatest, segment.region);
  }

  void build() {
    nodes.assign(1, {});
    divide(0, 0, static_cast<int>(items.size()));
  }

  double at(Vec3 x, int region, double greatest, double slope) const {
    double best = greatest;
    struct Open {
      int node;
      double distance2;
    };
    std::array<Open, max_bisections> open{{{0, nodes[0].bounds.distance2_to(x)}}};
    for (int num_open = 1; num_open > 0;) {
      const auto [n, distance2] = open[--num_open];
      const Node& node = nodes[n];
      const double excess = best - node.bounds.least;
      if (excess <= 0 || slope * slope * distance2 >= excess * excess) continue;
      for (int k = 0; k < node.count; ++k)
        if (items[node.first + k].acts_in(region)) best = std::min(best, items[node.first + k].at(x, slope));
      if (node.count > 0) continue;
      // The nearer child is next.
      Open near{node.first, nodes[node.first].bounds.distance2_to(x)};
      Open far{node.first + 1, nodes[node.first + 1].bounds.distance2_to(x)};
      if (far.distance2 < near.distance2) std::swap(near, far);
      open[num_open++] = far, open[num_open++] = near;
    }
    return best;
  }

 private:
  void divide(int node, int begin, int end) {
    Bounds bounds;
    for (int i = begin; i < end; ++i) bounds.add(items[i].bounds);
    nodes[node].bounds = bounds;
    if (end - begin <= leaf_size) {
      nodes[node].first = begin, nodes[node].count = end - begin;
      return;
    }
    const Vec3 extent = bounds.high - bounds.low;
    double Vec3::*const along = extent.z > std::max(extent.x, extent.y) ? &Vec3::z
                                : extent.x > extent.y                   ? &Vec3::x
                                                                        : &Vec3::y;
    const auto before = [&](const Source& p, const Source& q) {
      return p.bounds.centre().*along < q.bounds.centre().*along;
    };
    const int middle = (begin + end) / 2, first = static_cast<int>(nodes.size());
    std::nth_element(items.begin() + begin, items.begin() + middle, items.begin() + end, before);
    nodes[node].first = first;
    nodes.resize(nodes.size() + 2);
    divide(first, begin, middle);
    divide(first + 1, middle, end);
  }
};

SizeField::SizeField(double greatest) : greatest_(greatest) { require_size(greatest, "all elements"); }

SizeField::SizeField(double greatest, const SizeSources& sources, const std::vector<SizeSegment>& segments,
                     double growth)
    : SizeField(greatest) {
  if (!(growth > 1)) throw UsageError("the growth of sizes must be greater than 1");
  Sources tree;
  for (const SizeBall& point : sources.points) tree.add(point, "a point", greatest);
  for (const SizeBox& box : sources.boxes) tree.add(box, "a box", greatest);
  for (const SizeTriangle& triangle : sources.triangles) tree.add(triangle, "a triangle", greatest);
  tree.add(segments, greatest);
  set_sources(std::move(tree), std::log(growth));
  if (sources.metric.empty()) return;
  slope_ = std::log(growth);
  metric_ = std::make_shared<const MetricField>(sources.metric, slope_);
}

void SizeField::set_sources(Sources sources, double slope) {
  if (sources.items.empty()) return;
  sources.build();
  slope_ = slope;
  sources_ = std::make_shared<const Sources>(std::move(sources));
}

SizeField SizeField::with(const std::vector<SizeSegment>& segments) const {
  SizeField result = *this;
  Sources sources = sources_ ? *sources_ : Sources{};
  sources.add(segments, greatest_);
  result.set_sources(std::move(sources), slope_ > 0 ? slope_ : std::log(default_growth));
  return result;
}

SizeField SizeField::in_chart(std::shared_ptr<const ChartScale> scale) const {
  SizeField result = *this;
  result.scale_ = std::move(scale);
  return result;
}

Vec2 direction_of(const DirectedSize& size) {
  const EigenPair of = eigen_pair(size.stretch);
  const double anisotropy = (of.first - of.second) / (of.first + of.second);
  return anisotropy * anisotropy * unit(4 * of.angle);
}

DirectedSize SizeField::directed(Vec2 x, int region) const {
  const ChartScale::Place place = scale_ ? scale_->at(x) : ChartScale::Place{in_space(x)};
  const double most = (sources_ ? sources_->at(place.position, region, greatest_, slope_) : greatest_) / place.scale;
  if (!metric_) return {most};
  const EigenPair of = eigen_pair(metric_->logarithm(x));
  const double first = std::max(of.first, -std::log(most)), second = std::max(of.second, -std::log(most));
  const double stretch = std::exp((first - second) / 2);
  return {std::exp(-(first + second) / 2), tensor_of({stretch, 1 / stretch, of.angle})};
}

}  // namespace quadrille::sizing
