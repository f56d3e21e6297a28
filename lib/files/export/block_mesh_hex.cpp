#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "export/block_mesh_text.hpp"
#include "export/groups.hpp"
#include "export/hex_periodic.hpp"
#include "export/layer_quads.hpp"
#include "export/patches.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

constexpr double relative_tolerance = 1e-10;  ///< of the diameter, for what is straight and planar

/// The plane of the quads below: origin + x e_x + y e_y, seen from above counter-clockwise.
struct BottomPlane {
  Vec3 normal, e_x, e_y, origin;

  Vec2 at(Vec3 x) const { return {dot(x, e_x), dot(x, e_y)}; }
  std::array<double, 3> at(Vec2 x) const {
    const Vec3 p = origin + x.x * e_x + x.y * e_y;
    return {p.x, p.y, p.z};
  }
};

/// The normal is that of the area. Of a face in z = constant the axes are those of the model.
BottomPlane bottom_plane(const HexMesh& mesh) {
  const int n = mesh.order;
  Vec3 area;
  for (int quad = 0; quad < mesh.num_quads; ++quad) {
    const int* own = &mesh.elem_nodes[static_cast<std::size_t>(quad) * mesh.nodes_per_elem()];
    const auto corner = [&](int local) { return mesh.nodes[own[local]]; };
    area = area + cross(corner(n * (n + 2)) - corner(0), corner(n * (n + 1)) - corner(n));
  }
  BottomPlane plane;
  plane.normal = normalized(area);
  const Vec3 axis = std::abs(plane.normal.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  plane.e_x = normalized(axis - dot(axis, plane.normal) * plane.normal);
  plane.e_y = cross(plane.normal, plane.e_x);
  plane.origin = dot(mesh.nodes[mesh.elem_nodes[0]], plane.normal) * plane.normal;
  return plane;
}

/// A sweep whose levels are the bottom, moved along one line.
struct StraightSweep {
  QuadMesh quads;  ///< in the plane
  BottomPlane plane;
  Vec3 way;                    ///< from the bottom to the top
  std::vector<double> layers;  ///< fractions of the way
};

class StraightSweepFinder {
 public:
  explicit StraightSweepFinder(const HexMesh& mesh)
      : mesh_(mesh), least_(relative_tolerance * mesh.diameter), quad_size_((mesh.order + 1) * (mesh.order + 1)) {}

  std::optional<StraightSweep> found() const {
    StraightSweep sweep{quads_of_layer(mesh_), bottom_plane(mesh_), shift(mesh_.num_layers() - 1, mesh_.order), {}};
    if (norm(sweep.way) <= least_ || !is_planar(sweep.plane)) return {};
    double before = 0;
    for (int layer = 0; layer < mesh_.num_layers(); ++layer) {
      for (int k = 0; k <= mesh_.order; ++k)
        if (!is_moved(layer, k, sweep.way)) return {};
      const double share = fraction(shift(layer, mesh_.order), sweep.way);
      sweep.layers.push_back(share - before);
      before = share;
    }
    set_positions(sweep);
    return sweep;
  }

 private:
  /// Node `local` of a quad, at the level k of a layer.
  Vec3 node(int quad, int layer, int k, int local) const {
    const std::size_t elem = static_cast<std::size_t>(layer) * mesh_.num_quads + quad;
    return mesh_.nodes[mesh_.elem_nodes[elem * mesh_.nodes_per_elem() + k * quad_size_ + local]];
  }
  Vec3 shift(int layer, int k) const { return node(0, layer, k, 0) - node(0, 0, 0, 0); }
  static double fraction(Vec3 shift, Vec3 way) { return dot(shift, way) / norm2(way); }

  bool is_planar(const BottomPlane& plane) const {
    return all_nodes([&](int quad, int local) {
      return std::abs(dot(node(quad, 0, 0, local) - plane.origin, plane.normal)) <= least_;
    });
  }

  bool is_moved(int layer, int k, Vec3 way) const {
    const Vec3 by = fraction(shift(layer, k), way) * way;
    return all_nodes([&](int quad, int local) {
      return distance(node(quad, layer, k, local), node(quad, 0, 0, local) + by) <= least_;
    });
  }

  template <typename Condition>
  bool all_nodes(const Condition& condition) const {
    for (int quad = 0; quad < mesh_.num_quads; ++quad)
      for (int local = 0; local < quad_size_; ++local)
        if (!condition(quad, local)) return false;
    return true;
  }

  void set_positions(StraightSweep& sweep) const {
    for (int quad = 0; quad < mesh_.num_quads; ++quad)
      for (int local = 0; local < quad_size_; ++local)
        sweep.quads.nodes[sweep.quads.elem_nodes[quad * quad_size_ + local]] = sweep.plane.at(node(quad, 0, 0, local));
    sweep.quads.face.diameter = mesh_.diameter;
  }

  const HexMesh& mesh_;
  double least_;
  int quad_size_;
};

/// The boundary of the bottom and of the top. Throws ComputeError if one of them has several names.
std::array<int, 2> end_boundaries(const HexMesh& mesh, const Groups& groups) {
  std::array<int, 2> ends{-1, -1};
  for (std::size_t g = 0; g < mesh.face_groups.size(); ++g)
    for (const int face : mesh.face_groups[g].faces) {
      if (face < 4) continue;
      int& end = ends[face - 4];
      if (end >= 0 && end != groups.curve2boundary[g])
        throw ComputeError("blockMeshDict has one patch for the bottom and one for the top: give --format polymesh");
      end = groups.curve2boundary[g];
    }
  return ends;
}

BlockMesh block_mesh(const StraightSweep& sweep, const PlateBlocks& plates) {
  return {plates, sweep.quads.nodes,
          [&sweep](Vec2 position, bool is_above) {
            std::array<double, 3> x = sweep.plane.at(position);
            if (is_above) x = {x[0] + sweep.way.x, x[1] + sweep.way.y, x[2] + sweep.way.z};
            return x;
          },
          sweep.layers};
}

}  // namespace

Exported block_mesh_dict(const HexMesh& mesh, const std::vector<PatchType>& types) {
  const Groups groups = mesh_groups(mesh);
  const std::optional<StraightSweep> sweep = StraightSweepFinder(mesh).found();
  if (!sweep)
    throw ComputeError(
        "blockMeshDict holds straight sweeps of planar faces only, and this one bends, turns, narrows or begins on a "
        "terrain: give --format polymesh");
  const std::array<int, 2> ends = end_boundaries(mesh, groups);
  const PlateBlocks plates = plate_blocks(sweep->quads, groups);
  Exported exported;
  exported.losses = block_mesh_losses(sweep->quads, plates);
  exported.add_loss(interface_loss(groups));
  exported.add_loss(periodic_loss(mesh, "polymesh has cyclic patches"));
  const PlainNames words = add_plain_names(groups, true, {}, exported);
  const std::vector<std::string> type_names = patch_types(mesh, groups, types);
  BlockMesh blocks = block_mesh(*sweep, plates);
  blocks.scale = metres_or_one(mesh.length_unit);
  blocks.zones = words.regions;
  for (int b = 0; b < groups.num_boundaries(); ++b) {
    BlockMeshPatch patch{words.boundaries[b], type_names[b], {}, blocks.side_faces(b)};
    for (int end = 0; end < 2; ++end)
      if (ends[end] == b)
        for (const std::array<int, 4>& face : blocks.end_faces(end == 1)) patch.faces.push_back(face);
    blocks.patches.push_back(std::move(patch));
  }
  exported.bytes = block_mesh_text(blocks);
  return exported;
}

}  // namespace quadrille::exports
