#pragma once
// What MFEM meshes of quads and of hexahedra have in common. Private to mfem*.

#include <string>
#include <vector>

#include "export/groups.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {

class MfemText : protected TextWriter {
 protected:
  /// The title, of v1.3 with names or of v1.0, and the dimension.
  void begin(bool with_names, int dim);

  /// Attributes from 1 by their names, one each.
  void write_sets(const char* title, const std::vector<std::string>& names);

  /// The head of a grid function of nodes. `kind`: H1, or L2_T1 (the discontinuous basis of Gauss-Lobatto nodes).
  void write_space(const char* kind, int dim, int order, int space_dim);
};

/// The table of names beside a mesh of v1.0, and a sentence about it.
void add_mfem_names(const Groups& groups, Exported& exported);

}  // namespace quadrille::exports
