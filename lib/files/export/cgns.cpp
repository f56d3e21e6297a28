#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "export/cgns_request.hpp"
#include "export/cgns_words.hpp"
#include "export/groups.hpp"
#include "export/renode.hpp"
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
