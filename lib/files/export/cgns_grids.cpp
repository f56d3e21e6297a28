#include <fmt/format.h>

#include <utility>

#include "export/cgns_request.hpp"
#include "export/cgns_words.hpp"
#include "export/groups.hpp"
#include "export/hex_periodic.hpp"
#include "export/multi_block.hpp"
#include "export/renode.hpp"
#include "export/split_elements.hpp"
#include "export/split_hexes.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

std::string zone_name(int grid) { return fmt::format("block_{}", grid); }

/// Structured zones of quads or of hexahedra, whose ranges along sides have all levels.
class StructuredZones {
 public:
  StructuredZones(const MultiBlock& blocks, const PlainNames& words)
      : blocks_(blocks), words_(words), is_solid_(!blocks.columns.empty()) {}

  /// `x`: coordinates of mesh nodes, of which the first `dimension` are written. `region_of`: of a grid.
  template <typename RegionOf>
  std::vector<CgnsZone> zones(const std::vector<std::array<double, 3>>& x, int dimension, const RegionOf& region_of) {
    for (int g = 0; g < static_cast<int>(blocks_.grids.size()); ++g) {
      const BlockGrid& grid = blocks_.grids[g];
      CgnsZone zone;
      zone.name = zone_name(g);
      zone.family = words_.regions[region_of(grid)];
      zone.size = point(grid.num_i, grid.num_j, blocks_.num_levels - 1);
      zone.x.resize(dimension);
      for (const int node : blocks_.points(grid))
        for (int c = 0; c < dimension; ++c) zone.x[c].push_back(x[node][c]);
      zones_.push_back(std::move(zone));
    }
    for (const BoundaryRange& b : blocks_.boundaries)
      add_boundary(b.range.grid, b.boundary, point_range(b.range, is_rising(b.range)));
    for (int g = 0; g < static_cast<int>(blocks_.ends.size()); ++g) add_ends(g);
    for (const GridConnection& c : blocks_.connections)
      for (const auto& [own, donor] : {std::pair{c.first, c.second}, {c.second, c.first}})
        add_connection(own.grid, donor.grid, point_range(own, is_rising(own)), point_range(donor, !is_rising(own)),
                       transform(own, donor));
    return std::move(zones_);
  }

 private:
  using Numbers = std::vector<std::int64_t>;

  /// Whether i or j rises along the side.
  static bool is_rising(const SideRange& range) { return range.side < 2; }

  /// Numbers of a point from 1.
  Numbers point(int i, int j, int level) const {
    return is_solid_ ? Numbers{i + 1, j + 1, level + 1} : Numbers{i + 1, j + 1};
  }

  static Numbers joined(Numbers first, const Numbers& last) {
    first.insert(first.end(), last.begin(), last.end());
    return first;
  }

  Numbers point_range(const SideRange& range, bool forward) const {
    const auto [i0, j0] = blocks_.point(range, forward ? range.begin : range.end);
    const auto [i1, j1] = blocks_.point(range, forward ? range.end : range.begin);
    return joined(point(i0, j0, 0), point(i1, j1, blocks_.num_levels - 1));
  }

  Numbers end_range(int g, int level) const {
    return joined(point(0, 0, level), point(blocks_.grids[g].num_i, blocks_.grids[g].num_j, level));
  }

  /// Own direction -> donor's: along the sides against each other, across them out of the one and into the other.
  Numbers transform(const SideRange& own, const SideRange& donor) const {
    const auto sign = [](const SideRange& r) { return is_rising(r) ? 1 : -1; };
    const auto outwards = [](const SideRange& r) { return r.side % 3 == 0 ? -1 : 1; };  // sides 1, 2 are the upper ones
    const int own_along = own.side % 2, donor_along = donor.side % 2;
    Numbers result(2);
    result[own_along] = -sign(own) * sign(donor) * (donor_along + 1);
    result[1 - own_along] = -outwards(own) * outwards(donor) * (2 - donor_along);
    if (is_solid_) result.push_back(3);
    return result;
  }

  void add_boundary(int g, int boundary, Numbers range) {
    std::vector<CgnsBoundary>& all = zones_[g].boundaries;
    all.push_back({fmt::format("side_{}", all.size() + 1), words_.boundaries[boundary], std::move(range)});
  }

  void add_connection(int own, int donor, Numbers range, Numbers donor_range, Numbers transform) {
    std::vector<CgnsConnection>& all = zones_[own].connections;
    all.push_back({fmt::format("connection_{}", all.size() + 1), zone_name(donor), std::move(range),
                   std::move(donor_range), std::move(transform)});
  }

  /// Bottom and top; of a full turn each is the other.
  void add_ends(int g) {
    const std::array<Numbers, 2> ranges{end_range(g, 0), end_range(g, blocks_.num_levels - 1)};
    for (int end = 0; end < 2; ++end)
      if (const int boundary = blocks_.ends[g][end]; boundary >= 0)
        add_boundary(g, boundary, ranges[end]);
      else
        add_connection(g, g, ranges[end], ranges[1 - end], {1, 2, 3});
  }

  const MultiBlock& blocks_;
  const PlainNames& words_;
  bool is_solid_ = false;
  std::vector<CgnsZone> zones_;
};

}  // namespace

Exported cgns_structured(const QuadMesh& mesh, const Frame& frame) {
  const Groups groups = mesh_groups(mesh);
  const MultiBlock blocks = multi_block(mesh, groups);
  Exported exported;
  exported.is_binary = true;
  exported.add_loss(split_loss(mesh, blocks.quads));
  exported.add_loss(interface_loss(groups));
  const PlainNames words = family_names(groups, exported);
  // Blocks may have been divided further; regions are those of the mesh.
  const Groups of_grids = mesh_groups(blocks.quads);
  exported.bytes =
      to_bytes({true, 2, families(groups, words, groups.num_boundaries()),
                StructuredZones(blocks, words)
                    .zones(positions(blocks.quads, frame, ElementPoints::equispaced), space_dimension(mesh, frame),
                           [&](const BlockGrid& grid) { return of_grids.block2region[grid.block]; })});
  return exported;
}

Exported cgns_structured(const HexMesh& mesh) {
  const HexMesh cells = split_at_nodes(mesh);
  require_valid_pieces(cells, "Cells");
  const Groups groups = mesh_groups(cells);
  const MultiBlock blocks = multi_block(cells, groups);
  Exported exported;
  exported.is_binary = true;
  exported.add_loss(split_loss(mesh));
  exported.add_loss(interface_loss(groups));
  exported.add_loss(periodic_loss(mesh));
  const PlainNames words = family_names(groups, exported);
  std::vector<std::array<double, 3>> x;
  for (const Vec3 node : cells.nodes) x.push_back({node.x, node.y, node.z});
  exported.bytes = to_bytes({true, 3, families(groups, words, groups.num_boundaries()),
                             StructuredZones(blocks, words).zones(x, 3, [&](const BlockGrid& grid) {
                               return groups.block2region[cells.quad_block[grid.cells.front().elem]];
                             })});
  return exported;
}

}  // namespace quadrille::exports
