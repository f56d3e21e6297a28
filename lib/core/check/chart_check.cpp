// Rules of the chart of a curved face, in whatever file it is.

#include <algorithm>
#include <map>
#include <set>

#include "check/rules.hpp"
#include "curve/project.hpp"
#include "model/charted_face.hpp"
#include "spectral/tri_bernstein.hpp"
#include "spectral/tri_map.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::check {

namespace {

constexpr double surface_tol = 1e-9;       ///< diameters: of nodes from their surface
constexpr double worst_closedness = 1e-3;  ///< radians

void charted_face_has_a_chart(const ChartedFace& charted, Findings& findings) {
  if (!charted.face.chart) findings.add("the face has no chart");
}

void chart_arrays_agree(const CadFace& face, Findings& findings) {
  const Chart& chart = *face.chart;
  if (chart.order < 1 || chart.order > 20) return findings.add("order {} is outside 1 to 20", chart.order);
  const std::size_t elems = chart.elem2vertices.size(), nodes = elems * chart.nodes_per_elem();
  if (elems == 0) findings.add("the chart has no elements");
  const auto agree = [&](const char* name, std::size_t size, std::size_t expected) {
    if (size != expected) findings.add("{} has {} entries, not {}", name, size, expected);
  };
  agree("nodes", chart.nodes.size(), nodes);
  agree("space_nodes", chart.space_nodes.size(), nodes);
  agree("uv", chart.uv.size(), nodes);
  agree("log_scale", chart.log_scale.size(), nodes);
  agree("elem_surface", chart.elem_surface.size(), elems);
  agree("space_curves", chart.space_curves.size(), face.curves.size());
  for (std::size_t e = 0; e < elems && e < chart.elem_surface.size(); ++e) {
    const auto& [a, b, c] = chart.elem2vertices[e];
    if (a < 0 || b < 0 || c < 0 || a == b || b == c || c == a)
      findings.add("element {} must have three different vertices", e);
    if (!is_index(chart.elem_surface[e], chart.surfaces.size()))
      findings.add("element {}: surface {} does not exist", e, chart.elem_surface[e]);
  }
}

/// What holds for knots and weights is what holds for curves in the plane.
std::string fault_of(int degree, const std::vector<double>& knots, const std::vector<double>& weights) {
  const Nurbs curve{degree, knots, std::vector<Vec2>(weights.size()), weights};
  const std::string fault = structure_fault(curve);
  return fault.empty() ? number_fault(curve) : fault;
}

std::string fault_of(const SpaceCurve& curve) {
  if (curve.poles.size() != curve.weights.size())
    return fmt::format("{} weights for {} poles", curve.weights.size(), curve.poles.size());
  if (!are_finite(curve.poles)) return "a pole is not finite";
  return fault_of(curve.degree, curve.knots, curve.weights);
}

std::string fault_of(const NurbsSurface& surface) {
  const auto along = [](int degree, const std::vector<double>& knots) {
    const auto num_poles = std::max<std::ptrdiff_t>(std::ssize(knots) - degree - 1, 0);
    return fault_of(degree, knots, std::vector<double>(degree < 1 ? 0 : num_poles, 1.0));
  };
  if (const std::string fault = along(surface.degree_u, surface.knots_u); !fault.empty()) return "in u: " + fault;
  if (const std::string fault = along(surface.degree_v, surface.knots_v); !fault.empty()) return "in v: " + fault;
  const std::size_t num_poles = static_cast<std::size_t>(surface.num_poles_u()) * surface.num_poles_v();
  if (surface.poles.size() != num_poles || surface.weights.size() != num_poles)
    return fmt::format("{} poles and {} weights, not {}", surface.poles.size(), surface.weights.size(), num_poles);
  if (!are_finite(surface.poles)) return "a pole is not finite";
  const auto is_weight = [](double w) { return std::isfinite(w) && w > 0; };
  return std::all_of(surface.weights.begin(), surface.weights.end(), is_weight) ? "" : "a weight is not positive";
}

void splines_are_sound(const CadFace& face, Findings& findings) {
  const Chart& chart = *face.chart;
  for (std::size_t i = 0; i < chart.surfaces.size(); ++i)
    if (const std::string fault = fault_of(chart.surfaces[i]); !fault.empty()) findings.add("surface {}: {}", i, fault);
  for (std::size_t i = 0; i < chart.space_curves.size(); ++i)
    if (const std::string fault = fault_of(chart.space_curves[i]); !fault.empty())
      findings.add("curve {} in space: {}", i, fault);
}

void chart_numbers_are_finite(const CadFace& face, Findings& findings) {
  const Chart& chart = *face.chart;
  if (!are_finite(chart.nodes)) findings.add("nodes contain a number that is not finite");
  if (!are_finite(chart.space_nodes)) findings.add("space_nodes contain a number that is not finite");
  if (!are_finite(chart.uv)) findings.add("uv contain a number that is not finite");
  if (!are_finite(chart.log_scale)) findings.add("log_scale contains a number that is not finite");
  if (!(chart.closedness >= 0) || !(chart.closedness <= worst_closedness))
    findings.add("closedness {:.3g} is outside 0 to {:.0g}", chart.closedness, worst_closedness);
}

void space_curves_fit(const CadFace& face, Findings& findings) {
  const Chart& chart = *face.chart;
  for (int i = 0; i < face.num_curves(); ++i) {
    const SpaceCurve &curve = chart.space_curves[i], &next = chart.space_curves[face.next_in_loop(i)];
    if (curve.begin() != face.curves[i].begin() || curve.end() != face.curves[i].end())
      findings.add("curve {} has other parameters in space than in the chart", i);
    if (const double gap = distance(curve.poles.back(), next.poles.front()); gap > gap_tol * face.diameter)
      findings.add("curve {} ends {:.3g} away from the start of its successor, in space", i, gap);
  }
}

void elements_are_valid(const CadFace& face, Findings& findings) {
  const Chart& chart = *face.chart;
  for (int e = 0; e < chart.num_elems(); ++e) {
    const spectral::TriMap map(chart.order, chart.nodes.data() + e * chart.nodes_per_elem());
    const std::array corners{map.position({-1, -1}), map.position({1, -1}), map.position({-1, 1})};
    const double bound = map.is_affine()
                             ? cross(corners[1] - corners[0], corners[2] - corners[0])
                             : spectral::jacobian_lower_bound(
                                   chart.order, spectral::bernstein_from_orthogonal(chart.order, map.coefs_x()),
                                   spectral::bernstein_from_orthogonal(chart.order, map.coefs_y()));
    if (!(bound > 0))
      findings.add("element {} of the chart is not proved valid: its Jacobian's lower bound is {:.3g}, at {}", e, bound,
                   position_text(face, corners[0]));
  }
}

/// An edge of an element that no other element has.
struct OuterEdge {
  int elem, edge;
};

std::vector<OuterEdge> outer_edges(const Chart& chart) {
  std::map<std::array<int, 2>, std::vector<OuterEdge>> edges;
  for (int e = 0; e < chart.num_elems(); ++e)
    for (int k = 0; k < 3; ++k) {
      const int a = chart.elem2vertices[e][k], b = chart.elem2vertices[e][(k + 1) % 3];
      edges[{std::min(a, b), std::max(a, b)}].push_back({e, k});
    }
  std::vector<OuterEdge> outer;
  for (const auto& [vertices, users] : edges)
    if (users.size() == 1) outer.push_back(users.front());
  return outer;
}

/// How far a node is from the point of its surface.
double distance_from_surface(const Chart& chart, std::size_t node) {
  const NurbsSurface& surface = chart.surfaces[chart.elem_surface[node / chart.nodes_per_elem()]];
  return distance(surface::point(surface, chart.uv[node]), chart.space_nodes[node]);
}

/// Edges of CAD files lie beside their faces: elements at the boundary may be off as much.
void nodes_lie_on_their_surface(const CadFace& face, Findings& findings) {
  const Chart& chart = *face.chart;
  std::set<int> outer_vertices;
  double gap = gap_tol * face.diameter;
  for (const auto& [elem, k] : outer_edges(chart)) {
    outer_vertices.insert({chart.elem2vertices[elem][k], chart.elem2vertices[elem][(k + 1) % 3]});
    for (int j = 0; j <= chart.order; ++j)
      gap = std::max(gap, distance_from_surface(
                              chart, elem * chart.nodes_per_elem() + spectral::tri_edge_node(chart.order, k, j)));
  }
  for (std::size_t i = 0; i < chart.nodes.size(); ++i) {
    const double off = distance_from_surface(chart, i);
    const bool is_outer = std::ranges::any_of(chart.elem2vertices[i / chart.nodes_per_elem()],
                                              [&](int v) { return outer_vertices.contains(v); });
    if (!(off <= (is_outer ? gap : surface_tol * face.diameter)))
      findings.add("node {} lies {:.3g} away from the point of its surface at its uv", i, off);
  }
}

void vertices_are_shared(const CadFace& face, Findings& findings) {
  const Chart& chart = *face.chart;
  std::map<int, int> first;  // the first node at each vertex
  for (int e = 0; e < chart.num_elems(); ++e)
    for (int k = 0; k < 3; ++k) {
      const int node = e * chart.nodes_per_elem() + k;
      const int known = first.try_emplace(chart.elem2vertices[e][k], node).first->second;
      if (distance(chart.nodes[known], chart.nodes[node]) > surface_tol * face.diameter ||
          distance(chart.space_nodes[known], chart.space_nodes[node]) > surface_tol * face.diameter)
        findings.add("nodes {} and {} are at vertex {}, but apart", known, node, chart.elem2vertices[e][k]);
    }
}

/// How far the pair of chart and space positions is from the nearest pair of points of equal parameter on a curve.
double distance_from_boundary(const CadFace& face, Vec2 x, Vec3 y) {
  double least = HUGE_VAL;
  for (int i = 0; i < face.num_curves(); ++i) {
    const curve::Projection foot = curve::project(face.curves[i], x);
    if (foot.distance >= least) continue;
    least = std::min(least, std::max(foot.distance, distance(surface::point(face.chart->space_curves[i], foot.t), y)));
  }
  return least;
}

void boundaries_agree(const CadFace& face, Findings& findings) {
  const Chart& chart = *face.chart;
  for (const auto& [elem, k] : outer_edges(chart)) {
    for (int j = 0; j <= chart.order; ++j) {
      const int node = elem * chart.nodes_per_elem() + spectral::tri_edge_node(chart.order, k, j);
      const double off = distance_from_boundary(face, chart.nodes[node], chart.space_nodes[node]);
      if (!(off <= gap_tol * face.diameter))
        findings.add("node {} of an outer edge lies {:.3g} away from the boundary, in the chart or in space, at {}",
                     node, off, position_text(face, chart.nodes[node]));
    }
  }
}

constexpr Rule<ChartedFace> charted_rules[] = {{"CHA-R01", RuleKind::structure, charted_face_has_a_chart}};
constexpr Rule<CadFace> chart_rules[] = {
    {"CHA-R02", RuleKind::structure, chart_arrays_agree},
    {"CHA-R03", RuleKind::structure, splines_are_sound},
    {"CHA-R04", RuleKind::structure, chart_numbers_are_finite},
    {"CHA-R05", RuleKind::quick, space_curves_fit},
    {"CHA-R06", RuleKind::full, elements_are_valid},
    {"CHA-R07", RuleKind::full, nodes_lie_on_their_surface},
    {"CHA-R08", RuleKind::full, vertices_are_shared},
    {"CHA-R09", RuleKind::full, boundaries_agree},
};

}  // namespace

std::vector<Violation> chart_violations(const CadFace& face, CheckDepth depth) {
  return face.chart ? apply_rules(chart_rules, face, depth) : std::vector<Violation>();
}

std::vector<Violation> violations_of(const ChartedFace& charted, CheckDepth depth) {
  return apply_rules_after(charted.face, charted_rules, charted, depth);
}

template std::vector<Violation> check_stage(const ChartedFace&, CheckDepth);

}  // namespace quadrille::check
