#include "sweep/sweep.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "base/child_process.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "model/block_regions.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"
#include "sweep/swept_quads.hpp"

namespace quadrille::sweep {

namespace {

Vec3 vector(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }

/// Of each quad a normal, and how fast the sweep moves it in the beginning: a sum over its corners.
struct QuadStart {
  Vec3 normal, velocity;
};

std::vector<QuadStart> starts_of(const QuadMesh& quads, const std::vector<Vec3>& nodes, const SweepMotion& motion) {
  constexpr double step = 1e-4;  // of a one-sided difference, exact for parabolas
  const SpaceMotion near = motion.at(step), far = motion.at(2 * step);
  std::vector<QuadStart> starts;
  for (int e = 0; e < quads.num_elems(); ++e) {
    const auto corner = [&](int k) { return nodes[side_start(quads, e, k)]; };
    QuadStart start{quads.face.chart ? cross(corner(2) - corner(0), corner(3) - corner(1)) : normal_of(quads.face), {}};
    for (int k = 0; k < 4; ++k) {
      const Vec3 x = corner(k);
      start.velocity += 4 * (image(near, x) - x) - (image(far, x) - x);
    }
    starts.push_back(start);
  }
  return starts;
}

/// Whether the sweep runs against the normals of the quads, on the whole. Throws UsageError where it runs along a quad,
/// or through it the other way: hexahedra there are flat or turned over, with any layers and sizes.
bool runs_backwards(const QuadMesh& quads, const std::vector<Vec3>& nodes, const SweepMotion& motion) {
  constexpr double least_slope = 1e-6;
  const std::vector<QuadStart> starts = starts_of(quads, nodes, motion);
  double volume = 0;
  for (const auto& [normal, velocity] : starts) volume += dot(normal, velocity);
  const double sign = volume < 0 ? -1 : 1;
  for (int e = 0; e < quads.num_elems(); ++e) {
    const auto& [normal, velocity] = starts[e];
    if (sign * dot(normal, velocity) > least_slope * norm(normal) * norm(velocity)) continue;
    throw UsageError(fmt::format(
        "at {} the sweep does not lead out of the face, whose normal is {} there: choose a direction or an axis with "
        "which it crosses the whole face from one side",
        position_text(nodes[side_start(quads, e, 0)]), position_text(normalized(normal))));
  }
  return volume < 0;
}

/// xi1 and xi2 exchanged.
std::vector<int> mirrored_elements(const QuadMesh& quads) {
  const int n = quads.order + 1;
  std::vector<int> mirrored(quads.elem_nodes.size());
  for (int e = 0; e < quads.num_elems(); ++e)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) mirrored[e * n * n + j * n + i] = quads.elem_nodes[e * n * n + i * n + j];
  return mirrored;
}

/// Fractions of the sweep at which there are nodes; without the last one if the end is the beginning.
std::vector<double> levels_of(const std::vector<double>& ends, int order, bool is_closed) {
  const std::vector<double>& xi = spectral::gll_points(order);
  std::vector<double> levels{0};
  for (std::size_t l = 0; l + 1 < ends.size(); ++l) {
    for (int k = 1; k < order; ++k) levels.push_back(ends[l] + (ends[l + 1] - ends[l]) * (1 + xi[k]) / 2);
    levels.push_back(ends[l + 1]);
  }
  if (is_closed) levels.pop_back();
  return levels;
}

double node_entries(const QuadMesh& quads, std::size_t layers) {
  return static_cast<double>(quads.elem_nodes.size()) * static_cast<double>(layers) * (quads.order + 1);
}

void require_room(const QuadMesh& quads, std::size_t layers) {
  const auto refuse = [&](const std::string& what) {
    throw ComputeError(fmt::format("{} quads of order {} in {} {}: take fewer layers, coarser quads or a lower order",
                                   quads.num_elems(), quads.order, counted(layers, "layer"), what));
  };
  if (node_entries(quads, layers) > std::numeric_limits<int>::max()) refuse("have too many nodes for one mesh");
  const double bytes = memory_of(quads, layers), available = static_cast<double>(memory_limit());
  constexpr double gib = 0x1p30;
  if (bytes > available)
    refuse(fmt::format("take about {:.2g} GiB of memory, and there are {:.2g} GiB", bytes / gib, available / gib));
}

void add_nodes(const SweptQuads& swept, const SweepMotion& motion, const SweepPlan& plan,
               const std::vector<double>& levels, HexMesh& mesh) {
  mesh.nodes.reserve(levels.size() * swept.nodes.size());
  for (const double s : levels) {
    const SpaceMotion at = motion.at(s);
    for (const Vec3 x : swept.nodes) mesh.nodes.push_back(image(at, x));
    if (plan.bottom_heights.empty()) continue;
    Vec3* const level = &mesh.nodes[mesh.nodes.size() - swept.nodes.size()];
    for (std::size_t q = 0; q < swept.nodes.size(); ++q)
      level[q] += (1 - s) * plan.bottom_heights[q] * motion.shape().normal;
  }
}

/// A curve that turns back has no tangent there, and lengths near the limit of numbers overflow.
void require_finite(const HexMesh& mesh, const std::vector<double>& levels) {
  const auto is_finite = [](Vec3 x) { return std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z); };
  const auto bad = std::ranges::find_if_not(mesh.nodes, is_finite);
  if (bad == mesh.nodes.end()) return;
  const std::size_t level = (bad - mesh.nodes.begin()) / (mesh.nodes.size() / levels.size());
  throw ComputeError(
      fmt::format("the sweep has no position at {:.3g} of its length: --curve must not turn back on itself, and "
                  "lengths must not overflow: move points of the curve, or shorten the sweep",
                  levels[level]));
}

void add_elements(const SweptQuads& swept, std::size_t layers, std::size_t levels, HexMesh& mesh) {
  const int order = mesh.order, per_quad = (order + 1) * (order + 1), nodes = static_cast<int>(swept.nodes.size());
  mesh.elem_nodes.reserve(swept.elem_nodes.size() * layers * (order + 1));
  for (std::size_t l = 0; l < layers; ++l)
    for (int quad = 0; quad < mesh.num_quads; ++quad)
      for (int k = 0; k <= order; ++k) {
        const int first = static_cast<int>((l * order + k) % levels) * nodes;
        for (int i = 0; i < per_quad; ++i) mesh.elem_nodes.push_back(first + swept.elem_nodes[quad * per_quad + i]);
      }
}

void add_regions(const QuadMesh& quads, HexMesh& mesh) {
  mesh.quad_block = quads.elem_block;
  std::map<std::string, int> numbers;
  for (const std::string& name :
       region_of_blocks(quads.face, quads.block_region, quads.block_names, quads.unnamed_blocks)) {
    const auto [entry, is_new] = numbers.try_emplace(name, static_cast<int>(mesh.region_names.size()));
    if (is_new) mesh.region_names.push_back(name);
    mesh.block_region.push_back(entry->second);
  }
}

std::array<Vec3, 8> box_corners(const std::vector<Vec3>& points) {
  Vec3 low = points.front(), high = low;
  for (const Vec3 x : points) {
    low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
    high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
  }
  std::array<Vec3, 8> corners;
  for (int k = 0; k < 8; ++k)
    corners[k] = {((k & 1) != 0 ? high : low).x, ((k & 2) != 0 ? high : low).y, ((k & 4) != 0 ? high : low).z};
  return corners;
}

double diameter_of(const std::vector<Vec3>& nodes) {
  const std::array<Vec3, 8> corners = box_corners(nodes);
  return distance(corners.front(), corners.back());
}

std::vector<int> unproved(const HexMesh& mesh) {
  std::vector<int> elems;
  for (int e = 0; e < mesh.num_elems(); ++e)
    if (!(mesh.elem_jacobian_bound[e] > 0)) elems.push_back(e);
  return elems;
}

Vec3 middle_of(const HexMesh& mesh, int elem) {
  Vec3 sum;
  const int count = mesh.nodes_per_elem();
  for (int k = 0; k < count; ++k) sum += mesh.nodes[mesh.elem_nodes[static_cast<std::size_t>(elem) * count + k]];
  return sum / count;
}

}  // namespace

Vec3 in_model(const CadFace& face, Vec2 x) {
  const Vec2 own = x + face.origin;
  return vector(face.plane_origin) + own.x * vector(face.plane_x) + own.y * vector(face.plane_y);
}

Vec3 normal_of(const CadFace& face) { return normalized(cross(vector(face.plane_x), vector(face.plane_y))); }

std::vector<Vec3> nodes_in_model(const QuadMesh& quads) {
  if (!quads.space_nodes.empty()) return quads.space_nodes;
  std::vector<Vec3> nodes;
  for (const Vec2 x : quads.nodes) nodes.push_back(in_model(quads.face, x));
  return nodes;
}

double memory_of(const QuadMesh& quads, std::size_t layers) {
  constexpr double copies = 6;  // measured: the mesh itself, its groups of faces, and what is written of both
  const double levels = static_cast<double>(layers) * quads.order + 1;
  const double nodes = static_cast<double>(std::max(quads.nodes.size(), quads.space_nodes.size())) * levels;
  return copies * (nodes * sizeof(Vec3) + node_entries(quads, layers) * sizeof(int));
}

SweptQuads swept_quads(const QuadMesh& quads, const SweepMotion& motion) {
  SweptQuads swept{quads, nodes_in_model(quads), quads.elem_nodes};
  if (!runs_backwards(quads, swept.nodes, motion)) return swept;
  swept.elem_nodes = mirrored_elements(quads);
  swept.face_of_side = {3, 2, 1, 0};
  return swept;
}

HexMesh sweep(const QuadMesh& quads, const SweepMotion& motion, const SweepPlan& plan, int threads, Progress* progress,
              std::vector<std::string>& lost) {
  const SweptQuads swept = swept_quads(quads, motion);
  const std::size_t layers = plan.ends.size() - 1;
  require_room(quads, layers);
  HexMesh mesh;
  mesh.length_unit = quads.face.length_unit;
  mesh.order = quads.order;
  mesh.num_quads = quads.num_elems();
  const std::vector<double> levels = levels_of(plan.ends, quads.order, motion.is_closed());
  add_nodes(swept, motion, plan, levels, mesh);
  require_finite(mesh, levels);
  add_elements(swept, layers, levels.size(), mesh);
  add_regions(quads, mesh);
  mesh.diameter = diameter_of(mesh.nodes);
  mesh.elem_jacobian_bound.resize(layers * mesh.num_quads);
  mesh.elem_scaled_jacobian.resize(mesh.elem_jacobian_bound.size());
  add_face_groups(swept, mesh, lost);
  if (!motion.is_closed()) add_ends(plan.bottom_name, plan.top_name, mesh);
  if (plan.has_periodic_ends && (motion.is_closed() || !motion.is_rigid() || !join_ends(motion.at(1), mesh)))
    throw UsageError("the ends of this sweep cannot be periodic: no rigid motion maps the bottom onto the top");
  measure(swept, motion, plan.ends, !plan.bottom_heights.empty(), threads, progress, mesh);
  return mesh;
}

double motion_error(const QuadMesh& quads, const SweepMotion& motion, const std::vector<double>& ends) {
  const std::vector<double>& xi = spectral::gll_points(quads.order);
  std::vector<double> middles;
  for (int k = 0; k < quads.order; ++k) middles.push_back((xi[k] + xi[k + 1]) / 2);
  const Eigen::MatrixXd values = spectral::interpolation_matrix(xi, middles);
  const std::array<Vec3, 8> corners =
      box_corners(nodes_in_model(quads));  // differences of affine maps are greatest there
  double greatest = 0;
  for (std::size_t l = 0; l + 1 < ends.size(); ++l) {
    const auto at = [&](double x) { return motion.at(ends[l] + (ends[l + 1] - ends[l]) * (1 + x) / 2); };
    std::vector<SpaceMotion> levels;
    for (const double x : xi) levels.push_back(at(x));
    for (int m = 0; m < quads.order; ++m) {
      const SpaceMotion exact = at(middles[m]);
      for (const Vec3 x : corners) {
        Vec3 between;
        for (int k = 0; k <= quads.order; ++k) between += values(m, k) * image(levels[k], x);
        greatest = std::max(greatest, distance(between, image(exact, x)));
      }
    }
  }
  return greatest;
}

void require_valid_elements(const HexMesh& mesh) {
  const std::vector<int> elems = unproved(mesh);
  if (elems.empty()) return;
  const int worst = *std::min_element(elems.begin(), elems.end(), [&](int a, int b) {
    return mesh.elem_jacobian_bound[a] < mesh.elem_jacobian_bound[b];
  });
  throw ComputeError(fmt::format(
      "{} of {} hexahedra cannot be proved valid; the worst lies at {} in layer {}: det J is only known to be at least "
      "{:.3g}; take more layers, smaller quads, or a sweep that bends, twists or narrows less (--allow-invalid writes "
      "the mesh all the same)",
      elems.size(), mesh.num_elems(), position_text(middle_of(mesh, worst)), worst / mesh.num_quads,
      mesh.elem_jacobian_bound[worst]));
}

void report_mesh(const HexMesh& mesh, Report& report) {
  report.set("hexahedra", mesh.num_elems());
  report.set("nodes", mesh.nodes.size());
  report.set("layers", mesh.num_layers());
  report.set("valid", mesh.is_valid);
  report.set("unproved_elements", unproved(mesh).size());
  report.set("least_jacobian_bound", mesh.least_jacobian_bound);
  report.set("least_scaled_jacobian", *std::ranges::min_element(mesh.elem_scaled_jacobian));
}

}  // namespace quadrille::sweep
