#include "refine/validity.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "spectral/quad_map.hpp"

namespace quadrille {

std::vector<Vec2> element_nodes(const QuadMesh& mesh, int elem) {
  std::vector<Vec2> nodes;
  const int count = mesh.nodes_per_elem();
  for (int k = 0; k < count; ++k) nodes.push_back(mesh.nodes[mesh.elem_nodes[elem * count + k]]);
  return nodes;
}

void measure_elements(QuadMesh& mesh) {
  mesh.elem_jacobian_bound.clear();
  mesh.elem_scaled_jacobian.clear();
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const std::vector<Vec2> nodes = element_nodes(mesh, elem);
    mesh.elem_jacobian_bound.push_back(quad_jacobian_lower_bound(mesh.order, nodes.data()));
    mesh.elem_scaled_jacobian.push_back(quad_scaled_jacobian(mesh.order, nodes.data()));
  }
}

bool is_proved_valid(const QuadMesh& mesh) {
  return std::all_of(mesh.elem_jacobian_bound.begin(), mesh.elem_jacobian_bound.end(), [](double b) { return b > 0; });
}

void require_valid_elements(const QuadMesh& mesh) {
  const auto worst = std::min_element(mesh.elem_jacobian_bound.begin(), mesh.elem_jacobian_bound.end());
  if (worst == mesh.elem_jacobian_bound.end() || *worst > 0) return;
  const int elem = static_cast<int>(worst - mesh.elem_jacobian_bound.begin());
  const Vec2 place = quad_position(mesh.order, element_nodes(mesh, elem).data(), {0, 0}) + mesh.face.origin;
  const auto invalid = std::count_if(mesh.elem_jacobian_bound.begin(), mesh.elem_jacobian_bound.end(),
                                     [](double bound) { return !(bound > 0); });
  throw ComputeError(fmt::format(
      "{} of {} elements cannot be proved valid; the worst lies at ({:.6g}, {:.6g}) in {}: det J is only known to be "
      "at least {:.3g}",
      invalid, mesh.num_elems(), place.x, place.y, mesh.block_names[mesh.elem_block[elem]], *worst));
}

void tell_validity(const QuadMesh& mesh, Report& report) {
  const auto least = [](const std::vector<double>& values) { return *std::min_element(values.begin(), values.end()); };
  report.set("least_jacobian_bound", least(mesh.elem_jacobian_bound));
  report.set("least_scaled_jacobian", least(mesh.elem_scaled_jacobian));
}

}  // namespace quadrille
