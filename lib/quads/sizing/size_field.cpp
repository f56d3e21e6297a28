#include "sizing/size_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "base/error.hpp"

namespace quadrille::sizing {
namespace {

constexpr int leaf_size = 4;
/// More than the levels of a tree that halves up to 2^31 sources.
constexpr int max_bisections = 40;

/// A rectangle, and the least size in it.
struct Bounds {
  Vec2 low{1e300, 1e300}, high{-1e300, -1e300};
  double least = 1e300;

  void add(const Bounds& other) {
    low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y)};
    high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y)};
    least = std::min(least, other.least);
  }
  double distance2_to(Vec2 x) const {
    return norm2(Vec2{std::max({low.x - x.x, 0.0, x.x - high.x}), std::max({low.y - x.y, 0.0, x.y - high.y})});
  }
  Vec2 centre() const { return (low + high) / 2; }
};

Bounds bounds_of(Vec2 a, Vec2 b, double least, double radius = 0) {
  return {{std::min(a.x, b.x) - radius, std::min(a.y, b.y) - radius},
          {std::max(a.x, b.x) + radius, std::max(a.y, b.y) + radius},
          least};
}

Bounds bounds_of(const SizePoint& p) { return bounds_of(p.position, p.position, p.size, p.radius); }
Bounds bounds_of(const SizeBox& box) { return bounds_of(box.low, box.high, box.size); }
Bounds bounds_of(const SizeTriangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  Bounds bounds = bounds_of(a, b, std::ranges::min(triangle.sizes));
  bounds.add(bounds_of(c, c, bounds.least));
  return bounds;
}
/// Of an arc with its points that have the greatest and the least x and y.
Bounds bounds_of(const SizeSegment& segment) {
  Bounds bounds = bounds_of(segment.a, segment.b, std::min(segment.size_a, segment.size_b));
  if (!(segment.radius > 0)) return bounds;
  for (const Vec2 direction : {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}}) {
    const Vec2 end = segment.centre + segment.radius * direction;
    if (cross(segment.a - segment.centre, direction) > 0 && cross(direction, segment.b - segment.centre) > 0)
      bounds.add(bounds_of(end, end, bounds.least));
  }
  return bounds;
}

/// min over p on the segment of size(p) + slope |x - p|, the size linear: from the foot of x the least lies towards the
/// smaller size.
double along_segment(Vec2 x, Vec2 a, Vec2 b, double size_a, double size_b, double slope) {
  const double length = distance(a, b);
  if (!(length > 0)) return std::min(size_a, size_b) + slope * distance(x, a);
  const Vec2 along = (b - a) / length;
  const double rise = (size_b - size_a) / length, foot = dot(x - a, along), off = std::abs(cross(along, x - a));
  const double shift = std::abs(rise) < slope ? off * rise / std::sqrt(slope * slope - rise * rise)
                                              : std::copysign(length + std::abs(foot), rise);
  const double at = std::clamp(foot - shift, 0.0, length);
  return size_a + rise * at + slope * norm(Vec2{foot - at, off});
}

/// The distance from the arc of at most half a turn, counter-clockwise from a to b.
double distance_to_arc(Vec2 x, const SizeSegment& arc) {
  const bool is_beside =
      cross(arc.a - arc.centre, x - arc.centre) >= 0 && cross(x - arc.centre, arc.b - arc.centre) >= 0;
  return is_beside ? std::abs(distance(x, arc.centre) - arc.radius) : std::min(distance(x, arc.a), distance(x, arc.b));
}

double size_from(const SizePoint& p, Vec2 x, double slope) {
  return p.size + slope * std::max(0.0, distance(x, p.position) - p.radius);
}
double size_from(const SizeBox& box, Vec2 x, double slope) {
  return box.size + slope * std::sqrt(bounds_of(box).distance2_to(x));
}
double size_from(const SizeSegment& s, Vec2 x, double slope) {
  return s.radius > 0 ? s.size_a + slope * distance_to_arc(x, s)
                      : along_segment(x, s.a, s.b, s.size_a, s.size_b, slope);
}
/// min over p in the triangle of size(p) + slope |x - p|: x itself, if it is inside and the size varies by less than
/// the slope; else p is on a side, because a linear function and a distance have no other stationary points.
double size_from(const SizeTriangle& triangle, Vec2 x, double slope) {
  const auto& [a, b, c] = triangle.corners;
  const auto& [size_a, size_b, size_c] = triangle.sizes;
  const double area = cross(b - a, c - a);
  const double beta = cross(x - a, c - a) / area, gamma = cross(b - a, x - a) / area;
  if (beta >= 0 && gamma >= 0 && beta + gamma <= 1) {
    const double rise_b = size_b - size_a, rise_c = size_c - size_a;
    const Vec2 gradient{(rise_b * (c.y - a.y) - rise_c * (b.y - a.y)) / area,
                        (rise_c * (b.x - a.x) - rise_b * (c.x - a.x)) / area};
    if (norm(gradient) <= slope) return size_a + beta * rise_b + gamma * rise_c;
  }
  return std::min({along_segment(x, a, b, size_a, size_b, slope), along_segment(x, b, c, size_b, size_c, slope),
                   along_segment(x, c, a, size_c, size_a, slope)});
}

struct Source {
  std::variant<SizePoint, SizeBox, SizeSegment, SizeTriangle> shape;
  Bounds bounds;
  int region = -1;

  bool acts_in(int other) const { return region < 0 || other < 0 || region == other; }
  double at(Vec2 x, double slope) const {
    return std::visit([&](const auto& source) { return size_from(source, x, slope); }, shape);
  }
};

void require_size(double size, const char* what) {
  if (!(size > 0) || !std::isfinite(size))
    throw UsageError(fmt::format("the prescribed size of {} must be positive, not {}", what, size));
}

}  // namespace

/// A tree of rectangles over the sources: children of node n are consecutive from `first`; a leaf has no children but
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

  double at(Vec2 x, int region, double greatest, double slope) const {
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
    const bool along_x = bounds.high.x - bounds.low.x > bounds.high.y - bounds.low.y;
    const auto before = [&](const Source& p, const Source& q) {
      return along_x ? p.bounds.centre().x < q.bounds.centre().x : p.bounds.centre().y < q.bounds.centre().y;
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
  for (const SizePoint& point : sources.points) tree.add(point, "a point", greatest);
  for (const SizeBox& box : sources.boxes) tree.add(box, "a box", greatest);
  for (const SizeTriangle& triangle : sources.triangles) tree.add(triangle, "a triangle", greatest);
  tree.add(segments, greatest);
  set_sources(std::move(tree), std::log(growth));
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
  result.set_sources(std::move(sources), sources_ ? slope_ : std::log(default_growth));
  return result;
}

double SizeField::at(Vec2 x, int region) const {
  return sources_ ? sources_->at(x, region, greatest_, slope_) : greatest_;
}

}  // namespace quadrille::sizing
