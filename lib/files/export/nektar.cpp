// The XML is a fixed skeleton around numbers, so it is printed as it stands; a document tree of an XML library would
// store 100,000 quads several times, and only the escaping of names would be gained.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "export/edge_numbering.hpp"
#include "export/groups.hpp"
#include "export/patches.hpp"
#include "export/periodic_edges.hpp"
#include "export/renode.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

/// An element is the blend of its sides within this part of its shortest one: round-off would cost elements that are
/// listed as curved their constant Jacobian.
constexpr double blend_tol = 1e-10;

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

/// The value of an attribute. XML 1.0 cannot represent control characters.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += is_control(c) ? '_' : c;
  }
  return out;
}

/// "0-3,7": in their order, those that follow each other as ranges.
std::string ranges(const std::vector<int>& numbers) {
  std::string out;
  for (std::size_t k = 0; k < numbers.size();) {
    std::size_t last = k;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    out += fmt::format("{}{}", out.empty() ? "" : ",", numbers[k]);
    if (last > k) out += fmt::format("-{}", numbers[last]);
    k = last + 1;
  }
  return out;
}

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
class NektarWriter : TextWriter {
 public:
  NektarWriter(const QuadMesh& mesh, const Frame& frame)
      : mesh_(mesh), frame_(frame), edges_(number_directed_edges(mesh)), groups_(mesh_groups(mesh)) {}

  std::string text() {
    print("<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<NEKTAR>\n");
    print("  <GEOMETRY DIM=\"2\" SPACE=\"{}\">\n", space_dimension(mesh_, frame_));
    write_vertices();
    write_edges();
    write_elements();
    write_curves();
    write_composites();
    print("  </GEOMETRY>\n");
    write_expansions();
    print("</NEKTAR>\n");
    return std::move(out_);
  }

 private:
  /// With as many digits as needed to read back the same bits.
  void print_position(int node) {
    const auto x = position(mesh_, frame_, node);
    print("{} {} {}", x[0], x[1], x[2]);
  }

  void write_vertices() {
    print("    <VERTEX>\n");
    for (int v = 0; v < edges_.num_vertices(); ++v) {
      print("      <V ID=\"{}\">", v);
      print_position(edges_.vertices[v]);
      print("</V>\n");
    }
    print("    </VERTEX>\n");
  }

  void write_edges() {
    print("    <EDGE>\n");
    for (int e = 0; e < edges_.num_edges(); ++e)
      print("      <E ID=\"{}\">{} {}</E>\n", e, edges_.edges[e].vertices[0], edges_.edges[e].vertices[1]);
    print("    </EDGE>\n");
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
      const std::vector<int> nodes = edge_nodes(mesh_, edges_.edges[e]);
      write_curve('E', "EDGEID", id++, e, nodes.data(), nodes.size());
    }
    const int count = mesh_.nodes_per_elem();
    for (int elem = 0; elem < mesh_.num_elems(); ++elem)
      if (curved.faces[elem]) write_curve('F', "FACEID", id++, elem, &mesh_.elem_nodes[elem * count], count);
    print("    </CURVED>\n");
  }

  void write_curve(char letter, const char* what, int id, int of, const int* nodes, std::size_t count) {
    print("      <{} ID=\"{}\" {}=\"{}\" NUMPOINTS=\"{}\" TYPE=\"GaussLobattoLegendre\">", letter, id, what, of, count);
    for (std::size_t k = 0; k < count; ++k) {
      if (k > 0) print("  ");
      print_position(nodes[k]);
    }
    print("</{}>\n", letter);
  }

  /// Boundaries get the first numbers, then interfaces and regions, as in Gmsh's files.
  void write_composites() {
    std::vector<std::string> names = groups_.boundary_names;
    names.insert(names.end(), groups_.interface_names.begin(), groups_.interface_names.end());
    std::vector<std::vector<int>> lines(names.size()), regions(groups_.num_regions());
    for (const std::vector<QuadBoundaryEdge>& edges : {mesh_.boundary_edges, interface_edges_once(mesh_)})
      for (const QuadBoundaryEdge& e : edges)
        lines[groups_.curve2boundary[e.curve]].push_back(edges_.elem2edges[4 * e.elem + e.side]);
    for (int elem = 0; elem < mesh_.num_elems(); ++elem)
      regions[groups_.block2region[mesh_.elem_block[elem]]].push_back(elem);
    for (std::vector<int>& edges : lines) std::sort(edges.begin(), edges.end());
    order_periodic_edges(lines);
    int id = 1;
    print("    <COMPOSITE>\n");
    for (std::size_t b = 0; b < names.size(); ++b) write_composite(id++, names[b], 'E', lines[b]);
    for (int r = 0; r < groups_.num_regions(); ++r) {
      if (!regions[r].empty()) region_ids_.push_back(id);
      write_composite(id++, groups_.region_names[r], 'Q', regions[r]);
    }
    print("    </COMPOSITE>\n    <DOMAIN>\n      <D ID=\"0\"> C[{}] </D>\n    </DOMAIN>\n", ranges(region_ids_));
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

  void write_composite(int id, const std::string& name, char letter, const std::vector<int>& members) {
    if (members.empty()) return;  // an empty list is an error of the file
    print("      <C ID=\"{}\" NAME=\"{}\"> {}[{}] </C>\n", id, escaped(name), letter, ranges(members));
  }

  /// A default expansion of the order of the geometry; a session file may replace it.
  void write_expansions() {
    print("  <EXPANSIONS>\n    <E COMPOSITE=\"C[{}]\" NUMMODES=\"{}\" TYPE=\"MODIFIED\" FIELDS=\"u\" />\n",
          ranges(region_ids_), mesh_.order + 1);
    print("  </EXPANSIONS>\n");
  }

  const QuadMesh& mesh_;
  const Frame& frame_;
  EdgeNumbering edges_;
  Groups groups_;
  std::vector<int> region_ids_;
};

void report_losses(const QuadMesh& mesh, Exported& exported) {
  const Groups groups = mesh_groups(mesh);
  exported.add_loss(cyclic_loss(mesh.face, groups, cyclic_patches(mesh, groups, {}),
                                "a composite has periodic curves of one motion only"));
  std::size_t count = 0;
  for (const auto* names : {&groups.boundary_names, &groups.interface_names, &groups.region_names})
    count += std::count_if(names->begin(), names->end(),
                           [](const std::string& name) { return std::any_of(name.begin(), name.end(), is_control); });
  if (count > 0)
    exported.add_loss(
        fmt::format("XML cannot represent control characters: those of {} names are replaced by underscores", count));
}

}  // namespace

Exported nektar_xml(const QuadMesh& mesh, const Frame& frame) {
  Exported exported;
  exported.bytes = NektarWriter(turned_along_chords(mesh), frame).text();
  report_losses(mesh, exported);
  return exported;
}

}  // namespace quadrille::exports
