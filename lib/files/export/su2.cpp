#include <algorithm>

#include "export/groups.hpp"
#include "export/split_elements.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

/// VTK's numbers of these cells, which SU2 uses.
constexpr int line_cell = 3, quad_cell = 9;

class Su2Writer : TextWriter {
 public:
  Su2Writer(const QuadMesh& quads, const Frame& frame, const Groups& groups)
      : quads_(quads), frame_(frame), groups_(groups) {}

  std::string text(const NameList& markers) {
    print("NDIME= 2\n");
    write_elements();
    write_points();
    write_markers(markers);
    return std::move(out_);
  }

 private:
  void write_elements() {
    print("NELEM= {}\n", quads_.num_elems());
    for (int elem = 0; elem < quads_.num_elems(); ++elem) {
      print("{}", quad_cell);
      for (int corner = 0; corner < 4; ++corner) print(" {}", side_start(quads_, elem, corner));
      print(" {}\n", elem);
    }
  }

  void write_points() {
    print("NPOIN= {}\n", quads_.nodes.size());
    for (std::size_t node = 0; node < quads_.nodes.size(); ++node) {
      const std::array<double, 3> x = frame_.at(quads_.nodes[node]);
      print("{} {} {}\n", x[0], x[1], node);
    }
  }

  void write_markers(const NameList& markers) {
    std::vector<std::vector<QuadBoundaryEdge>> edges(markers.size());
    for (const QuadBoundaryEdge& e : quads_.boundary_edges) edges[groups_.curve2boundary[e.curve]].push_back(e);
    print("NMARK= {}\n", markers.size());
    for (std::size_t k = 0; k < markers.size(); ++k) {
      print("MARKER_TAG= {}\nMARKER_ELEMS= {}\n", markers[k], edges[k].size());
      for (const QuadBoundaryEdge& e : edges[k])
        print("{} {} {}\n", line_cell, side_node(quads_, e.elem, e.side, 0), side_node(quads_, e.elem, e.side, 1));
    }
  }

  const QuadMesh& quads_;
  const Frame& frame_;
  const Groups& groups_;
};

}  // namespace

Exported su2_mesh(const QuadMesh& mesh, const Frame& frame) {
  const QuadMesh quads = split_at_nodes(mesh);
  require_valid_pieces(quads, "SU2's cells");
  const Groups groups = mesh_groups(mesh);
  Exported exported;
  exported.add_loss(split_loss(mesh, quads));
  exported.add_loss(interface_loss(groups));
  exported.add_loss(region_loss(groups));
  const PlainNames words = add_plain_names(groups, false, {{"SEND_RECEIVE"}}, exported);
  exported.bytes = Su2Writer(quads, frame, groups).text(words.boundaries);
  return exported;
}

}  // namespace quadrille::exports
