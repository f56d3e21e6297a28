#include "refine/lifted_split.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "base/warning_codes.hpp"
#include "mesh/element_sizes.hpp"
#include "refine/tip_rings.hpp"
#include "refine/validity.hpp"
#include "sizing/chart_scale.hpp"
#include "surface/positions.hpp"

namespace quadrille::refine {
namespace {

/// Of the tolerance: another mesh has elements in other places, of which some are farther than those before.
constexpr double aim = 0.5;
constexpr double least_factor = 0.4;  ///< by which lengths are multiplied at once
constexpr double unproved_factor = 0.5;
/// Between the first power of the length, with which the distance falls at a tip or a kink whatever the order, and the
/// second, with which it does where the curvature jumps.
constexpr double slow_power = 1.5;

/// By which the lengths of an element are multiplied, at most 1.
double shortened(double distance, double tolerance, int power) {
  return std::max(least_factor, std::pow(std::max(distance / (aim * tolerance), 1.0), -1.0 / power));
}

auto num_unproved(const LiftedMesh& lifted) {
  return std::ranges::count_if(lifted.mesh.elem_jacobian_bound, [](double bound) { return !(bound > 0); });
}

/// Of the surface, at the nodes of an element.
double least_radius(const mesh::ChartMap& map, const QuadMesh& mesh, int elem) {
  double curvature = 0;
  const auto first = mesh.elem_nodes.begin() + elem * mesh.nodes_per_elem();
  for (auto node = first; node != first + mesh.nodes_per_elem(); ++node)
    curvature = std::max(curvature, map.greatest_curvature(mesh.nodes[*node]));
  return 1 / curvature;
}

Vec3 corner(const QuadMesh& mesh, int elem, int side) { return mesh.space_nodes[side_start(mesh, elem, side)]; }

double longer_diagonal(const QuadMesh& mesh, int elem) {
  return std::max(distance(corner(mesh, elem, 0), corner(mesh, elem, 2)),
                  distance(corner(mesh, elem, 1), corner(mesh, elem, 3)));
}

/// Of the element that is farthest from the surface.
double size_of_worst(const LiftedMesh& lifted) { return longer_diagonal(lifted.mesh, lifted.farthest()); }

// A tip inside or at an element, or one element away: polynomials converge where the tip is farther than that.
bool is_near_any(const std::vector<Vec3>& tips, const QuadMesh& mesh, int elem) {
  return std::ranges::any_of(tips, [&](Vec3 tip) {
    double least = HUGE_VAL;
    for (int side = 0; side < 4; ++side) least = std::min(least, distance(corner(mesh, elem, side), tip));
    return least <= longer_diagonal(mesh, elem);
  });
}

std::vector<bool> elements_at(const std::vector<Vec3>& tips, const QuadMesh& mesh) {
  std::vector<bool> result(mesh.num_elems());
  for (int elem = 0; elem < mesh.num_elems(); ++elem) result[elem] = is_near_any(tips, mesh, elem);
  return result;
}

/// The greatest distance from the surface of elements at a tip.
double distance_at(Vec3 tip, const LiftedMesh& lifted) {
  const std::vector<bool> is_at = elements_at({tip}, lifted.mesh);
  double most = 0;
  for (int elem = 0; elem < lifted.mesh.num_elems(); ++elem)
    if (is_at[elem]) most = std::max(most, lifted.distance.elem[elem]);
  return most;
}

/// The vertex at a tip; -1: there is none.
int vertex_at(Vec3 tip, const LiftedMesh& lifted) {
  const double near = tolerance::round_off * sizing::diameter_in_space(lifted.mesh.face);
  for (int elem = 0; elem < lifted.mesh.num_elems(); ++elem)
    for (int side = 0; side < 4; ++side)
      if (distance(corner(lifted.mesh, elem, side), tip) <= near) return side_start(lifted.mesh, elem, side);
  return -1;
}

}  // namespace

int LiftedMesh::farthest() const {
  int worst = -1;
  for (int elem = 0; elem < std::ssize(distance.elem); ++elem)
    if (!is_at_tip[elem] && (worst < 0 || distance.elem[elem] > distance.elem[worst])) worst = elem;
  return worst;
}

LiftedMesh lifted(const mesh::ChartMap& map, QuadMesh mesh, const SurfaceTraits& surface, Progress* progress) {
  mesh::lift_nodes(map, mesh);
  if (surface.end_mirror) symmetrise(map, *surface.end_mirror, mesh);
  for (int elem = 0; elem < static_cast<int>(mesh.elem_prescribed_length.size()); ++elem)
    mesh.elem_prescribed_length[elem] *= std::exp(map.log_scale(mesh::centre(mesh, elem)));
  measure_elements(mesh, progress);
  mesh::measure_element_sizes(mesh);
  mesh::SurfaceDistance distance = mesh::surface_distance(map, mesh);
  std::vector<bool> at_tips = elements_at(surface.tips, mesh);
  return {std::move(mesh), std::move(distance), std::move(at_tips)};
}

std::vector<sizing::SizeSegment> finer_sizes(const mesh::ChartMap& map, const LiftedMesh& lifted,
                                             const sizing::SizeField& sizes, double tolerance, int power) {
  std::vector<sizing::SizeSegment> segments;
  const QuadMesh& mesh = lifted.mesh;
  if (lifted.farthest_distance() <= tolerance * (1 + tolerance::tied) && num_unproved(lifted) == 0) return segments;
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    double factor = lifted.is_at_tip[elem] ? 1 : shortened(lifted.distance.elem[elem], tolerance, power);
    if (!(mesh.elem_jacobian_bound[elem] > 0)) factor = std::min(factor, unproved_factor);
    if (factor == 1) continue;
    const Vec2 x = mesh::centre(mesh, elem);
    const mesh::ChartMap::Sample at = map.sample(x);
    const double length = factor * sizes.at(x) * std::exp(at.log_scale);
    segments.push_back({at.position, at.position, length, length});
  }
  return segments;
}

bool is_nearer(const LiftedMesh& a, const LiftedMesh& b) {
  const auto of_a = num_unproved(a), of_b = num_unproved(b);
  return of_a < of_b || (of_a == of_b && a.farthest_distance() < b.farthest_distance());
}

bool fell_slowly(const LiftedMesh& last, const LiftedMesh& next, double tolerance, int power) {
  if (num_unproved(last) > 0 || num_unproved(next) > 0) return num_unproved(next) >= num_unproved(last);
  const double before = last.farthest_distance(), after = next.farthest_distance();
  if (after <= tolerance || last.farthest() < 0) return false;
  // Counts are integers: elements may be longer than asked for.
  const double factor = std::max(shortened(before, tolerance, power), size_of_worst(next) / size_of_worst(last));
  return after > std::pow(factor, slow_power) * before;
}

bool is_resolving_bend(const mesh::ChartMap& map, const LiftedMesh& last, const LiftedMesh& next, int num_rounds) {
  if (!(next.farthest_distance() < last.farthest_distance())) return false;
  const double step = size_of_worst(next) / next.mesh.order, radius = least_radius(map, next.mesh, next.farthest());
  return step > radius && std::pow(least_factor, num_rounds) * step <= radius;
}

void add_tip_rings(const mesh::ChartMap& map, const SurfaceTraits& surface, double tolerance, int max_elements,
                   QuadMesh& mesh, LiftedMesh& there, Progress* progress) {
  for (const Vec3 tip : surface.tips) {
    const int vertex = vertex_at(tip, there);
    const double before = distance_at(tip, there);
    if (vertex < 0 || before <= tolerance * (1 + tolerance::tied)) continue;
    const QuadMesh without = mesh;
    TipRings rings{0, static_cast<int>(std::ceil(std::log2(before / (aim * tolerance))))};
    for (double least = before; least > aim * tolerance;) {
      ++rings.width;
      std::optional<QuadMesh> next = with_tip_rings(without, vertex, rings);
      if (!next || next->num_elems() > max_elements) break;
      LiftedMesh next_there = lifted(map, *next, surface, progress);
      const double distance = distance_at(tip, next_there);
      if (num_unproved(next_there) > num_unproved(there) || distance >= least) break;
      least = distance;
      mesh = std::move(*next), there = std::move(next_there);
    }
  }
}

void report_surface(const LiftedMesh& lifted, double tolerance, Report& report) {
  if (!std::isfinite(tolerance)) return;
  const mesh::SurfaceDistance& distance = lifted.distance;
  const CadFace& face = lifted.mesh.face;
  report.set("surface.distance", distance.worst());
  report.set("surface.position", surface::position_in_file(face, distance.position));
  report.set("surface.tolerance", tolerance);
  if (distance.worst() <= tolerance * (1 + tolerance::tied)) return;
  const double diameter = sizing::diameter_in_space(face), elsewhere = lifted.farthest_distance();
  const std::string excess =
      fmt::format("{:.2g} diameters at {}, more than the geometric tolerance {:.2g}", distance.worst() / diameter,
                  surface::position_text(face, distance.position), tolerance / diameter);
  const std::string text =
      elsewhere <= tolerance * (1 + tolerance::tied)
          ? fmt::format(
                "elements at a tip of the surface deviate from it by up to {}, all others by up to {:.2g}: no "
                "element follows a tip, and smaller ones around it have no room there: lower --size, or round the "
                "tip or cut it off in the CAD system",
                excess, elsewhere / diameter)
          : fmt::format("elements deviate from the surface by up to {}: {}", excess,
                        lifted.is_smooth ? "raise --order or lower --size"
                                         : "shorter edges hardly help, as the surface has a kink or a very sharp "
                                           "bend there: round it or cut the face there in the CAD system, or "
                                           "prescribe far shorter edges there (--size-field)");
  report.warn(warning::geometry_tol_missed, text);
}

}  // namespace quadrille::refine
