#include "export/patches.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string_view>

#include "base/error.hpp"
#include "base/name_text.hpp"
#include "base/tolerance.hpp"
#include "export/hex_numbering.hpp"
#include "export/periodic_edges.hpp"
#include "export/renode.hpp"
#include "model/length_scale.hpp"
#include "model/quad_mesh.hpp"
#include "surface/periodic_motion.hpp"

namespace quadrille::exports {

namespace {

constexpr std::array<std::string_view, 6> known_types{"patch", "wall", "symmetryPlane", "symmetry", "empty", "wedge"};

bool begins_with(const std::string& name, std::string_view word) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return name.size() >= word.size() &&
         std::equal(word.begin(), word.end(), name.begin(), [&](char a, char b) { return a == lower(b); });
}

/// Whether all nodes of the groups of a boundary lie on one plane.
bool is_on_a_plane(const HexMesh& mesh, const Groups& groups, int boundary) {
  std::vector<Vec3> points;
  for (std::size_t g = 0; g < mesh.face_groups.size(); ++g) {
    const HexFaceGroup& group = mesh.face_groups[g];
    if (group.is_interface || groups.curve2boundary[g] != boundary) continue;
    for (std::size_t k = 0; k < group.elems.size(); ++k)
      for (const int node : face_nodes(mesh, group.elems[k], group.faces[k])) points.push_back(mesh.nodes[node]);
  }
  Vec3 normal;  // of the largest triangle with the first point and that farthest from it
  if (points.empty()) return true;
  const Vec3 first = points[0];
  const Vec3 far = *std::max_element(points.begin(), points.end(),
                                     [&](Vec3 a, Vec3 b) { return distance(first, a) < distance(first, b); });
  for (const Vec3 x : points)
    if (const Vec3 n = cross(far - first, x - first); norm2(n) > norm2(normal)) normal = n;
  return norm(normal) == 0 || std::all_of(points.begin(), points.end(), [&](Vec3 x) {
           return std::abs(dot(normalized(normal), x - first)) <= 1e-6 * mesh.diameter;
         });
}

/// Whether all nodes of a boundary lie on one line.
bool is_on_a_line(const QuadMesh& mesh, const Groups& groups, int boundary) {
  std::vector<Vec2> points;
  for (const QuadBoundaryEdge& e : mesh.boundary_edges)
    if (groups.curve2boundary[e.curve] == boundary)
      for (const int node : side_nodes(mesh, e.elem, e.side)) points.push_back(mesh.nodes[node]);
  if (points.empty()) return true;
  const auto is_nearer = [&](Vec2 a, Vec2 b) { return distance(points[0], a) < distance(points[0], b); };
  const Vec2 farthest = *std::max_element(points.begin(), points.end(), is_nearer);
  const Vec2 along = normalized(farthest - points[0]);
  return std::all_of(points.begin(), points.end(),
                     [&](Vec2 x) { return std::abs(cross(along, x - points[0])) <= 1e-6 * mesh.face.diameter; });
}

std::string type_by_name(const std::string& name, const std::function<bool()>& is_flat) {
  if (begins_with(name, "wall")) return "wall";
  if (begins_with(name, "empty")) return "empty";
  if (begins_with(name, "symmetry")) return is_flat() ? "symmetryPlane" : "symmetry";
  return "patch";
}

bool is_same_motion(const CadFace& face, int a, int b) {
  const PeriodicPair &one = face.periodic_pairs[a], &other = face.periodic_pairs[b];
  if (face.chart) {
    const SpaceMotion motion = surface::periodic_motion(face, one), others = surface::periodic_motion(face, other);
    const auto images_are_same = [&](Vec3 x) {
      return distance(surface::image(motion, x), surface::image(others, x)) <= tolerance::round_off * face.diameter;
    };
    const auto fit_on = [&](const PeriodicPair& pair) {
      const SpaceCurve& curve = face.chart->space_curves[pair.curves[0]];
      return images_are_same(curve.poles.front()) && images_are_same(curve.poles.back());
    };
    return fit_on(one) && fit_on(other);
  }
  return std::abs(one.angle - other.angle) <= tolerance::round_off &&
         distance(one.shift, other.shift) <= tolerance::round_off * face.diameter;
}

// By curve.
std::vector<CyclicPatch> cyclic_curves(const CadFace& face, const Groups& groups) {
  std::vector<CyclicPatch> curves(face.curves.size());
  for (int p = 0; p < static_cast<int>(face.periodic_pairs.size()); ++p) {
    const auto& [first, second] = face.periodic_pairs[p].curves;
    curves[first] = {groups.curve2boundary[second], p, true};
    curves[second] = {groups.curve2boundary[first], p, false};
  }
  return curves;
}

// A block with another first corner.
PlateBlock turned(const PlateBlock& block, int corner) {
  PlateBlock result = block;
  for (int k = 0; k < 4; ++k) {
    const int from = (k + corner) % 4;
    result.corners[k] = block.corners[from];
    result.edges[k] = (k < 2) == (from < 2) ? block.edges[from] : block.edges[from].reversed();
  }
  return result;
}

// The point that a rotation about (0, 0) and a translation leave where it is.
Vec2 centre_of(const PeriodicPair& pair) {
  const double cotangent = 1 / std::tan(0.5 * pair.angle);
  return 0.5 * Vec2{pair.shift.x - cotangent * pair.shift.y, pair.shift.y + cotangent * pair.shift.x};
}

// blockMesh lists the cells of a block's side in the direction of rising i or j and couples them in that order, before
// it compares positions: sides of first patches become the lower or right ones of their blocks, where i and j rise
// counter-clockwise, those of second patches the upper or left ones.
// A block that has opposite sides on two first patches, or on two second ones, cannot: its patches are not cyclic then.
void turn_blocks(std::vector<CyclicPatch>& cyclic, PlateBlocks& plates) {
  std::map<std::array<int, 2>, int> patch_of;  // by the ends of a side
  for (std::size_t b = 0; b < cyclic.size(); ++b)
    if (cyclic[b].neighbour >= 0)
      for (const std::array<int, 2>& side : plates.patches[b]) patch_of[side] = static_cast<int>(b);
  const auto patch_at = [&](const PlateBlock& block, int k) {
    const auto side = patch_of.find({block.corners[k], block.corners[(k + 1) % 4]});
    return side == patch_of.end() || cyclic[side->second].neighbour < 0 ? -1 : side->second;
  };
  const auto fits = [&](const PlateBlock& block) {
    for (int k = 0; k < 4; ++k)
      if (const int patch = patch_at(block, k); patch >= 0 && cyclic[patch].is_first != (k < 2)) return false;
    return true;
  };
  for (PlateBlock& block : plates.blocks) {
    int corner = 0;
    while (corner < 4 && !fits(turned(block, corner))) ++corner;
    if (corner < 4) {
      block = turned(block, corner);
      continue;
    }
    for (int k = 0; k < 4; ++k)
      if (const int patch = patch_at(block, k); patch >= 0) {
        cyclic[cyclic[patch].neighbour].neighbour = -1;
        cyclic[patch].neighbour = -1;
      }
  }
}

}  // namespace

std::vector<PatchType> patch_type_options(const std::vector<std::string>& options) {
  std::vector<PatchType> result;
  for (const std::string& option : options) {
    const std::size_t end = option.rfind('=');
    if (end == std::string::npos || end == 0)
      throw UsageError(fmt::format("--patch-type {}: expected NAME=TYPE, such as inlet=patch", option));
    const std::string type = option.substr(end + 1);
    if (std::find(known_types.begin(), known_types.end(), type) == known_types.end())
      throw UsageError(
          fmt::format("--patch-type {}: the type must be one of {}", option, fmt::join(known_types, ", ")));
    result.push_back({option.substr(0, end), type});
  }
  return result;
}

bool is_type_chosen(const std::string& name, const std::vector<PatchType>& chosen) {
  return std::any_of(chosen.begin(), chosen.end(),
                     [&](const PatchType& choice) { return matches_wildcard(name, choice.pattern); });
}

std::vector<std::string> patch_types(const QuadMesh& mesh, const Groups& groups, const std::vector<PatchType>& chosen) {
  return patch_types(groups, chosen, [&](int boundary) { return is_on_a_line(mesh, groups, boundary); });
}

std::vector<std::string> patch_types(const HexMesh& mesh, const Groups& groups, const std::vector<PatchType>& chosen) {
  return patch_types(groups, chosen, [&](int boundary) { return is_on_a_plane(mesh, groups, boundary); });
}

double metres_or_one(const std::string& unit) {
  for (const LengthUnit& known : length_units)
    if (known.name == unit) return known.metres;
  return 1;
}

std::vector<std::string> patch_types(const Groups& groups, const std::vector<PatchType>& chosen,
                                     const std::function<bool(int boundary)>& is_flat) {
  require_boundaries(groups.boundary_names, chosen);
  std::vector<std::string> result;
  for (int b = 0; b < groups.num_boundaries(); ++b)
    result.push_back(type_by_name(groups.boundary_names[b], [&] { return is_flat(b); }));
  for (const PatchType& choice : chosen)
    for (int b = 0; b < groups.num_boundaries(); ++b)
      if (matches_wildcard(groups.boundary_names[b], choice.pattern)) result[b] = choice.type;
  return result;
}

void require_boundaries(const std::vector<std::string>& names, const std::vector<PatchType>& chosen) {
  for (const PatchType& choice : chosen) {
    const auto fits = [&](const std::string& name) { return matches_wildcard(name, choice.pattern); };
    if (std::any_of(names.begin(), names.end(), fits)) continue;
    const std::set<std::string> distinct(names.begin(), names.end());
    throw UsageError(fmt::format("--patch-type {}={}: no boundary has this name{}; the boundaries are {}",
                                 choice.pattern, choice.type, did_you_mean(choice.pattern, names),
                                 fmt::join(distinct, ", ")));
  }
}

double boundary_distance(const QuadMesh& mesh) {
  double largest = 0;
  for (const QuadBoundaryEdge& e : mesh.boundary_edges) {
    const std::vector<int> nodes = side_nodes(mesh, e.elem, e.side);
    const Vec2 start = mesh.nodes[nodes.front()], along = normalized(mesh.nodes[nodes.back()] - start);
    for (const int node : nodes) largest = std::max(largest, std::abs(cross(along, mesh.nodes[node] - start)));
  }
  return largest;
}

std::string straight_sides_loss(double moved, double diameter) {
  return fmt::format("cells have straight sides, which moves the boundary by up to {}", length_text(moved, diameter));
}

std::vector<CyclicPatch> cyclic_patches(const QuadMesh& mesh, const Groups& groups,
                                        const std::vector<PatchType>& chosen) {
  const std::vector<CyclicPatch> curves = cyclic_curves(mesh.face, groups);
  std::vector<CyclicPatch> patches(groups.num_boundaries());
  std::vector<bool> is_known(patches.size(), false), is_cyclic(patches.size(), true);
  for (const QuadBoundaryEdge& e : mesh.boundary_edges) {
    const int boundary = groups.curve2boundary[e.curve];
    const CyclicPatch& curve = curves[e.curve];
    CyclicPatch& patch = patches[boundary];
    if (!is_known[boundary]) patch = curve;
    is_known[boundary] = true;
    if (curve.neighbour < 0 || curve.neighbour == boundary || curve.neighbour != patch.neighbour ||
        curve.is_first != patch.is_first || !is_same_motion(mesh.face, curve.pair, patch.pair))
      is_cyclic[boundary] = false;
  }
  for (int b = 0; b < groups.num_boundaries(); ++b)
    if (is_type_chosen(groups.boundary_names[b], chosen)) is_cyclic[b] = false;
  std::vector<CyclicPatch> result(patches.size());
  for (std::size_t b = 0; b < patches.size(); ++b)
    if (is_known[b] && is_cyclic[b] && is_cyclic[patches[b].neighbour]) result[b] = patches[b];
  return result;
}

void order_cyclic_blocks(const QuadMesh& mesh, const Groups& groups, std::vector<CyclicPatch>& cyclic,
                         PlateBlocks& plates) {
  turn_blocks(cyclic, plates);
  std::vector<std::map<int, int>> images(cyclic.size());  // by first patch: of nodes
  for (const PeriodicEdges& edges : periodic_edges(mesh)) {
    const QuadBoundaryEdge &first = mesh.boundary_edges[edges.first], &second = mesh.boundary_edges[edges.second];
    std::map<int, int>& of_patch = images[groups.curve2boundary[first.curve]];
    of_patch[side_node(mesh, first.elem, first.side, 0)] = side_node(mesh, second.elem, second.side, mesh.order);
    of_patch[side_node(mesh, first.elem, first.side, mesh.order)] = side_node(mesh, second.elem, second.side, 0);
  }
  std::vector<int> vertex_of_node(mesh.nodes.size(), -1);
  for (std::size_t v = 0; v < plates.vertices.size(); ++v) vertex_of_node[plates.vertices[v]] = static_cast<int>(v);
  for (std::size_t b = 0; b < cyclic.size(); ++b) {
    if (cyclic[b].neighbour < 0 || !cyclic[b].is_first) continue;
    const auto image = [&](int vertex) { return vertex_of_node[images[b].at(plates.vertices[vertex])]; };
    std::vector<std::array<int, 2>> ordered;
    for (const auto& [from, to] : plates.patches[b]) ordered.push_back({image(to), image(from)});
    plates.patches[cyclic[b].neighbour] = std::move(ordered);
  }
}

std::string cyclic_transform(const CadFace& face, const CyclicPatch& patch, double scale) {
  const PeriodicPair& pair = face.periodic_pairs[patch.pair];
  if (pair.angle != 0) {
    const Vec2 centre = scale * centre_of(pair);
    return fmt::format(
        "        transform rotational;\n        rotationAxis (0 0 1);\n        rotationCentre ({} {} 0);\n",
        centre.x + 0.0, centre.y + 0.0);
  }
  // openfoam.com reads the vector to the neighbour, openfoam.org from version 8 on the one from it, by another name.
  const Vec2 forth = (patch.is_first ? scale : -scale) * pair.shift;
  return fmt::format(
      "        transform translational;\n        separationVector ({} {} 0);\n        separation ({} {} 0);\n",
      forth.x + 0.0, forth.y + 0.0, 0.0 - forth.x, 0.0 - forth.y);
}

std::string cyclic_loss(const CadFace& face, const Groups& groups, const std::vector<CyclicPatch>& cyclic,
                        std::string_view condition) {
  std::vector<PeriodicPair> others;
  for (const PeriodicPair& pair : face.periodic_pairs) {
    const int boundary = groups.curve2boundary[pair.curves[0]];
    if (boundary >= 0 && cyclic[boundary].neighbour < 0) others.push_back(pair);
  }
  return periodic_loss(face, others, condition);
}

}  // namespace quadrille::exports
