// The XML is a fixed skeleton around numbers, so it is printed as it stands; a document tree of an XML library would
// store 100,000 quads several times, and only the escaping of names would be gained.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "export/cells.hpp"
#include "export/hex_blend.hpp"
#include "export/hex_periodic.hpp"
#include "export/patches.hpp"
#include "export/periodic_edges.hpp"
#include "export/renode.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

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

/// The edges, and the nodes of the faces, written as curves: a face and all its edges if it is not the blend of its
/// sides, and every edge that is not a straight line. Nektar++ treats the others as straight, and detects
/// parallelograms and parallelepipeds, for which it is faster.
struct CurvedParts {
  std::vector<bool> edges;
  std::vector<std::vector<int>> faces;  ///< empty: it is not curved
};

/// An element is the blend of its sides within this part of its shortest one: round-off would cost elements that are
/// listed as curved their constant Jacobian.
constexpr double blend_tol = 1e-10;

bool is_side_blend(const QuadMesh& mesh, int elem) {
  double shortest = mesh.face.diameter;
  for (int k = 0; k < 4; ++k)
    shortest = std::min(
        shortest, distance(mesh.nodes[side_start(mesh, elem, k)], mesh.nodes[side_start(mesh, elem, (k + 1) % 4)]));
  return distance_from_side_blend(mesh, elem) <= std::max(blend_tol * shortest, 1e-14 * mesh.face.diameter);
}

CurvedParts curved_parts(const QuadMesh& mesh, const EdgeNumbering& numbering) {
  CurvedParts curved{std::vector<bool>(numbering.num_edges()), std::vector<std::vector<int>>(mesh.num_elems())};
  for (int edge = 0; edge < numbering.num_edges(); ++edge)
    curved.edges[edge] = !is_straight_edge(mesh, edge_nodes(mesh, numbering.edges[edge]));
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    if (is_side_blend(mesh, elem)) continue;
    const int* const nodes = element_nodes(mesh, elem);
    curved.faces[elem].assign(nodes, nodes + mesh.nodes_per_elem());
    for (int side = 0; side < 4; ++side) curved.edges[numbering.elem2edges[4 * elem + side]] = true;
  }
  return curved;
}

int edge_between(int from, int to) {
  return static_cast<int>(std::find(hex_edge_corners.begin(), hex_edge_corners.end(), std::array<int, 2>{from, to}) -
                          hex_edge_corners.begin());
}

/// Along the first direction, opposite to the second, and so on: the sides of a quad of Nektar++.
std::array<int, 4> edges_of_face(const HexNumbering& numbering, const NumberedHexFace& face) {
  const std::array<int, 4>& c = directed_hex_face_corners[face.face];
  const std::array<int, 4> local{edge_between(c[0], c[1]), edge_between(c[1], c[2]), edge_between(c[3], c[2]),
                                 edge_between(c[0], c[3])};
  std::array<int, 4> edges{};
  for (int k = 0; k < 4; ++k) edges[k] = numbering.elem2edges[12 * face.elem + local[k]];
  return edges;
}

CurvedParts curved_parts(const HexMesh& mesh, const HexNumbering& numbering) {
  CurvedParts curved{std::vector<bool>(numbering.num_edges()), std::vector<std::vector<int>>(numbering.num_faces())};
  for (int edge = 0; edge < numbering.num_edges(); ++edge)
    curved.edges[edge] = !is_blend(mesh, edge_nodes(mesh, numbering.edges[edge]));
  for (int f = 0; f < numbering.num_faces(); ++f) {
    const NumberedHexFace& face = numbering.faces[f];
    const std::vector<int> nodes = face_nodes(mesh, face.elem, directed_hex_face_corners[face.face]);
    if (is_blend(mesh, nodes)) continue;
    curved.faces[f] = nodes;
    for (const int edge : edges_of_face(numbering, face)) curved.edges[edge] = true;
  }
  return curved;
}

using MemberLists = std::vector<std::vector<int>>;  ///< edges or faces of each boundary and interface

/// Nektar++ couples the edges of two periodic composites in the order of their lists. Returns the loss of those that
/// are not coupled, empty if there are none.
std::string order_periodic_sides(const QuadMesh& mesh, const EdgeNumbering& numbering, const Groups& groups,
                                 MemberLists& lists) {
  std::map<int, int> images;
  const auto edge = [&](int e) {
    return numbering.elem2edges[4 * mesh.boundary_edges[e].elem + mesh.boundary_edges[e].side];
  };
  for (const PeriodicEdges& pair : periodic_edges(mesh)) images[edge(pair.first)] = edge(pair.second);
  const std::vector<CyclicPatch> cyclic = cyclic_patches(mesh, groups, {});
  for (std::size_t b = 0; b < cyclic.size(); ++b)
    if (cyclic[b].neighbour >= 0 && cyclic[b].is_first)
      std::transform(lists[b].begin(), lists[b].end(), lists[cyclic[b].neighbour].begin(),
                     [&](int of) { return images.at(of); });
  return cyclic_loss(mesh.face, groups, cyclic, "a composite has periodic curves of one motion only");
}

/// The same of faces: a composite of several groups without one motion is not coupled.
std::string order_periodic_sides(const HexMesh& mesh, const HexNumbering& numbering, const Groups& groups,
                                 MemberLists& lists) {
  std::map<int, int> images;
  std::map<int, int> neighbours;  // of composites
  for (const PeriodicFaces& pair : periodic_faces(mesh)) {
    images[numbering.face(pair.first.elem, pair.first.face)] = numbering.face(pair.second.elem, pair.second.face);
    neighbours[groups.curve2boundary[pair.group]] = groups.curve2boundary[mesh.face_groups[pair.group].periodic_with];
  }
  bool are_coupled = true;
  for (const auto& [first, second] : neighbours) {
    const std::vector<int>& from = lists[first];
    const bool is_whole = from.size() == lists[second].size() &&
                          std::all_of(from.begin(), from.end(), [&](int face) { return images.count(face) > 0; });
    are_coupled = are_coupled && is_whole;
    if (is_whole)
      std::transform(from.begin(), from.end(), lists[second].begin(), [&](int face) { return images.at(face); });
  }
  return are_coupled ? "" : periodic_loss(mesh, "a composite has faces of one motion only");
}

/// Writes a mesh that is turned along its chords.
template <typename Mesh>
class NektarWriter : TextWriter {
 public:
  NektarWriter(const Mesh& mesh, std::vector<std::array<double, 3>> positions, const Groups& groups)
      : mesh_(mesh), positions_(std::move(positions)), numbering_(number_directed_parts(mesh)), groups_(groups) {}

  /// The file, and the loss of periodic sides.
  Exported exported(int space_dim) {
    print("<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<NEKTAR>\n");
    print("  <GEOMETRY DIM=\"{}\" SPACE=\"{}\">\n", mesh_dimension<Mesh>, space_dim);
    write_vertices();
    print("    <EDGE>\n");
    for (int e = 0; e < numbering_.num_edges(); ++e)
      print("      <E ID=\"{}\">{} {}</E>\n", e, numbering_.edges[e].vertices[0], numbering_.edges[e].vertices[1]);
    print("    </EDGE>\n");
    if constexpr (is_hex) write_faces();
    write_elements();
    if (mesh_.order > 1) write_curves();
    write_composites();
    // A default expansion of the order of the geometry; a session file may replace it.
    print(
        "  </GEOMETRY>\n  <EXPANSIONS>\n    <E COMPOSITE=\"C[{}]\" NUMMODES=\"{}\" TYPE=\"MODIFIED\" FIELDS=\"u\" />\n",
        ranges(region_ids_), mesh_.order + 1);
    print("  </EXPANSIONS>\n</NEKTAR>\n");
    Exported result;
    result.bytes = std::move(out_);
    result.add_loss(periodic_loss_);
    return result;
  }

 private:
  static constexpr bool is_hex = mesh_dimension<Mesh> == 3;

  // Numbers have as many digits as needed to read back the same bits.
  void write_vertices() {
    print("    <VERTEX>\n");
    for (int v = 0; v < numbering_.num_vertices(); ++v) {
      const auto& [x, y, z] = positions_[numbering_.vertices[v]];
      print("      <V ID=\"{}\">{} {} {}</V>\n", v, x, y, z);
    }
    print("    </VERTEX>\n");
  }

  void write_quad(int id, const int* edges) {
    print("      <Q ID=\"{}\">{} {} {} {}</Q>\n", id, edges[0], edges[1], edges[2], edges[3]);
  }

  void write_faces() {
    print("    <FACE>\n");
    for (int f = 0; f < numbering_.num_faces(); ++f)
      write_quad(f, edges_of_face(numbering_, numbering_.faces[f]).data());
    print("    </FACE>\n");
  }

  void write_elements() {
    print("    <ELEMENT>\n");
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) {
      if constexpr (is_hex) {
        print("      <H ID=\"{}\">", elem);
        for (const int face : hex_face_order) print("{}{}", face == 4 ? "" : " ", numbering_.face(elem, face));
        print("</H>\n");
      } else {
        write_quad(elem, &numbering_.elem2edges[4 * elem]);
      }
    }
    print("    </ELEMENT>\n");
  }

  void write_curves() {
    const auto [edges, faces] = curved_parts(mesh_, numbering_);
    if (std::find(edges.begin(), edges.end(), true) == edges.end()) return;
    int id = 0;
    print("    <CURVED>\n");
    for (std::size_t e = 0; e < edges.size(); ++e)
      if (edges[e]) write_curve('E', "EDGEID", id++, e, edge_nodes(mesh_, numbering_.edges[e]));
    for (std::size_t f = 0; f < faces.size(); ++f)
      if (!faces[f].empty()) write_curve('F', "FACEID", id++, f, faces[f]);
    print("    </CURVED>\n");
  }

  /// A curve `id` at Gauss-Lobatto-Legendre points, of the edge or face `of`.
  void write_curve(char letter, const char* what, int id, std::size_t of, const std::vector<int>& nodes) {
    print("      <{} ID=\"{}\" {}=\"{}\" NUMPOINTS=\"{}\" TYPE=\"GaussLobattoLegendre\">", letter, id, what, of,
          nodes.size());
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const auto& [x, y, z] = positions_[nodes[k]];
      print("{}{} {} {}", k > 0 ? "  " : "", x, y, z);
    }
    print("</{}>\n", letter);
  }

  int number_of(const GroupSide& at) const {
    if constexpr (is_hex)
      return numbering_.face(at.elem, at.side);
    else
      return numbering_.elem2edges[4 * at.elem + at.side];
  }

  /// Composites and the domain. Boundaries get the first numbers, then interfaces and regions, as in Gmsh's files.
  void write_composites() {
    const std::vector<std::string> names = boundary_and_interface_names(groups_);
    MemberLists sides(names.size());
    for (const GroupSide& at : group_sides(mesh_, groups_, numbering_)) sides[at.group].push_back(number_of(at));
    for (std::vector<int>& list : sides) std::sort(list.begin(), list.end());
    periodic_loss_ = order_periodic_sides(mesh_, numbering_, groups_, sides);
    int id = 1;
    print("    <COMPOSITE>\n");
    for (std::size_t b = 0; b < names.size(); ++b) write_composite(id++, names[b], is_hex ? 'F' : 'E', sides[b]);
    const MemberLists regions = elements_by_region(mesh_, groups_);
    for (std::size_t r = 0; r < regions.size(); ++r) {
      if (!regions[r].empty()) region_ids_.push_back(id);
      write_composite(id++, groups_.region_names[r], is_hex ? 'H' : 'Q', regions[r]);
    }
    print("    </COMPOSITE>\n    <DOMAIN>\n      <D ID=\"0\"> C[{}] </D>\n    </DOMAIN>\n", ranges(region_ids_));
  }

  void write_composite(int id, const std::string& name, char letter, const std::vector<int>& members) {
    if (members.empty()) return;  // an empty list is an error of the file
    print("      <C ID=\"{}\" NAME=\"{}\"> {}[{}] </C>\n", id, escaped(name), letter, ranges(members));
  }

  const Mesh& mesh_;
  std::vector<std::array<double, 3>> positions_;
  decltype(number_directed_parts(std::declval<Mesh>())) numbering_;
  const Groups& groups_;
  std::vector<int> region_ids_;
  std::string periodic_loss_;
};

/// A sentence about names that XML cannot represent, if there are any.
void add_nektar_names_loss(const Groups& groups, Exported& exported) {
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
  const QuadMesh turned = turned_along_chords(mesh);
  const Groups groups = mesh_groups(mesh);
  Exported exported = NektarWriter(turned, positions(turned, frame, ElementPoints::nodes), groups)
                          .exported(space_dimension(mesh, frame));
  add_nektar_names_loss(groups, exported);
  return exported;
}

Exported nektar_xml(const HexMesh& mesh) {
  const HexMesh turned = turned_along_chords(mesh);
  const Groups groups = mesh_groups(mesh);
  Exported exported = NektarWriter(turned, positions(turned, ElementPoints::nodes), groups).exported(3);
  const double moved = face_blend_loss(mesh);
  if (moved > 1e-12 * mesh.diameter)
    exported.add_loss(
        "nodes inside elements are not stored; Nektar++ rebuilds them from the faces, which moves them by up "
        "to " +
        length_text(moved, mesh.diameter));
  add_nektar_names_loss(groups, exported);
  return exported;
}

}  // namespace quadrille::exports
