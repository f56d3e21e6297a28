#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "export/cgns_request.hpp"
#include "export/cgns_words.hpp"
#include "export/groups.hpp"
#include "export/multi_block.hpp"
#include "export/renode.hpp"
#include "export/split_elements.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

std::vector<std::vector<double>> coordinates(const QuadMesh& mesh, const Frame& frame, const std::vector<int>& nodes,
                                             const std::vector<std::array<double, 3>>& positions) {
  std::vector<std::vector<double>> x(space_dimension(mesh, frame));
  for (const int node : nodes)
    for (std::size_t c = 0; c < x.size(); ++c) x[c].push_back(positions[node][c]);
  return x;
}

// Structured zones.

std::array<std::int64_t, 4> point_range(const MultiBlock& blocks, const SideRange& range, int from, int to) {
  const auto [i0, j0] = blocks.point(range, from);
  const auto [i1, j1] = blocks.point(range, to);
  return {i0 + 1, j0 + 1, i1 + 1, j1 + 1};
}

/// Own direction -> donor's: along the sides against each other, across them out of the one and into the other.
std::array<std::int64_t, 2> transform(const SideRange& own, const SideRange& donor) {
  const auto sign = [](const SideRange& r) { return r.side < 2 ? 1 : -1; };  // along the side, counter-clockwise
  const auto outwards = [](const SideRange& r) {
    return r.side % 3 == 0 ? -1 : 1;
  };  // sides 1 and 2 are the upper ones
  const int own_along = own.side % 2, donor_along = donor.side % 2;
  std::array<std::int64_t, 2> result{};
  result[own_along] = -sign(own) * sign(donor) * (donor_along + 1);
  result[1 - own_along] = -outwards(own) * outwards(donor) * (2 - donor_along);
  return result;
}

std::string zone_name(int grid) { return fmt::format("block_{}", grid); }

CgnsConnection connection(const MultiBlock& blocks, const SideRange& own, const SideRange& donor, std::size_t number) {
  const bool is_rising = own.side < 2;
  const auto of = [&](const SideRange& range, bool forward) {
    return point_range(blocks, range, forward ? range.begin : range.end, forward ? range.end : range.begin);
  };
  return {fmt::format("connection_{}", number), zone_name(donor.grid), of(own, is_rising), of(donor, !is_rising),
          transform(own, donor)};
}

std::vector<CgnsZone> structured_zones(const MultiBlock& blocks, const Groups& groups, const PlainNames& words,
                                       const Frame& frame) {
  const std::vector<std::array<double, 3>> x = positions(blocks.quads, frame, ElementPoints::equispaced);
  std::vector<CgnsZone> zones;
  for (int g = 0; g < static_cast<int>(blocks.grids.size()); ++g) {
    const BlockGrid& grid = blocks.grids[g];
    CgnsZone zone;
    zone.name = zone_name(g);
    zone.family = words.regions[groups.block2region[grid.block]];
    zone.size = {grid.num_i + 1, grid.num_j + 1};
    zone.x = coordinates(blocks.quads, frame, grid.vertices(blocks.quads), x);
    zones.push_back(std::move(zone));
  }
  for (const BoundaryRange& b : blocks.boundaries) {
    CgnsZone& zone = zones[b.range.grid];
    const bool is_rising = b.range.side < 2;
    zone.boundaries.push_back({fmt::format("side_{}", zone.boundaries.size() + 1), words.boundaries[b.boundary],
                               point_range(blocks, b.range, is_rising ? b.range.begin : b.range.end,
                                           is_rising ? b.range.end : b.range.begin)});
  }
  for (const GridConnection& c : blocks.connections)
    for (const auto& [own, donor] : {std::pair{c.first, c.second}, {c.second, c.first}}) {
      std::vector<CgnsConnection>& all = zones[own.grid].connections;
      all.push_back(connection(blocks, own, donor, all.size() + 1));
    }
  return zones;
}

// The unstructured zone.

class UnstructuredZone {
 public:
  UnstructuredZone(const QuadMesh& mesh, const Groups& lines, const PlainNames& words)
      : mesh_(mesh), lines_(lines), words_(words) {}

  CgnsZone zone(const Frame& frame, int num_boundaries) {
    const std::vector<std::array<double, 3>> x = positions(mesh_, frame, ElementPoints::equispaced);
    std::vector<int> all(mesh_.nodes.size());
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = static_cast<int>(k);
    zone_.name = "zone";
    zone_.size = {static_cast<std::int64_t>(all.size()), mesh_.num_elems()};
    zone_.x = coordinates(mesh_, frame, all, x);
    for (std::size_t region = 0; region < words_.regions.size(); ++region) add_quads(static_cast<int>(region));
    for (std::size_t line = 0; line < words_.boundaries.size(); ++line)
      add_bars(static_cast<int>(line), num_boundaries);
    return std::move(zone_);
  }

 private:
  void add_quads(int region) {
    CgnsSection section = sections_.begin(words_.regions[region], cgns_quad_types[mesh_.order]);
    const std::vector<int> order = cgns_quad_order(mesh_.order);
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) {
      if (lines_.block2region[mesh_.elem_block[elem]] != region) continue;
      for (const int local : order)
        section.nodes.push_back(mesh_.elem_nodes[elem * mesh_.nodes_per_elem() + local] + 1);
      ++section.count;
    }
    sections_.add(std::move(section), false, zone_);
  }

  void add_bars(int line, int num_boundaries) {
    CgnsSection section = sections_.begin(words_.boundaries[line], bar_types[mesh_.order]);
    std::vector<QuadBoundaryEdge> edges = mesh_.boundary_edges;
    const std::vector<QuadBoundaryEdge> inner = interface_edges_once(mesh_);
    edges.insert(edges.end(), inner.begin(), inner.end());
    for (const QuadBoundaryEdge& e : edges) {
      if (lines_.curve2boundary[e.curve] != line) continue;
      for (const int k : {0, mesh_.order}) section.nodes.push_back(side_node(mesh_, e.elem, e.side, k) + 1);
      for (int k = 1; k < mesh_.order; ++k) section.nodes.push_back(side_node(mesh_, e.elem, e.side, k) + 1);
      ++section.count;
    }
    sections_.add(std::move(section), line < num_boundaries, zone_);
  }

  const QuadMesh& mesh_;
  const Groups& lines_;
  const PlainNames& words_;
  CgnsZone zone_;
  CgnsSections sections_;
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
  exported.bytes = to_bytes({true, 2, families(groups, words, groups.num_boundaries()),
                             structured_zones(blocks, mesh_groups(blocks.quads), words, frame)});
  return exported;
}

Exported cgns_unstructured(const QuadMesh& mesh, const Frame& frame) {
  const Groups groups = mesh_groups(mesh), lines = lines_as_boundaries(groups);
  Exported exported;
  exported.is_binary = true;
  const PlainNames words = family_names(lines, exported);
  CgnsRequest request{false, 2, families(lines, words, groups.num_boundaries()), {}};
  request.zones.push_back(UnstructuredZone(mesh, lines, words).zone(frame, groups.num_boundaries()));
  exported.bytes = to_bytes(request);
  return exported;
}

}  // namespace quadrille::exports
