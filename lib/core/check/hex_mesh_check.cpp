#include <algorithm>
#include <array>
#include <set>

#include "check/rules.hpp"
#include "model/hex_faces.hpp"
#include "spectral/hex_map.hpp"
#include "surface/periodic_motion.hpp"

namespace quadrille::check {

namespace {

constexpr double periodic_tol = 1e-9;  ///< diameters: of nodes from their images

std::size_t nodes_per_hex(const HexMesh& mesh) { return static_cast<std::size_t>(mesh.nodes_per_elem()); }

std::string place(const HexMesh& mesh, int elem) {
  return position_text(mesh.nodes[mesh.elem_nodes[elem * nodes_per_hex(mesh)]]);
}

void hex_arrays_agree(const HexMesh& mesh, Findings& findings) {
  if (mesh.order < 1 || mesh.order > 30) return findings.add("order {} is outside 1 to 30", mesh.order);
  const std::size_t n = mesh.elem_jacobian_bound.size();
  if (n == 0) findings.add("the mesh has no elements");
  if (mesh.num_quads < 1 || n % static_cast<std::size_t>(std::max(1, mesh.num_quads)) != 0)
    return findings.add("{} elements are no whole number of layers of {}", n, mesh.num_quads);
  if (mesh.elem_nodes.size() != n * nodes_per_hex(mesh))
    findings.add("elem_nodes has {} entries, not {} for each of {} elements", mesh.elem_nodes.size(),
                 nodes_per_hex(mesh), n);
  if (mesh.elem_scaled_jacobian.size() != n)
    findings.add("elem_scaled_jacobian has {} entries for {} elements", mesh.elem_scaled_jacobian.size(), n);
  if (mesh.quad_block.size() != static_cast<std::size_t>(mesh.num_quads))
    findings.add("quad_block has {} entries for {} quads", mesh.quad_block.size(), mesh.num_quads);
  for (const HexFaceGroup& group : mesh.face_groups)
    if (group.elems.size() != group.faces.size())
      findings.add("the group '{}' has {} elements and {} faces", group.name, group.elems.size(), group.faces.size());
}

void hex_indices_exist(const HexMesh& mesh, Findings& findings) {
  for (std::size_t i = 0; i < mesh.elem_nodes.size(); ++i)
    if (!is_index(mesh.elem_nodes[i], mesh.nodes.size()))
      findings.add("element {}: node {} does not exist", i / nodes_per_hex(mesh), mesh.elem_nodes[i]);
  for (std::size_t q = 0; q < mesh.quad_block.size(); ++q)
    if (!is_index(mesh.quad_block[q], mesh.block_region.size()))
      findings.add("quad {}: block {} does not exist", q, mesh.quad_block[q]);
  for (std::size_t b = 0; b < mesh.block_region.size(); ++b)
    if (!is_index(mesh.block_region[b], mesh.region_names.size()))
      findings.add("block {}: region {} does not exist", b, mesh.block_region[b]);
  for (const HexFaceGroup& group : mesh.face_groups) {
    for (std::size_t f = 0; f < group.elems.size(); ++f)
      if (!is_index(group.elems[f], mesh.elem_jacobian_bound.size()) || !is_index(group.faces[f], 6))
        findings.add("face {} of the group '{}' does not exist", f, group.name);
    if (group.periodic_with != -1 && (!is_index(group.periodic_with, mesh.face_groups.size()) ||
                                      mesh.face_groups[group.periodic_with].elems.size() != group.elems.size()))
      findings.add("the group '{}' is periodic with group {}, which does not exist or has other faces", group.name,
                   group.periodic_with);
  }
}

void hex_numbers_are_finite(const HexMesh& mesh, Findings& findings) {
  if (!are_finite(mesh.nodes)) findings.add("nodes contain a number that is not finite");
  if (!are_finite(mesh.elem_jacobian_bound) || !are_finite(mesh.elem_scaled_jacobian))
    findings.add("elem_jacobian_bound or elem_scaled_jacobian contains a number that is not finite");
  if (!is_finite(mesh.diameter) || !(mesh.diameter > 0)) findings.add("diameter must be positive");
  for (const HexFaceGroup& group : mesh.face_groups)
    for (const Vec3 row : {group.motion.matrix[0], group.motion.matrix[1], group.motion.matrix[2], group.motion.shift})
      if (!is_finite(row)) findings.add("the motion of the group '{}' is not finite", group.name);
}

void hex_bounds_are_positive(const HexMesh& mesh, Findings& findings) {
  if (!mesh.is_valid) return;
  for (int e = 0; e < mesh.num_elems(); ++e)
    if (!(mesh.elem_jacobian_bound[e] > 0) || !(mesh.elem_scaled_jacobian[e] > 0) ||
        mesh.elem_scaled_jacobian[e] > 1 + 1e-12)
      findings.add("element {}: its Jacobian bound must be positive, its scaled Jacobian in (0, 1], at {}", e,
                   place(mesh, e));
}

void hex_root_tells_validity(const HexMesh& mesh, Findings& findings) {
  const double least = *std::min_element(mesh.elem_jacobian_bound.begin(), mesh.elem_jacobian_bound.end());
  if (mesh.least_jacobian_bound != least)
    findings.add("least_jacobian_bound is {}, the least of elem_jacobian_bound {}", mesh.least_jacobian_bound, least);
  if (mesh.is_valid != (least > 0)) findings.add("is_valid is {}, but the least bound is {}", mesh.is_valid, least);
}

class Faces {
 public:
  explicit Faces(const HexMesh& mesh) : mesh_(mesh), sorted_(sorted_hex_faces(mesh)) {
    for (int f = 0; f < 6; ++f) local_[f] = hex_face_nodes(mesh.order, f);
  }

  int node(int elem, int face, int k) const { return mesh_.elem_nodes[elem * nodes_per_hex(mesh_) + local_[face][k]]; }

  /// Whether two faces have the same nodes, seen from both sides.
  bool are_one(const HexFace& a, const HexFace& b) const {
    for (int turn = 0; turn < 4; ++turn)
      if (are_one(a, b, turn)) return true;
    return false;
  }

  const std::vector<HexFace>& sorted() const { return sorted_; }

 private:
  /// Seen from behind: with the indices exchanged, after quarter turns.
  bool are_one(const HexFace& a, const HexFace& b, int turn) const {
    const int n = mesh_.order, w = n + 1;
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) {
        int p = j, q = i;
        for (int t = 0; t < turn; ++t) {
          const int before = p;
          p = n - q, q = before;
        }
        if (node(a.elem, a.face, j * w + i) != node(b.elem, b.face, q * w + p)) return false;
      }
    return true;
  }

  const HexMesh& mesh_;
  std::array<std::vector<int>, 6> local_;
  std::vector<HexFace> sorted_;
};

/// A face has one neighbour at most, and none if it is on the boundary. Returns element and face of those.
std::vector<std::array<int, 2>> outer_faces_of(const HexMesh& mesh, Findings& findings) {
  const Faces faces(mesh);
  const std::vector<HexFace>& all = faces.sorted();
  std::vector<bool> is_paired(all.size());
  std::vector<std::array<int, 2>> outer;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (is_paired[i]) continue;
    bool has_rival = false, has_partner = false;
    for (std::size_t j = i + 1; j < all.size() && all[j].corners == all[i].corners && !has_partner; ++j) {
      if (is_paired[j]) continue;
      has_rival = true;
      if (faces.are_one(all[i], all[j])) is_paired[j] = has_partner = true;
    }
    if (has_rival && !has_partner)
      findings.add("element {} does not share all nodes of face {} with its neighbour, at {}", all[i].elem, all[i].face,
                   place(mesh, all[i].elem));
    if (!has_partner) outer.push_back({all[i].elem, all[i].face});
  }
  std::sort(outer.begin(), outer.end());
  return outer;
}

void hex_mesh_is_conforming(const HexMesh& mesh, Findings& findings) {
  const std::vector<std::array<int, 2>> outer = outer_faces_of(mesh, findings);
  std::vector<std::array<int, 2>> named;
  for (const HexFaceGroup& group : mesh.face_groups)
    for (std::size_t f = 0; f < group.elems.size() && !group.is_interface; ++f)
      named.push_back({group.elems[f], group.faces[f]});
  std::sort(named.begin(), named.end());
  if (outer != named)
    findings.add(
        "{} faces belong to one element only, {} are named in groups that are no interfaces; they must be the "
        "same, each once",
        outer.size(), named.size());
  std::vector<bool> is_used(mesh.nodes.size());
  for (const int node : mesh.elem_nodes) is_used[node] = true;
  if (const auto unused = std::count(is_used.begin(), is_used.end(), false); unused > 0)
    findings.add("{} nodes belong to no element", unused);
}

/// Each interface is named from both sides: its faces make pairs of one place.
void hex_interfaces_are_shared(const HexMesh& mesh, Findings& findings) {
  for (const HexFaceGroup& group : mesh.face_groups) {
    if (!group.is_interface) continue;
    std::set<std::array<int, 2>> own;
    for (std::size_t f = 0; f < group.elems.size(); ++f) own.insert({group.elems[f], group.faces[f]});
    std::vector<std::array<int, 4>> corners;
    const Faces faces(mesh);
    for (const HexFace& face : faces.sorted())
      if (own.contains({face.elem, face.face})) corners.push_back(face.corners);
    for (std::size_t k = 0; k < corners.size(); k += 2)
      if (k + 1 == corners.size() || corners[k] != corners[k + 1])
        return findings.add("a face of the interface '{}' is named from one side only, at {}", group.name,
                            position_text(mesh.nodes[corners[k][0]]));
  }
}

void hex_jacobians_are_as_stored(const HexMesh& mesh, Findings& findings) {
  std::vector<Vec3> nodes(nodes_per_hex(mesh));
  for (int e = 0; e < mesh.num_elems(); ++e) {
    if (!(mesh.elem_jacobian_bound[e] > 0)) continue;
    for (std::size_t k = 0; k < nodes.size(); ++k) nodes[k] = mesh.nodes[mesh.elem_nodes[e * nodes.size() + k]];
    if (const double bound = spectral::hex_bounds(mesh.order, nodes.data()).jacobian; !(bound > 0))
      findings.add("element {} is not proved valid: its Jacobian's lower bound is {:.3g}, at {}", e, bound,
                   place(mesh, e));
  }
}

/// The corners of each face are moved to those of its image.
void hex_groups_are_periodic(const HexMesh& mesh, Findings& findings) {
  const int n = mesh.order, w = n + 1;
  for (const HexFaceGroup& group : mesh.face_groups) {
    if (group.periodic_with < 0) continue;
    const HexFaceGroup& other = mesh.face_groups[group.periodic_with];
    for (std::size_t f = 0; f < group.elems.size(); ++f) {
      const auto corner = [&](const HexFaceGroup& of, int k) {
        const std::vector<int> local = hex_face_nodes(n, of.faces[f]);
        const std::array<int, 4> at{0, n, w * n, w * w - 1};
        return mesh.nodes[mesh.elem_nodes[of.elems[f] * nodes_per_hex(mesh) + local[at[k]]]];
      };
      for (int k = 0; k < 4; ++k) {
        const Vec3 image = surface::image(group.motion, corner(group, k));
        const bool is_there = std::ranges::any_of(std::array{0, 1, 2, 3}, [&](int i) {
          return distance(image, corner(other, i)) <= periodic_tol * mesh.diameter;
        });
        if (!is_there)
          findings.add("face {} of the periodic group '{}' is not moved onto that of '{}', at {}", f, group.name,
                       other.name, position_text(corner(group, k)));
      }
    }
  }
}

void hex_names_are_unique(const HexMesh& mesh, Findings& findings) {
  std::set<std::pair<bool, std::string>> names;
  for (const HexFaceGroup& group : mesh.face_groups)
    if (group.name.empty() || !names.insert({group.is_interface, group.name}).second)
      findings.add("the name '{}' of a group is empty, or that of another one", group.name);
}

constexpr Rule<HexMesh> hex_mesh_rules[] = {
    {"HEX-R01", RuleKind::structure, hex_arrays_agree},       {"HEX-R02", RuleKind::structure, hex_indices_exist},
    {"HEX-R03", RuleKind::structure, hex_numbers_are_finite}, {"HEX-R04", RuleKind::quick, hex_bounds_are_positive},
    {"HEX-R05", RuleKind::quick, hex_root_tells_validity},    {"HEX-R06", RuleKind::quick, hex_names_are_unique},
    {"HEX-R07", RuleKind::full, hex_mesh_is_conforming},      {"HEX-R08", RuleKind::full, hex_interfaces_are_shared},
    {"HEX-R09", RuleKind::full, hex_jacobians_are_as_stored}, {"HEX-R10", RuleKind::full, hex_groups_are_periodic},
};

}  // namespace

std::string validity_warning(const HexMesh& mesh) {
  if (mesh.is_valid) return "";
  const auto& bounds = mesh.elem_jacobian_bound;
  const auto worst = static_cast<int>(std::min_element(bounds.begin(), bounds.end()) - bounds.begin());
  const auto count = std::count_if(bounds.begin(), bounds.end(), [](double b) { return !(b > 0); });
  return fmt::format("the mesh is not valid: {} of {} elements are not proved, the worst is element {} at {}", count,
                     mesh.num_elems(), worst, place(mesh, worst));
}

std::vector<Violation> violations_of(const HexMesh& mesh, CheckDepth depth) {
  return apply_rules(hex_mesh_rules, mesh, depth);
}

template std::vector<Violation> check_stage(const HexMesh&, CheckDepth);

}  // namespace quadrille::check
