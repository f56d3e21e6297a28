#include "export/patch_types.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "base/error.hpp"
#include "base/name_text.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {
namespace {

constexpr std::array<std::string_view, 6> types{"patch", "wall", "symmetryPlane", "symmetry", "empty", "wedge"};

bool begins_with(const std::string& name, std::string_view word) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return name.size() >= word.size() &&
         std::equal(word.begin(), word.end(), name.begin(), [&](char a, char b) { return a == lower(b); });
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

std::string type_by_name(const QuadMesh& mesh, const Groups& groups, int boundary) {
  const std::string& name = groups.boundary_names[boundary];
  if (begins_with(name, "wall")) return "wall";
  if (begins_with(name, "empty")) return "empty";
  if (begins_with(name, "symmetry")) return is_on_a_line(mesh, groups, boundary) ? "symmetryPlane" : "symmetry";
  return "patch";
}

}  // namespace

std::vector<PatchType> patch_type_options(const std::vector<std::string>& options) {
  std::vector<PatchType> result;
  for (const std::string& option : options) {
    const std::size_t end = option.rfind('=');
    if (end == std::string::npos || end == 0)
      throw UsageError(fmt::format("--patch-type {}: expected NAME=TYPE, such as inlet=patch", option));
    const std::string type = option.substr(end + 1);
    if (std::find(types.begin(), types.end(), type) == types.end())
      throw UsageError(fmt::format("--patch-type {}: the type must be one of {}", option, fmt::join(types, ", ")));
    result.push_back({option.substr(0, end), type});
  }
  return result;
}

std::vector<std::string> patch_types(const QuadMesh& mesh, const Groups& groups, const std::vector<PatchType>& chosen) {
  require_boundaries(groups.boundary_names, chosen);
  std::vector<std::string> result;
  for (int b = 0; b < groups.num_boundaries(); ++b) result.push_back(type_by_name(mesh, groups, b));
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

}  // namespace quadrille::exports
