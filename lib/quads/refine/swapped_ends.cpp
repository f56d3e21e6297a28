#include "refine/swapped_ends.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "curve/gauss.hpp"
#include "curve/nearest_along.hpp"
#include "curve/nurbs.hpp"
#include "surface/nurbs_surface.hpp"
#include "surface/space_extent.hpp"

namespace quadrille::refine {
namespace {

constexpr double same_place = 1e-6;       ///< diameters in space, of images of the boundary and the surface
constexpr double symmetric_node = 1e-12;  ///< diameters in space: such a node stays where it is

template <class Visit>
void for_each_span(const SpaceCurve& curve, const Visit& visit) {
  for (std::size_t k = 1; k < curve.knots.size(); ++k)
    if (curve.knots[k - 1] < curve.knots[k]) visit(curve.knots[k - 1], curve.knots[k]);
}

/// The curves of each closed line of the boundary, whatever regions it bounds.
std::vector<std::vector<int>> rims(const CadFace& face, double tolerance) {
  const std::vector<SpaceCurve>& curves = face.chart->space_curves;
  const auto ends_at = [&](int c, int next) {
    return distance(curves[c].poles.back(), curves[next].poles.front()) <= tolerance;
  };
  DisjointSets joined(curves.size());
  for (int c = 0; c < face.num_curves(); ++c)
    for (int next = 0; next < face.num_curves(); ++next)
      if (!face.is_interface(c) && !face.is_interface(next) && ends_at(c, next)) joined.unite(c, next);
  std::vector<std::vector<int>> sets = joined.sets();
  std::erase_if(sets, [&](const std::vector<int>& set) { return face.is_interface(set.front()); });
  return sets;
}

/// By length.
Vec3 centre_of(const CadFace& face, const std::vector<int>& rim) {
  Vec3 moment;
  double length = 0;
  for (const int c : rim) {
    const SpaceCurve& curve = face.chart->space_curves[c];
    const auto speed = [&](double t) { return norm(surface::derivatives(curve, t)[1]); };
    for_each_span(curve, [&](double a, double b) {
      length += curve::gauss_integral(speed, a, b);
      moment += curve::gauss_integral([&](double t) { return speed(t) * surface::point(curve, t); }, a, b);
    });
  }
  return moment / length;
}

bool maps_curves(const CadFace& face, const SpaceMirror& mirror, double tolerance) {
  constexpr int steps = 5;  // odd, and different from the samples of the projection
  const std::vector<SpaceCurve>& curves = face.chart->space_curves;
  const auto is_on_boundary = [&](Vec3 x) {
    return std::ranges::any_of(curves,
                               [&](const SpaceCurve& c) { return surface::project(c, x).distance <= tolerance; });
  };
  return std::ranges::all_of(curves, [&](const SpaceCurve& curve) {
    bool is_mapped = true;
    for_each_span(curve, [&](double a, double b) {
      for (int i = 0; i < steps && is_mapped; ++i)
        is_mapped = is_on_boundary(mirror(surface::point(curve, a + (b - a) * i / steps)));
    });
    return is_mapped;
  });
}

/// One node of each triangle is tested: the last one, which is the one farthest inside.
bool maps_surface(const mesh::ChartMap& map, const Chart& chart, const SpaceMirror& mirror, double tolerance) {
  for (int elem = 0; elem < chart.num_elems(); ++elem) {
    const std::size_t last = static_cast<std::size_t>(chart.nodes_per_elem()) * (elem + 1) - 1;
    if (map.nearest(mirror(chart.space_nodes[last])).distance > tolerance) return false;
  }
  return true;
}

/// The image of each node under a reflection. Vertices may be far from the images of others by now: one edge on the
/// outline is found at the hole by its place, and all else from neighbour to neighbour.
class NodeImages {
 public:
  NodeImages(const QuadMesh& mesh, const SpaceMirror& mirror);

  /// None where elements are not mapped onto elements.
  const std::vector<int>& images() const { return images_; }
  bool are_complete() const { return is_complete_; }

 private:
  struct Side {
    int elem = -1, side = 0;
  };
  /// Of an element: corner k is mapped onto corner `turn` - k of `elem`.
  struct Image {
    int elem = -1, turn = 0;

    int side(int k) const { return (turn + 3 - k) % 4; }
  };

  void find_neighbours();
  Image image_of_edge(const QuadBoundaryEdge& edge, const SpaceMirror& mirror) const;
  bool map_elements(const QuadBoundaryEdge& first, const SpaceMirror& mirror);
  void map_nodes(int elem, Image image);

  const QuadMesh& mesh_;
  std::vector<std::array<Side, 4>> across_;  ///< by element and side; -1: boundary
  std::vector<int> images_;
  bool is_complete_ = true;
};

NodeImages::NodeImages(const QuadMesh& mesh, const SpaceMirror& mirror)
    : mesh_(mesh), across_(mesh.num_elems()), images_(mesh.nodes.size(), -1) {
  find_neighbours();
  is_complete_ = is_complete_ && map_elements(mesh.boundary_edges.front(), mirror);
  for (int node = 0; node < std::ssize(images_) && is_complete_; ++node) is_complete_ = images_[images_[node]] == node;
}

/// Sides are known by two of their nodes, which are inside where there are such.
void NodeImages::find_neighbours() {
  std::map<std::array<int, 2>, Side> open;
  for (int elem = 0; elem < mesh_.num_elems(); ++elem)
    for (int side = 0; side < 4; ++side) {
      std::array key{side_node(mesh_, elem, side, 1), side_node(mesh_, elem, side, mesh_.order - 1)};
      std::ranges::sort(key);
      const auto [known, is_first] = open.try_emplace(key, Side{elem, side});
      if (is_first) continue;
      const Side other = known->second;
      is_complete_ &= across_[other.elem][other.side].elem < 0;
      across_[elem][side] = other, across_[other.elem][other.side] = {elem, side};
    }
}

/// The mesh is on the left of both edges, so that the image begins where the edge ends.
NodeImages::Image NodeImages::image_of_edge(const QuadBoundaryEdge& edge, const SpaceMirror& mirror) const {
  const auto place = [&](const QuadBoundaryEdge& e, int k) {
    return mesh_.space_nodes[side_node(mesh_, e.elem, e.side, k)];
  };
  const Vec3 start = mirror(place(edge, 0)), end = mirror(place(edge, mesh_.order));
  const auto miss = [&](const QuadBoundaryEdge& e) {
    return distance(place(e, 0), end) + distance(place(e, mesh_.order), start);
  };
  const auto nearest = std::ranges::min_element(mesh_.boundary_edges, {}, miss);
  if (miss(*nearest) > distance(start, end)) return {};
  return {nearest->elem, (edge.side + nearest->side + 1) % 4};
}

bool NodeImages::map_elements(const QuadBoundaryEdge& first, const SpaceMirror& mirror) {
  std::vector<Image> image(mesh_.num_elems());
  image[first.elem] = image_of_edge(first, mirror);
  if (image[first.elem].elem < 0) return false;
  std::vector<int> queue{first.elem};
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const int elem = queue[i];
    map_nodes(elem, image[elem]);
    for (int side = 0; side < 4; ++side) {
      const Side next = across_[elem][side], other = across_[image[elem].elem][image[elem].side(side)];
      if ((next.elem < 0) != (other.elem < 0)) return false;
      if (next.elem < 0) continue;
      const Image expected{other.elem, (next.side + other.side + 1) % 4};
      Image& known = image[next.elem];
      if (known.elem < 0) known = expected, queue.push_back(next.elem);
      if (known.elem != expected.elem || known.turn != expected.turn) return false;
    }
  }
  return queue.size() == image.size();
}

void NodeImages::map_nodes(int elem, Image image) {
  constexpr std::array<std::array<int, 2>, 4> corner{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  const std::array<int, 2> origin = corner[image.turn], first = corner[(image.turn + 3) % 4],
                           second = corner[(image.turn + 1) % 4];
  const int n = mesh_.order, width = n + 1;
  const auto place = [&](int axis, int i, int j) {
    return n * origin[axis] + i * (first[axis] - origin[axis]) + j * (second[axis] - origin[axis]);
  };
  const int start = elem * mesh_.nodes_per_elem(), start_of_image = image.elem * mesh_.nodes_per_elem();
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      images_[mesh_.elem_nodes[start + j * width + i]] =
          mesh_.elem_nodes[start_of_image + place(1, i, j) * width + place(0, i, j)];
}

/// The point of the chart that is lifted to a position near the lifted one of x.
Vec2 chart_point(const mesh::ChartMap& map, Vec3 position, Vec2 x) {
  constexpr int steps = 4;  // of Newton's method
  for (int step = 0; step < steps; ++step) {
    const auto [a, b] = map.derivatives(x);
    const Vec3 rest = position - map.sample(x).position;
    const double mixed = dot(a, b);
    x += inverse(Mat2{norm2(a), mixed, mixed, norm2(b)}) * Vec2{dot(rest, a), dot(rest, b)};
  }
  return x;
}

/// By node: a curve on or beside which it lies, -1 inside.
std::vector<int> curves_of_nodes(const QuadMesh& mesh) {
  std::vector<int> curves(mesh.nodes.size(), -1);
  for (const auto* edges : {&mesh.boundary_edges, &mesh.interface_edges})
    for (const QuadBoundaryEdge& edge : *edges)
      for (const int node : side_nodes(mesh, edge.elem, edge.side)) curves[node] = edge.curve;
  return curves;
}

}  // namespace

std::optional<SpaceMirror> end_mirror(const mesh::ChartMap& map, const CadFace& face) {
  const double tolerance = same_place * surface::diameter(*face.chart);
  const std::vector<std::vector<int>> ends = rims(face, tolerance);
  for (std::size_t other = 1; other < ends.size(); ++other) {
    const Vec3 a = centre_of(face, ends.front()), b = centre_of(face, ends[other]);
    if (distance(a, b) <= tolerance) continue;
    const SpaceMirror mirror{(a + b) / 2, normalized(b - a)};
    if (maps_curves(face, mirror, tolerance) && maps_surface(map, *face.chart, mirror, tolerance)) return mirror;
  }
  return std::nullopt;
}

void symmetrise(const mesh::ChartMap& map, const SpaceMirror& mirror, QuadMesh& mesh) {
  const NodeImages partners(mesh, mirror);
  if (!partners.are_complete()) return;
  const std::vector<Vec3> before = mesh.space_nodes;
  const double unmoved = symmetric_node * surface::diameter(*mesh.face.chart);
  const std::vector<int> curves = curves_of_nodes(mesh);
  const curve::FaceBoundary boundary(mesh.face);
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
    const Vec3 mean = (before[node] + mirror(before[partners.images()[node]])) / 2;
    if (distance(mean, before[node]) <= unmoved) continue;
    if (curves[node] < 0) {
      mesh.nodes[node] = chart_point(map, mean, mesh.nodes[node]);
      mesh.space_nodes[node] = map.lift(mesh.nodes[node]);
      continue;
    }
    const int curve = curve::nearest_along(boundary, curves[node], mesh.nodes[node]).curve;
    const surface::CurveProjection foot = surface::project(mesh.face.chart->space_curves[curve], mean);
    mesh.nodes[node] = curve::point(mesh.face.curves[curve], foot.t), mesh.space_nodes[node] = foot.position;
  }
}

}  // namespace quadrille::refine
