#include "export/serendipity.hpp"

#include <fmt/format.h>

#include "export/cells.hpp"
#include "export/hex_blend.hpp"
#include "export/renode.hpp"

namespace quadrille::exports {

namespace {

template <typename Mesh>
std::vector<int> numbers_on_edges(const Mesh& mesh) {
  std::vector<int> numbers(mesh.nodes.size(), 0);
  const std::size_t size = mesh.nodes_per_elem();
  for (std::size_t k = 0; k < mesh.elem_nodes.size(); ++k)
    if (inner_coordinates(mesh.order, mesh_dimension<Mesh>, static_cast<int>(k % size)) <= 1)
      numbers[mesh.elem_nodes[k]] = 1;
  int count = 0;
  for (int& number : numbers)
    if (number > 0) number = ++count;
  return numbers;
}

}  // namespace

std::vector<int> serendipity_numbers(const QuadMesh& quads) { return numbers_on_edges(quads); }
std::vector<int> serendipity_numbers(const HexMesh& mesh) { return numbers_on_edges(mesh); }

std::string serendipity_loss(const QuadMesh& quads, const char* reader) {
  if (quads.order == 1) return {};
  const double moved = transfinite_loss(quads, RebuiltFrom::sides, reader).interior;
  if (moved <= 1e-12 * quads.face.diameter) return {};
  return fmt::format("nodes in the middle of elements are not stored, which moves these middles by up to {}",
                     length_text(moved, quads.face.diameter));
}

std::string serendipity_loss(const HexMesh& mesh, const char* reader) {
  if (mesh.order == 1) return {};
  const double moved = quadratic_edge_loss(mesh, reader).others;
  if (moved <= 1e-12 * mesh.diameter) return {};
  return fmt::format("nodes on faces and inside elements are not stored, which moves these by up to {}",
                     length_text(moved, mesh.diameter));
}

}  // namespace quadrille::exports
