#include "page/space_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>
#include <vector>

#include "draw/draw_in_space.hpp"
#include "model/hex_faces.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::page {

namespace {

constexpr int fine_mesh = 5000;  ///< elements: sides of more are straight
constexpr int curved_side = 4;   ///< points of a side without its end

struct SpaceFaces {
  std::vector<Vec3> points;
  std::vector<std::int32_t> outlines;  ///< 4 `per_side` for each face
  std::vector<std::int32_t> elems;     ///< two for each face; the second is -1 on the boundary
  int per_side = 1;
};

/// Outlines of faces, whose corners and sides are points that neighbours share.
class Outlines {
 public:
  Outlines(const std::vector<Vec3>& nodes, int order, int per_side, SpaceFaces& faces)
      : nodes_(nodes), order_(order), per_side_(per_side), faces_(faces), corner_points_(nodes.size(), -1) {
    std::vector<double> at;
    for (int i = 1; i < per_side; ++i) at.push_back(-1 + 2.0 * i / per_side);
    to_samples_ = spectral::interpolation_matrix(spectral::gll_points(order), at);
  }

  /// `face`: its nodes, the first direction fastest.
  void add(const std::vector<int>& face) {
    for (int side = 0; side < 4; ++side) {
      std::vector<int> ids;
      for (int i = 0; i <= order_; ++i) ids.push_back(face[local_side_node(order_, side, i)]);
      faces_.outlines.push_back(corner(ids.front()));
      if (per_side_ > 1) add_inner(ids);
    }
  }

 private:
  int corner(int node) {
    if (corner_points_[node] < 0) {
      corner_points_[node] = static_cast<int>(faces_.points.size());
      faces_.points.push_back(nodes_[node]);
    }
    return corner_points_[node];
  }

  /// Sides are distinguished by a node that no other one has.
  void add_inner(const std::vector<int>& ids) {
    const int own = std::min(ids[1], ids[order_ - 1]);
    const auto [side, is_new] = sides_.try_emplace(own, Side{static_cast<int>(faces_.points.size()), ids.front()});
    for (int i = 0; i + 1 < per_side_; ++i) {
      const bool is_reversed = side->second.start != ids.front();
      faces_.outlines.push_back(side->second.first + (is_reversed ? per_side_ - 2 - i : i));
      if (!is_new) continue;
      Vec3 x;
      for (int k = 0; k <= order_; ++k) x += to_samples_(i, k) * nodes_[ids[k]];
      faces_.points.push_back(x);
    }
  }

  struct Side {
    int first, start;  ///< point, and node where it starts
  };

  const std::vector<Vec3>& nodes_;
  int order_, per_side_;
  SpaceFaces& faces_;
  Eigen::MatrixXd to_samples_;
  std::vector<int> corner_points_;
  std::unordered_map<int, Side> sides_;
};

int points_per_side(int order, int num_elems) { return order == 1 || num_elems > fine_mesh ? 1 : curved_side; }

SpaceFaces faces_of(const QuadMesh& mesh) {
  SpaceFaces faces;
  faces.per_side = points_per_side(mesh.order, mesh.num_elems());
  Outlines outlines(mesh.space_nodes, mesh.order, faces.per_side, faces);
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const auto first = mesh.elem_nodes.begin() + static_cast<std::ptrdiff_t>(elem) * mesh.nodes_per_elem();
    outlines.add({first, first + mesh.nodes_per_elem()});
    faces.elems.insert(faces.elems.end(), {elem, -1});
  }
  return faces;
}

std::vector<int> nodes_of(const HexMesh& mesh, const HexFace& face) {
  std::vector<int> nodes = hex_face_nodes(mesh.order, face.face);
  for (int& node : nodes) node = mesh.elem_nodes[static_cast<std::size_t>(face.elem) * mesh.nodes_per_elem() + node];
  return nodes;
}

/// Of two faces between the same corners: whether they are one. From order 2 on they have inner nodes of their own.
bool are_one(const HexMesh& mesh, const HexFace& a, const HexFace& b) {
  if (a.corners != b.corners) return false;
  std::vector<int> nodes = nodes_of(mesh, a), others = nodes_of(mesh, b);
  return std::ranges::is_permutation(nodes, others);
}

SpaceFaces faces_of(const HexMesh& mesh) {
  SpaceFaces faces;
  faces.per_side = points_per_side(mesh.order, mesh.num_elems());
  Outlines outlines(mesh.nodes, mesh.order, faces.per_side, faces);
  const std::vector<HexFace> all = sorted_hex_faces(mesh);
  std::vector<bool> is_paired(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (is_paired[i]) continue;
    std::size_t other = i + 1;
    while (other < all.size() && all[other].corners == all[i].corners &&
           (is_paired[other] || !are_one(mesh, all[i], all[other])))
      ++other;
    const bool has_other = other < all.size() && all[other].corners == all[i].corners;
    if (has_other) is_paired[other] = true;
    outlines.add(nodes_of(mesh, all[i]));
    faces.elems.insert(faces.elems.end(), {all[i].elem, has_other ? all[other].elem : -1});
  }
  return faces;
}

std::string json_vector(Vec3 x) { return fmt::format("[{:.17g},{:.17g},{:.17g}]", x.x, x.y, x.z); }

JsonObject json_of(const SpaceFaces& faces, const draw::SpaceView& view) {
  Vec3 low = faces.points.front(), high = low;
  for (const Vec3 x : faces.points) {
    low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
    high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
  }
  const Vec3 middle = (low + high) / 2;
  std::vector<double> coordinates;
  double radius = 0;
  for (const Vec3 x : faces.points) {
    const Vec3 own = x - middle;
    coordinates.insert(coordinates.end(), {own.x, own.y, own.z});
    radius = std::max(radius, norm(own));
  }
  JsonObject object;
  object.data("points", packed_floats(coordinates)).data("outlines", packed(faces.outlines));
  object.data("elems", packed(faces.elems)).number("samples", 4 * faces.per_side);
  object.number("extent", 2 * radius).json("middle", json_vector(middle));
  object.json("right", json_vector(view.right)).json("up", json_vector(view.up));
  return object.json("towards", json_vector(view.towards));
}

}  // namespace

JsonObject space_data(const QuadMesh& mesh) { return json_of(faces_of(mesh), draw::space_view(mesh, {})); }

JsonObject space_data(const HexMesh& mesh) {
  return json_of(faces_of(mesh), draw::space_view(QuadMesh{}, draw::hex_view));
}

}  // namespace quadrille::page
