#include "refine/validity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "mesh/boundary_elements.hpp"
#include "mesh/element_sizes.hpp"
#include "spectral/quad_map.hpp"
#include "surface/positions.hpp"

namespace quadrille::refine {
namespace {

constexpr int num_reported = 8;
constexpr double ratio_tolerance = 1e-4;

bool is_proved(const QuadMesh& mesh, int elem) { return mesh.elem_jacobian_bound[elem] > 0; }

/// Elements in the order of worst_elements, equal ones unordered.
bool is_worse(const QuadMesh& mesh, int a, int b) {
  if (is_proved(mesh, a) != is_proved(mesh, b)) return !is_proved(mesh, a);
  const std::vector<double>& key = is_proved(mesh, a) ? mesh.elem_scaled_jacobian : mesh.elem_jacobian_bound;
  return key[a] != key[b] ? key[a] < key[b] : a < b;
}

/// Sorts runs of equal elements, whose order depends on rounding, by their numbers.
void sort_equals(const QuadMesh& mesh, std::vector<int>& elems) {
  const auto is_equal = [&](int a, int b) {
    return is_proved(mesh, a) && is_proved(mesh, b) &&
           mesh.elem_scaled_jacobian[b] - mesh.elem_scaled_jacobian[a] <= tolerance::tied;
  };
  for (auto begin = elems.begin(); begin != elems.end();) {
    const auto end = std::find_if(begin, elems.end(), [&](int e) { return e != *begin && !is_equal(*begin, e); });
    if (is_proved(mesh, *begin)) std::sort(begin, end);
    begin = end;
  }
}

/// Where in the reference square the scaled Jacobian is least.
Vec2 worst_point(const QuadMesh& mesh, int elem) {
  if (mesh.space_nodes.empty())
    return spectral::quad_scaled_jacobian_minimum(mesh.order, element_nodes(mesh, elem).data()).xi;
  return spectral::quad_scaled_jacobian_minimum(mesh.order, element_space_nodes(mesh, elem).data()).xi;
}

/// The planar element whose det J is bounded: in space its projection along its normal.
std::vector<Vec2> bounded_nodes(const QuadMesh& mesh, int elem) {
  if (mesh.space_nodes.empty()) return element_nodes(mesh, elem);
  return spectral::quad_projection(mesh.order, element_space_nodes(mesh, elem).data());
}

WorstElement look_at(const QuadMesh& mesh, int elem) {
  const std::vector<Vec2> nodes = element_nodes(mesh, elem);
  const Vec2 xi = worst_point(mesh, elem);
  return {elem, spectral::quad_position(mesh.order, nodes.data(), xi), mesh.elem_scaled_jacobian[elem],
          mesh.elem_jacobian_bound[elem]};
}

/// The ratio of one element if it is less than `known`; else a value that is not less.
double jacobian_ratio(const spectral::BernsteinSquare& det, double known) {
  const auto [low, high] = std::minmax_element(det.coefs.begin(), det.coefs.end());
  if (*low > 0 && *low / *high >= known) return known;
  const double tolerance = ratio_tolerance / 4 * std::max(std::abs(*low), std::abs(*high));
  spectral::BernsteinSquare reversed = det;
  for (double& coef : reversed.coefs) coef = -coef;
  const double least = spectral::least_value(det, tolerance), greatest = -spectral::least_value(reversed, tolerance);
  return least / std::max(std::abs(least), std::abs(greatest));
}

/// Finds elements with the same nodes in another mesh of the same blocks.
class KnownElements {
 public:
  explicit KnownElements(const QuadMesh* mesh) : mesh_(mesh) {}

  /// For successive elements: the element of the same block and number in it if it has these nodes, else -1.
  int find(int block, const std::vector<Vec2>& nodes) {
    if (!mesh_) return -1;
    const int num = mesh_->num_elems();
    const std::vector<int>& blocks = mesh_->elem_block;
    while (next_ < num && blocks[next_] < block) ++next_;
    if (next_ >= num || blocks[next_] != block) return -1;
    const int elem = next_++;
    return std::equal(nodes.begin(), nodes.end(), mesh_->elem_nodes.begin() + elem * mesh_->nodes_per_elem(),
                      [&](Vec2 x, int node) { return x == mesh_->nodes[node]; })
               ? elem
               : -1;
  }

 private:
  const QuadMesh* mesh_;
  int next_ = 0;
};

}  // namespace

std::vector<Vec2> element_nodes(const QuadMesh& mesh, int elem) {
  std::vector<Vec2> nodes;
  const int count = mesh.nodes_per_elem();
  for (int k = 0; k < count; ++k) nodes.push_back(mesh.nodes[mesh.elem_nodes[elem * count + k]]);
  return nodes;
}

std::vector<Vec3> element_space_nodes(const QuadMesh& mesh, int elem) {
  std::vector<Vec3> nodes;
  const int count = mesh.nodes_per_elem();
  for (int k = 0; k < count; ++k) nodes.push_back(mesh.space_nodes[mesh.elem_nodes[elem * count + k]]);
  return nodes;
}

void measure_element(QuadMesh& mesh, int elem) {
  if (!mesh.space_nodes.empty()) {
    const std::vector<Vec3> nodes = element_space_nodes(mesh, elem);
    mesh.elem_jacobian_bound[elem] = spectral::quad_normal_lower_bound(mesh.order, nodes.data());
    mesh.elem_scaled_jacobian[elem] = spectral::quad_scaled_jacobian_minimum(mesh.order, nodes.data()).value;
    return;
  }
  const std::vector<Vec2> nodes = element_nodes(mesh, elem);
  mesh.elem_jacobian_bound[elem] = spectral::quad_jacobian_lower_bound(mesh.order, nodes.data());
  mesh.elem_scaled_jacobian[elem] = spectral::quad_scaled_jacobian(mesh.order, nodes.data());
}

void summarise_validity(QuadMesh& mesh) {
  mesh.least_jacobian_bound = *std::min_element(mesh.elem_jacobian_bound.begin(), mesh.elem_jacobian_bound.end());
  mesh.is_valid = mesh.least_jacobian_bound > 0;
}

void measure_elements(QuadMesh& mesh, Progress* progress, const QuadMesh* known) {
  const Progress::Part part(progress, "elements", mesh.num_elems());
  mesh.elem_jacobian_bound.resize(mesh.num_elems());
  mesh.elem_scaled_jacobian.resize(mesh.num_elems());
  KnownElements same(known);
  for (int elem = 0; elem < mesh.num_elems(); ++elem, part.advance()) {
    const int before = same.find(mesh.elem_block[elem], element_nodes(mesh, elem));
    if (before < 0) {
      measure_element(mesh, elem);
      continue;
    }
    mesh.elem_jacobian_bound[elem] = known->elem_jacobian_bound[before];
    mesh.elem_scaled_jacobian[elem] = known->elem_scaled_jacobian[before];
  }
  summarise_validity(mesh);
}

double least_scaled_jacobian(const QuadMesh& mesh) { return std::ranges::min(mesh.elem_scaled_jacobian); }

double mean_scaled_jacobian(const QuadMesh& mesh) {
  return std::accumulate(mesh.elem_scaled_jacobian.begin(), mesh.elem_scaled_jacobian.end(), 0.0) / mesh.num_elems();
}

std::vector<WorstElement> worst_elements(const QuadMesh& mesh, int count) {
  std::vector<int> elems(mesh.num_elems());
  std::iota(elems.begin(), elems.end(), 0);
  std::sort(elems.begin(), elems.end(), [&](int a, int b) { return is_worse(mesh, a, b); });
  sort_equals(mesh, elems);
  elems.resize(std::min(elems.size(), static_cast<std::size_t>(count)));
  std::vector<WorstElement> worst;
  for (const int elem : elems) worst.push_back(look_at(mesh, elem));
  return worst;
}

std::string describe(const WorstElement& worst, const QuadMesh& mesh) {
  return fmt::format("element {} of {} at {}: scaled Jacobian {:.4f}, det J >= {:.3g}", worst.elem,
                     mesh.block_names[mesh.elem_block[worst.elem]], surface::position_text(mesh.face, worst.position),
                     worst.scaled_jacobian, worst.bound);
}

double least_jacobian_ratio(const QuadMesh& mesh) {
  double least = 1;
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    least = std::min(least,
                     jacobian_ratio(spectral::quad_jacobian_det(mesh.order, bounded_nodes(mesh, elem).data()), least));
  return least;
}

void require_valid_elements(const QuadMesh& mesh) {
  if (mesh.is_valid) return;
  const WorstElement worst = worst_elements(mesh, 1).front();
  throw ComputeError(
      fmt::format("{} of {} elements cannot be proved valid; the worst lies at {} in {}: det J is only known to be "
                  "at least {:.3g} (--allow-invalid writes the mesh all the same)",
                  mesh.num_unproved(), mesh.num_elems(), surface::position_text(mesh.face, worst.position),
                  mesh.block_names[mesh.elem_block[worst.elem]], worst.bound));
}

void require_quality(const QuadMesh& mesh, double min_scaled_jacobian, double max_edge_ratio) {
  const WorstElement worst = worst_elements(mesh, 1).front();
  if (min_scaled_jacobian > 0 && worst.scaled_jacobian < min_scaled_jacobian * (1 - tolerance::tied))
    throw ComputeError(fmt::format(
        "element {} at {} has the scaled Jacobian {:.4g}, below --min-scaled-jacobian {:.4g}: lower "
        "--size, use --relax, or lower the limit",
        worst.elem, surface::position_text(mesh.face, worst.position), worst.scaled_jacobian, min_scaled_jacobian));
  const mesh::ElementSizes sizes = mesh::worst_element_sizes(mesh);
  if (max_edge_ratio > 0 && sizes.edge_ratio > max_edge_ratio * (1 + tolerance::tied))
    throw ComputeError(
        fmt::format("element {} at {} has sides whose lengths have the ratio {:.4g}, above --max-edge-ratio {:.4g}: "
                    "remove short edges from the CAD face, lower --size, or raise the limit",
                    sizes.edge_ratio_elem, surface::position_text(mesh.face, sizes.edge_ratio_position),
                    sizes.edge_ratio, max_edge_ratio));
}

void report_validity(const QuadMesh& mesh, Report& report) {
  report.set("valid", mesh.is_valid);
  report.set("unproved_elements", mesh.num_unproved());
  report.set("least_jacobian_bound", mesh.least_jacobian_bound);
  report.set("least_scaled_jacobian", least_scaled_jacobian(mesh));
  report.set("mean_scaled_jacobian", mean_scaled_jacobian(mesh));
  report.set("least_jacobian_ratio", least_jacobian_ratio(mesh));
  const std::vector<WorstElement> worst = worst_elements(mesh, num_reported);
  for (std::size_t i = 0; i < worst.size(); ++i) {
    const std::string key = fmt::format("worst.{}.", i + 1);
    report.set(key + "element", worst[i].elem);
    report.set(key + "block", mesh.elem_block[worst[i].elem]);
    report.set(key + "block_name", mesh.block_names[mesh.elem_block[worst[i].elem]]);
    report.set(key + "position", surface::position_in_file(mesh.face, worst[i].position));
    report.set(key + "scaled_jacobian", worst[i].scaled_jacobian);
    report.set(key + "jacobian_bound", worst[i].bound);
  }
}

void report_mesh(const QuadMesh& mesh, Report& report) {
  report.set("quads", mesh.num_elems());
  report.set("nodes", mesh.nodes.size());
  report.set("blocks", mesh.block_names.size());
  report.set("irregular_nodes", mesh.num_irregular);
  report_validity(mesh, report);
  mesh::report_element_sizes(mesh, report);
  mesh::report_boundary_elements(mesh, report);
}

}  // namespace quadrille::refine
