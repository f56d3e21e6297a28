#include <algorithm>
#include <map>

#include "export/groups.hpp"
#include "export/hex_blend.hpp"
#include "export/hex_numbering.hpp"
#include "export/hex_periodic.hpp"
#include "export/nektar_text.hpp"
#include "export/renode.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

int edge_between(int from, int to) {
  return static_cast<int>(std::find(hex_edge_corners.begin(), hex_edge_corners.end(), std::array<int, 2>{from, to}) -
                          hex_edge_corners.begin());
}

/// Writes a mesh that is turned along its chords.
class NektarHexWriter : NektarText {
 public:
  explicit NektarHexWriter(const HexMesh& mesh)
      : mesh_(mesh), numbering_(number_directed_parts(mesh)), groups_(mesh_groups(mesh)) {}

  std::string text() {
    begin(3, 3);
    write_vertices(positions_of(numbering_.vertices));
    begin_edges();
    for (int e = 0; e < numbering_.num_edges(); ++e) write_edge(e, numbering_.edges[e].vertices);
    end_edges();
    write_faces();
    write_elements();
    write_curves();
    write_composites();
    end(mesh_.order);
    return std::move(out_);
  }

  /// Groups whose faces are coupled in the order of their lists.
  bool are_coupled() const { return are_coupled_; }

 private:
  Points positions_of(const std::vector<int>& nodes) const {
    Points points;
    for (const int node : nodes) points.push_back({mesh_.nodes[node].x, mesh_.nodes[node].y, mesh_.nodes[node].z});
    return points;
  }

  /// Along the first direction, opposite to the second, and so on: the sides of a quad of Nektar++.
  std::array<int, 4> edges_of_face(const NumberedHexFace& face) const {
    const std::array<int, 4>& c = directed_hex_face_corners[face.face];
    const std::array<int, 4> local{edge_between(c[0], c[1]), edge_between(c[1], c[2]), edge_between(c[3], c[2]),
                                   edge_between(c[0], c[3])};
    std::array<int, 4> edges{};
    for (int k = 0; k < 4; ++k) edges[k] = numbering_.elem2edges[12 * face.elem + local[k]];
    return edges;
  }

  void write_faces() {
    print("    <FACE>\n");
    for (int f = 0; f < numbering_.num_faces(); ++f) {
      const std::array<int, 4> edges = edges_of_face(numbering_.faces[f]);
      print("      <Q ID=\"{}\">{} {} {} {}</Q>\n", f, edges[0], edges[1], edges[2], edges[3]);
    }
    print("    </FACE>\n");
  }

  void write_elements() {
    print("    <ELEMENT>\n");
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) {
      print("      <H ID=\"{}\">", elem);
      for (const int face : hex_face_order) print("{}{}", face == 4 ? "" : " ", numbering_.face(elem, face));
      print("</H>\n");
    }
    print("    </ELEMENT>\n");
  }

  /// Faces that are not the blend of their sides, with all their edges, and edges that are not straight. Nektar++
  /// treats the others as such, and detects parallelepipeds, for which it is faster.
  void write_curves() {
    if (mesh_.order == 1) return;
    std::vector<std::vector<int>> edges(numbering_.num_edges()), faces(numbering_.num_faces());
    for (int e = 0; e < numbering_.num_edges(); ++e) edges[e] = edge_nodes(mesh_, numbering_.edges[e]);
    std::vector<bool> is_curved(edges.size());
    for (std::size_t e = 0; e < edges.size(); ++e) is_curved[e] = !is_blend(mesh_, edges[e]);
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const NumberedHexFace& face = numbering_.faces[f];
      faces[f] = face_nodes(mesh_, face.elem, directed_hex_face_corners[face.face]);
      if (is_blend(mesh_, faces[f]))
        faces[f].clear();
      else
        for (const int edge : edges_of_face(face)) is_curved[edge] = true;
    }
    if (std::find(is_curved.begin(), is_curved.end(), true) == is_curved.end()) return;
    int id = 0;
    print("    <CURVED>\n");
    for (std::size_t e = 0; e < edges.size(); ++e)
      if (is_curved[e]) write_curve('E', "EDGEID", id++, static_cast<int>(e), positions_of(edges[e]));
    for (std::size_t f = 0; f < faces.size(); ++f)
      if (!faces[f].empty()) write_curve('F', "FACEID", id++, static_cast<int>(f), positions_of(faces[f]));
    print("    </CURVED>\n");
  }

  void write_composites() {
    std::vector<std::vector<int>> faces(groups_.num_boundaries() + groups_.num_interfaces()),
        regions(groups_.num_regions());
    for (std::size_t g = 0; g < mesh_.face_groups.size(); ++g)
      for (const GroupFace at : faces_once(mesh_.face_groups[g], numbering_))
        faces[groups_.curve2boundary[g]].push_back(numbering_.face(at.elem, at.face));
    for (int elem = 0; elem < mesh_.num_elems(); ++elem)
      regions[groups_.block2region[mesh_.quad_block[elem % mesh_.num_quads]]].push_back(elem);
    for (std::vector<int>& list : faces) std::sort(list.begin(), list.end());
    order_periodic_faces(faces);
    write_groups(groups_, 'F', faces, 'H', regions);
  }

  /// Nektar++ couples the faces of two periodic composites in the order of their lists. A composite of several groups
  /// has no one motion.
  void order_periodic_faces(std::vector<std::vector<int>>& lists) {
    std::map<int, int> images;
    std::map<int, int> neighbours;  // of composites
    for (const PeriodicFaces& pair : periodic_faces(mesh_)) {
      images[numbering_.face(pair.first.elem, pair.first.face)] = numbering_.face(pair.second.elem, pair.second.face);
      neighbours[groups_.curve2boundary[pair.group]] =
          groups_.curve2boundary[mesh_.face_groups[pair.group].periodic_with];
    }
    for (const auto& [first, second] : neighbours) {
      const std::vector<int>& from = lists[first];
      const bool is_whole = from.size() == lists[second].size() &&
                            std::all_of(from.begin(), from.end(), [&](int face) { return images.count(face) > 0; });
      are_coupled_ = are_coupled_ && is_whole;
      if (is_whole)
        std::transform(from.begin(), from.end(), lists[second].begin(), [&](int face) { return images.at(face); });
    }
  }

  const HexMesh& mesh_;
  HexNumbering numbering_;
  Groups groups_;
  bool are_coupled_ = true;
};

}  // namespace

Exported nektar_xml(const HexMesh& mesh) {
  Exported exported;
  const HexMesh turned = turned_along_chords(mesh);
  NektarHexWriter writer(turned);
  exported.bytes = writer.text();
  if (!writer.are_coupled()) exported.add_loss(periodic_loss(mesh, "a composite has faces of one motion only"));
  const double moved = face_blend_loss(mesh);
  if (moved > 1e-12 * mesh.diameter)
    exported.add_loss(
        "nodes inside elements are not stored; Nektar++ rebuilds them from the faces, which moves them by up "
        "to " +
        length_text(moved, mesh.diameter));
  add_nektar_names_loss(mesh_groups(mesh), exported);
  return exported;
}

}  // namespace quadrille::exports
