// The XML is a fixed skeleton around numbers, so it is printed as it stands; a document tree of an XML library would
// store 100,000 quads several times, and only the escaping of names would be gained.
#include <algorithm>
#include <map>

#include "export/edge_numbering.hpp"
#include "export/groups.hpp"
#include "export/nektar_text.hpp"
#include "export/patches.hpp"
#include "export/periodic_edges.hpp"
#include "export/renode.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

/// An element is the blend of its sides within this part of its shortest one: round-off would cost elements that are
/// listed as curved their constant Jacobian.
constexpr double blend_tol = 1e-10;

/// The edges and faces written as curves: a face and all its edges for an element that is not the blend of its sides,
/// and every edge that is not a straight line. Nektar++ treats the others as straight, and detects parallelograms, for
/// which it is faster.
struct CurvedParts {
  std::vector<bool> edges, faces;
};

bool is_side_blend(const QuadMesh& mesh, int elem) {
  double shortest = mesh.face.diameter;
  for (int k = 0; k < 4; ++k)
    shortest = std::min(
        shortest, distance(mesh.nodes[side_start(mesh, elem, k)], mesh.nodes[side_start(mesh, elem, (k + 1) % 4)]));
  return distance_from_side_blend(mesh, elem) <= std::max(blend_tol * shortest, 1e-14 * mesh.face.diameter);
}

CurvedParts curved_parts(const QuadMesh& mesh, const EdgeNumbering& numbering) {
  CurvedParts curved{std::vector<bool>(numbering.num_edges()), std::vector<bool>(mesh.num_elems())};
  if (mesh.order == 1) return curved;
  for (int edge = 0; edge < numbering.num_edges(); ++edge)
    curved.edges[edge] = !is_straight_edge(mesh, edge_nodes(mesh, numbering.edges[edge]));
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    curved.faces[elem] = !is_side_blend(mesh, elem);
    for (int side = 0; side < 4 && curved.faces[elem]; ++side)
      curved.edges[numbering.elem2edges[4 * elem + side]] = true;
  }
  return curved;
}

/// Writes a mesh that is turned along its chords.
class NektarWriter : NektarText {
 public:
  NektarWriter(const QuadMesh& mesh, const Frame& frame)
      : mesh_(mesh), frame_(frame), edges_(number_directed_parts(mesh)), groups_(mesh_groups(mesh)) {}

  std::string text() {
    begin(2, space_dimension(mesh_, frame_));
    write_vertices(positions_of(edges_.vertices));
    begin_edges();
    for (int e = 0; e < edges_.num_edges(); ++e) write_edge(e, edges_.edges[e].vertices);
    end_edges();
    write_elements();
    write_curves();
    write_composites();
    end(mesh_.order);
    return std::move(out_);
  }

 private:
  std::vector<std::array<double, 3>> positions_of(const std::vector<int>& nodes) const {
    std::vector<std::array<double, 3>> points;
    for (const int node : nodes) points.push_back(position(mesh_, frame_, node));
    return points;
  }

  void write_elements() {
    print("    <ELEMENT>\n");
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) {
      const int* sides = &edges_.elem2edges[4 * elem];
      print("      <Q ID=\"{}\">{} {} {} {}</Q>\n", elem, sides[0], sides[1], sides[2], sides[3]);
    }
    print("    </ELEMENT>\n");
  }

  void write_curves() {
    const CurvedParts curved = curved_parts(mesh_, edges_);
    if (std::find(curved.edges.begin(), curved.edges.end(), true) == curved.edges.end()) return;
    int id = 0;
    print("    <CURVED>\n");
    for (int e = 0; e < edges_.num_edges(); ++e) {
      if (!curved.edges[e]) continue;
      write_curve('E', "EDGEID", id++, e, positions_of(edge_nodes(mesh_, edges_.edges[e])));
    }
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) {
      if (!curved.faces[elem]) continue;
      const auto first = mesh_.elem_nodes.begin() + static_cast<std::ptrdiff_t>(elem) * mesh_.nodes_per_elem();
      write_curve('F', "FACEID", id++, elem, positions_of({first, first + mesh_.nodes_per_elem()}));
    }
    print("    </CURVED>\n");
  }

  void write_composites() {
    std::vector<std::vector<int>> lines(groups_.num_boundaries() + groups_.num_interfaces()),
        regions(groups_.num_regions());
    for (const std::vector<QuadBoundaryEdge>& edges : {mesh_.boundary_edges, interface_edges_once(mesh_)})
      for (const QuadBoundaryEdge& e : edges)
        lines[groups_.curve2boundary[e.curve]].push_back(edges_.elem2edges[4 * e.elem + e.side]);
    for (int elem = 0; elem < mesh_.num_elems(); ++elem)
      regions[groups_.block2region[mesh_.elem_block[elem]]].push_back(elem);
    for (std::vector<int>& edges : lines) std::sort(edges.begin(), edges.end());
    order_periodic_edges(lines);
    write_groups(groups_, 'E', lines, 'Q', regions);
  }

  /// Nektar++ couples the edges of two periodic composites in the order of their lists.
  void order_periodic_edges(std::vector<std::vector<int>>& lines) {
    std::map<int, int> images;
    const auto edge = [this](int e) {
      return edges_.elem2edges[4 * mesh_.boundary_edges[e].elem + mesh_.boundary_edges[e].side];
    };
    for (const PeriodicEdges& pair : periodic_edges(mesh_)) images[edge(pair.first)] = edge(pair.second);
    const std::vector<CyclicPatch> cyclic = cyclic_patches(mesh_, groups_, {});
    for (std::size_t b = 0; b < cyclic.size(); ++b)
      if (cyclic[b].neighbour >= 0 && cyclic[b].is_first)
        std::transform(lines[b].begin(), lines[b].end(), lines[cyclic[b].neighbour].begin(),
                       [&](int of) { return images.at(of); });
  }

  const QuadMesh& mesh_;
  const Frame& frame_;
  EdgeNumbering edges_;
  Groups groups_;
};

void report_losses(const QuadMesh& mesh, Exported& exported) {
  const Groups groups = mesh_groups(mesh);
  exported.add_loss(cyclic_loss(mesh.face, groups, cyclic_patches(mesh, groups, {}),
                                "a composite has periodic curves of one motion only"));
  add_nektar_names_loss(groups, exported);
}

}  // namespace

Exported nektar_xml(const QuadMesh& mesh, const Frame& frame) {
  Exported exported;
  exported.bytes = NektarWriter(turned_along_chords(mesh), frame).text();
  report_losses(mesh, exported);
  return exported;
}

}  // namespace quadrille::exports
