#pragma once
// What Nektar++ files of quads and of hexahedra have in common. Private to nektar*.
//
// The XML is a fixed skeleton around numbers, so it is printed as it stands; a document tree of an XML library would
// store 100,000 quads several times, and only the escaping of names would be gained.

#include <array>
#include <string>
#include <vector>

#include "export/groups.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {

class NektarText : protected TextWriter {
 protected:
  using Points = std::vector<std::array<double, 3>>;

  void begin(int dim, int space);

  /// The vertices, and the edges by their vertices.
  void write_vertices(const Points& points);
  void begin_edges();
  void write_edge(int id, const std::array<int, 2>& vertices);
  void end_edges();

  /// A curve `id` at Gauss-Lobatto-Legendre points: E, EDGEID, or F, FACEID, of the entity `of`.
  void write_curve(char letter, const char* what, int id, int of, const Points& points);

  /// Composites and the domain. `boundaries`: members of each boundary and interface; `elements`: of each region. The
  /// letters say what the members are. Boundaries get the first numbers, then interfaces and regions, as in Gmsh's
  /// files.
  void write_groups(const Groups& groups, char boundary, const std::vector<std::vector<int>>& boundaries, char element,
                    const std::vector<std::vector<int>>& elements);

  /// A default expansion of the order of the geometry; a session file may replace it.
  void end(int order);

 private:
  void write_composite(int id, const std::string& name, char letter, const std::vector<int>& members);

  std::vector<int> region_ids_;
};

/// A sentence about names that XML cannot represent, if there are any.
void add_nektar_names_loss(const Groups& groups, Exported& exported);

}  // namespace quadrille::exports
