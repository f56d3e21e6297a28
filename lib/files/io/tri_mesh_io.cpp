#include "io/describe.hpp"

namespace quadrille::io {

namespace {
// Not in the files of later stages, which hold the mesh as a group.
void describe_repairs(Archive& archive, std::vector<Repair>& repairs) {
  if (!archive.has("repairs")) return;
  archive.field("repairs", repairs, [](Archive& a, Repair& repair) {
    a.field("kind", repair.kind, {"", "joint, vertex, plane, edge or cusp"});
    a.field("cad_edge", repair.cad_edge, {"", "number of the edge in the CAD file"});
    a.field("position", repair.position, {"length", "in the coordinates of the CAD file"});
    a.field("distance", repair.distance, {"length", "how far it was moved"});
  });
}

}  // namespace

void describe_triangles(Archive& archive, TriMesh& mesh) {
  describe_face(archive, mesh.face);
  archive.field("order", mesh.order, {"", "shape order N of the curved elements"});
  archive.field("vertices", mesh.vertices, {"length", "relative to face.origin"});
  archive.field("elem2vertices", mesh.elem2vertices, {"", "vertices of each element, counter-clockwise"});
  archive.field("curved_elems", mesh.curved_elems, {"", "elements with geometry nodes, ascending"});
  archive.field("curved_nodes", mesh.curved_nodes, {"length", "(N+1)(N+2)/2 nodes per curved element"});
  archive.field("boundary_edges", mesh.boundary_edges, [](Archive& a, BoundaryEdge& edge) {
    a.field("elem", edge.elem, {"", "element"});
    a.field("edge", edge.edge, {"", "local edge 0, 1, 2"});
    a.field("curve", edge.curve, {"", "CAD curve"});
    a.field("t0", edge.t0, {"1", "parameter at its start"});
    a.field("t1", edge.t1, {"1", "parameter at its end"});
  });
  archive.field("elem_layer", mesh.elem_layer, {"", "layer in a corner fan, -1 outside fans"});
  archive.nonempty_field("region_elems", mesh.region_elems, {"", "region r holds elements region_elems[r] to [r+1]-1"});
}

void describe(Archive& archive, TriMesh& mesh) {
  describe_triangles(archive, mesh);
  describe_repairs(archive, mesh.repairs);
}

}  // namespace quadrille::io
