#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "export/groups.hpp"
#include "export/hex_blend.hpp"
#include "export/hex_numbering.hpp"
#include "export/hex_periodic.hpp"
#include "export/nek_bytes.hpp"
#include "export/renode.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {

namespace {

/// Nek5000's corners, edges (those of the bottom, of the top, upright) and faces (sides, bottom, top) have the numbers
/// of hex_numbering and of HexMesh plus 1.
class Re2HexWriter : NekRe2Bytes {
 public:
  Re2HexWriter(const HexMesh& mesh, const Groups& groups)
      : mesh_(mesh), groups_(groups), numbering_(number_hexes(mesh)) {
    require_known_by_vertices(mesh, numbering_, "Nek5000");
  }

  std::string bytes() {
    begin(mesh_.num_elems(), 3);
    write_corners();
    write_curved_edges();
    write_boundaries();
    return std::move(out_);
  }

 private:
  void write_corners() {
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) {
      // Group of material properties: 0 in a body of one region.
      put(groups_.num_regions() > 1 ? 1 + groups_.block2region[mesh_.quad_block[elem % mesh_.num_quads]] : 0);
      for (double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z})
        for (int corner = 0; corner < 8; ++corner)
          put(mesh_.nodes[numbering_.vertices[numbering_.vertex(elem, corner)]].*axis);
    }
  }

  void write_curved_edges() {
    std::vector<bool> is_curved;
    std::vector<Vec3> middles;
    for (const NumberedHexEdge& edge : numbering_.edges) {
      const std::vector<int> nodes = edge_nodes(mesh_, edge);
      is_curved.push_back(!is_blend(mesh_, nodes));
      middles.push_back(edge_middle(mesh_, nodes));
    }
    const std::vector<int>& edges = numbering_.elem2edges;
    put(static_cast<double>(std::count_if(edges.begin(), edges.end(), [&](int edge) { return is_curved[edge]; })));
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const Vec3 x = middles[edges[k]];
      if (is_curved[edges[k]])
        write_record(static_cast<int>(k / 12), static_cast<int>(k % 12), {x.x, x.y, x.z, 0, 0}, "m");
    }
  }

  struct Boundary {
    GroupFace at;
    int number = 0;  ///< of the name, from 1
  };

  void write_boundaries() {
    std::vector<Boundary> faces;
    for (std::size_t g = 0; g < mesh_.face_groups.size(); ++g)
      if (!mesh_.face_groups[g].is_interface)
        for (const GroupFace at : faces_once(mesh_.face_groups[g], numbering_))
          faces.push_back({at, 1 + groups_.curve2boundary[g]});
    std::sort(faces.begin(), faces.end(), [](const Boundary& a, const Boundary& b) {
      return std::tie(a.at.elem, a.at.face) < std::tie(b.at.elem, b.at.face);
    });
    std::map<std::pair<int, int>, GroupFace> partners;  // by element and face
    for (const PeriodicFaces& pair : periodic_faces(mesh_)) {
      partners[{pair.first.elem, pair.first.face}] = pair.second;
      partners[{pair.second.elem, pair.second.face}] = pair.first;
    }
    put(static_cast<double>(faces.size()));
    for (const auto& [at, number] : faces)
      if (const auto partner = partners.find({at.elem, at.face}); partner != partners.end())
        write_record(at.elem, at.face,
                     {1.0 + partner->second.elem, 1.0 + partner->second.face, 0, 0, static_cast<double>(number)}, "P");
      else
        write_record(at.elem, at.face, {0, 0, 0, 0, static_cast<double>(number)}, "MSH");
  }

  const HexMesh& mesh_;
  const Groups& groups_;
  HexNumbering numbering_;
};

void report_losses(const HexMesh& mesh, const Groups& groups, Exported& exported) {
  const QuadraticEdgeLoss loss = quadratic_edge_loss(mesh, "Nek5000");
  const double least = 1e-12 * mesh.diameter;
  if (loss.edges > least)
    exported.add_loss(fmt::format(
        "edges are stored as parabolas, which moves them by up to {}; *0.f00000 contains the geometry of order {}",
        length_text(loss.edges, mesh.diameter), mesh.order));
  else if (loss.others > least)
    exported.add_loss(
        fmt::format("nodes on faces and inside elements are rebuilt from the edges, which moves them by up to {}; "
                    "*0.f00000 contains the original ones",
                    length_text(loss.others, mesh.diameter)));
  exported.add_loss("names are stored as numbers, which *.names.json lists");
  exported.add_loss(interface_loss(groups));
}

}  // namespace

Exported nek_re2(const HexMesh& mesh) {
  const Groups groups = mesh_groups(mesh);
  Exported exported;
  report_losses(mesh, groups, exported);
  exported.bytes = Re2HexWriter(mesh, groups).bytes();
  exported.is_binary = true;
  exported.side_files.push_back(
      names_table(groups, groups.boundary_names, groups.num_regions() > 1 ? groups.region_names : NameList()));
  if (mesh.order > 1) {
    std::vector<std::array<double, 3>> points;
    for (const Vec3 x : mesh.nodes) points.push_back({x.x, x.y, x.z});
    exported.side_files.push_back({nek_field_name, nek_geometry_field(mesh.order, 3, mesh.elem_nodes, points), true});
  }
  return exported;
}

}  // namespace quadrille::exports
