#include "choice/half_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "curve/project.hpp"
#include "field/error_estimate.hpp"
#include "galerkin/solve_laplace.hpp"
#include "guide/valence.hpp"
#include "mesh/tri_topology.hpp"
#include "surface/positions.hpp"

namespace quadrille::choice {

HalfModel::HalfModel(const Field& half, const NodeOptions& options, curve::SymmetryLine line)
    : half_(half), line_(std::move(line)), mirrored_(curve::mirrored_face(face(), line_)), options_(options) {
  options_.overrides.clear();
  for (const guide::CornerOverride& prescribed : options.overrides) mirror_override(prescribed);
  prescribe_even_valences();
  mirror_walls();
}

Field HalfModel::field_of_whole(int num_threads) const {
  const TriMesh mesh = mesh::mirrored_mesh(half_.mesh, mirrored_, line_);
  std::vector<int> orders = half_.elem_order;
  orders.insert(orders.end(), half_.elem_order.begin(), half_.elem_order.end());
  galerkin::LaplaceOptions options = galerkin::options_of(half_);
  options.num_threads = num_threads;
  const double along = angle_of(line_.direction);
  for (const AlignmentPoint& point : half_.alignment)
    options.alignment.push_back({line_(point.position), point.width, point.rate, 2 * along - point.angle});
  Report not_of_critpoints;
  Field whole = galerkin::LaplaceSolver(mesh, options).solve(orders, not_of_critpoints);
  whole.elem_error = field::error_estimate(whole);
  return whole;
}

CriticalPoints HalfModel::nodes_of_half(const CriticalPoints& whole) const {
  CriticalPoints half;
  half.form = NodeForm::phase;
  half.origin = whole.origin;
  for (int joint = 0; joint < face().num_curves(); ++joint)
    if (face().joints[joint].is_corner) half.corners.push_back(corner_of_half(joint, whole));
  add_nodes(whole, half);
  add_boundary_nodes(whole, half);
  add_records(whole, half);
  half.index_sum = index_sum_of(half);
  half.index_sum_expected = 4 * face().euler_characteristic();
  guide::require_index_sum(half, face());
  return half;
}

bool HalfModel::is_near_line(Vec2 x) const {
  return std::abs(line_.height(x)) <= tolerance::same_point * face().diameter;
}

/// The joint in the place of this one.
int HalfModel::joint_of_whole(int joint) const {
  return is_on_line(joint) ? mirrored_.image[face().previous_in_loop(joint)] : mirrored_.copy[joint];
}

/// The same valence at the image of a corner; on the line twice the valence.
void HalfModel::mirror_override(const guide::CornerOverride& prescribed) {
  const auto [a, b, valence] = prescribed;
  const bool is_in_order = face().next_in_loop(a) == b;
  const int in = is_in_order ? a : b, out = is_in_order ? b : a;
  if (!is_beside_line(out)) {
    options_.overrides.push_back({mirrored_.copy[in], mirrored_.copy[out], valence});
    options_.overrides.push_back({mirrored_.image[out], mirrored_.image[in], valence});
    return;
  }
  const int c = is_on_line(out) ? in : out;
  const Joint& joint = mirrored_.whole.joints[joint_of_whole(out)];
  if (!joint.is_corner && valence == 1) return;
  if (!joint.is_corner || !guide::is_admissible_valence(degrees(joint.interior_angle), 2 * valence))
    throw ComputeError(fmt::format("the whole cannot have the valence {} at {}, twice the one that is prescribed",
                                   2 * valence, surface::rounded_position_text(face(), joint.position)));
  const std::array<int, 2> curves{mirrored_.copy[c], mirrored_.image[c]};
  options_.overrides.push_back({curves[c == in ? 0 : 1], curves[c == in ? 1 : 0], 2 * valence});
}

void HalfModel::prescribe_even_valences() {
  const std::vector<guide::CornerOverride> known = options_.overrides;
  for (int j = 0; j < face().num_curves(); ++j) {
    if (!is_beside_line(j)) continue;
    const int whole = joint_of_whole(j), before = mirrored_.whole.previous_in_loop(whole);
    const Joint& joint = mirrored_.whole.joints[whole];
    const int valence = 2 * std::max(1, static_cast<int>(std::lround(face().joints[j].interior_angle / half_pi)));
    const bool is_known =
        std::any_of(known.begin(), known.end(), [&](const guide::CornerOverride& o) { return o.curve_b == whole; });
    if (joint.is_corner && !is_known && guide::is_admissible_valence(degrees(joint.interior_angle), valence))
      options_.overrides.push_back({before, whole, valence});
  }
}

void HalfModel::mirror_walls() {
  for (placement::WallClearance& wall : options_.walls) {
    std::vector<int> curves;
    for (const int c : wall.curves)
      if (!is_on_line(c)) curves.insert(curves.end(), {mirrored_.copy[c], mirrored_.image[c]});
    wall.curves = std::move(curves);
  }
  std::erase_if(options_.walls, [](const placement::WallClearance& wall) { return wall.curves.empty(); });
}

/// Half of a valence on the line.
int HalfModel::even_half(int valence, Vec2 position) const {
  if (valence % 2 != 0)
    throw OddValenceError(
        fmt::format("the grid of the whole has a node of valence {} on the line of symmetry, at {}, and the line cuts "
                    "a block beside it from corner to corner, into triangles",
                    valence, surface::rounded_position_text(face(), position)));
  return valence / 2;
}

Corner HalfModel::corner_of_half(int joint, const CriticalPoints& whole) const {
  const Joint& at = face().joints[joint];
  Corner corner{joint, at.position, degrees(at.interior_angle), 1, {face().previous_in_loop(joint), joint}};
  const int image = joint_of_whole(joint);
  const auto known =
      std::find_if(whole.corners.begin(), whole.corners.end(), [&](const Corner& c) { return c.joint == image; });
  if (known == whole.corners.end()) return corner;  // smooth in the whole
  corner.source = known->source;
  corner.valence = known->valence;
  if (!is_beside_line(joint)) return corner;
  corner.valence = even_half(known->valence, at.position);
  if (corner.valence == std::lround(at.interior_angle / half_pi)) corner.source = NodeSource::angle;
  return corner;
}

void HalfModel::add_nodes(const CriticalPoints& whole, CriticalPoints& half) const {
  int num_images = 0;
  for (const CriticalPoint& node : whole.critical_points) {
    if (is_near_line(node.position)) {
      const int valence = even_half(node.valence, node.position);
      if (valence != 2) add_boundary_node({-1, 0, node.position, valence, node.source}, half);
    } else if (line_.height(node.position) > 0) {
      half.critical_points.push_back(node);
      ++num_images;
    } else {
      --num_images;
    }
  }
  if (num_images != 0) throw ComputeError("the nodes of the whole are not symmetric");
}

/// A node on the line.
void HalfModel::add_boundary_node(IrregularBoundaryPoint node, CriticalPoints& half) const {
  double nearest = INFINITY;
  for (const int c : line_.curves) {
    const curve::Projection foot = curve::project(face().curves[c], node.position);
    if (foot.distance < nearest) {
      nearest = foot.distance;
      node.curve = c, node.t = foot.t;
    }
  }
  node.position = curve::point(face().curves[node.curve], node.t);
  half.boundary_nodes.push_back(node);
}

void HalfModel::add_boundary_nodes(const CriticalPoints& whole, CriticalPoints& half) const {
  for (IrregularBoundaryPoint node : whole.boundary_nodes) {
    if (is_near_line(node.position))
      throw ComputeError("the grid of the whole has a node on the boundary in the line of symmetry");
    const auto copy = std::find(mirrored_.copy.begin(), mirrored_.copy.end(), node.curve);
    if (copy == mirrored_.copy.end()) continue;  // an image
    node.curve = static_cast<int>(copy - mirrored_.copy.begin());
    half.boundary_nodes.push_back(node);
  }
  std::stable_sort(half.boundary_nodes.begin(), half.boundary_nodes.end(),
                   [](const auto& a, const auto& b) { return a.curve != b.curve ? a.curve < b.curve : a.t < b.t; });
}

/// Changes, zeros and clusters that are not on the other side alone.
void HalfModel::add_records(const CriticalPoints& whole, CriticalPoints& half) const {
  const auto is_here = [&](Vec2 x) { return line_.height(x) >= 0 || is_near_line(x); };
  const auto has_mark = [&](const std::vector<NodeMark>& marks) {
    return std::any_of(marks.begin(), marks.end(), [&](const NodeMark& mark) { return is_here(mark.position); });
  };
  for (const NodeChange& change : whole.changes)
    if (has_mark(change.before) || has_mark(change.after)) half.changes.push_back(change);
  for (const Cluster& cluster : whole.clusters)
    if (is_here(cluster.centre)) half.clusters.push_back(cluster);
  const int num_elems = half_.mesh.num_elems();
  for (const CriticalPoint& zero : whole.zeros)
    if (zero.elem < num_elems) half.zeros.push_back(zero);
  half.certificate = whole.certificate;
  half.certificate.elements = num_elems;
  std::erase_if(half.certificate.cells, [&](const CertificateCell& cell) { return cell.elem >= num_elems; });
  half.certificate.disc_centres.clear(), half.certificate.disc_radii.clear();
  for (std::size_t i = 0; i < whole.certificate.disc_centres.size(); ++i)
    if (is_here(whole.certificate.disc_centres[i])) {
      half.certificate.disc_centres.push_back(whole.certificate.disc_centres[i]);
      half.certificate.disc_radii.push_back(whole.certificate.disc_radii[i]);
    }
}

}  // namespace quadrille::choice
