// Hexahedra: their outer faces, coloured by the scaled Jacobian of the elements behind them.

#include <fmt/format.h>

#include "base/message_text.hpp"
#include "draw/draw_in_space.hpp"
#include "mesh/outer_faces.hpp"

namespace quadrille::draw {

std::string draw_stage(const HexMesh& mesh, const DrawOptions& options) {
  const QuadMesh outer = mesh::outer_faces(mesh);
  const SpaceTitle title{"Hexahedral mesh", fmt::format("{}{} hexahedra of order {} in {}",
                                                        mesh.is_valid ? "" : "NOT VALID: ", mesh.num_elems(),
                                                        mesh.order, counted(mesh.num_layers(), "layer"))};
  const ViewDirection view = options.view ? *options.view : hex_view;
  return draw_in_space(outer, space_view(outer, view), options, title);
}

}  // namespace quadrille::draw
