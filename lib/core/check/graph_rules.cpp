#include <optional>

#include "check/rules.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::check {

std::string structure_fault(const Nurbs& curve) {
  const std::size_t num_poles = curve.poles.size();
  const auto degree = static_cast<std::size_t>(curve.degree);
  if (curve.degree < 1 || curve.degree > 25) return fmt::format("degree {} is outside 1 to 25", curve.degree);
  if (num_poles < degree + 1) return fmt::format("{} poles are too few for degree {}", num_poles, degree);
  if (curve.weights.size() != num_poles) return fmt::format("{} weights for {} poles", curve.weights.size(), num_poles);
  if (curve.knots.size() != num_poles + degree + 1)
    return fmt::format("{} knots for {} poles of degree {}", curve.knots.size(), num_poles, degree);
  return {};
}

namespace {

/// Multiplicity of the knot at position `i`, counted forwards.
std::size_t multiplicity(const std::vector<double>& knots, std::size_t i) {
  std::size_t m = 1;
  while (i + m < knots.size() && knots[i + m] == knots[i]) ++m;
  return m;
}

std::string knot_fault(const Nurbs& curve) {
  const std::vector<double>& knots = curve.knots;
  const auto degree = static_cast<std::size_t>(curve.degree);
  for (std::size_t i = 0; i + 1 < knots.size(); ++i)
    if (!(knots[i] <= knots[i + 1])) return fmt::format("knot {} is smaller than the one before", i + 1);
  if (!(knots.front() < knots.back())) return "the domain is empty";
  if (multiplicity(knots, 0) != degree + 1 || knots[knots.size() - degree - 1] != knots.back())
    return "the curve is not clamped at its ends";
  for (std::size_t i = degree + 1; knots[i] < knots.back(); i += multiplicity(knots, i))
    if (multiplicity(knots, i) > degree) return fmt::format("the curve is broken at knot {}", i);
  return {};
}

/// Largest ratio of weights: beyond it the lightest pole has no influence in double precision near the heaviest one.
constexpr double max_weight_ratio = 1e8;

}  // namespace

std::string number_fault(const Nurbs& curve) {
  for (std::size_t i = 0; i < curve.poles.size(); ++i) {
    if (!is_finite(curve.poles[i])) return fmt::format("pole {} is not finite", i);
    if (!is_finite(curve.weights[i]) || curve.weights[i] <= 0) return fmt::format("weight {} is not positive", i);
  }
  for (std::size_t i = 0; i < curve.knots.size(); ++i)
    if (!is_finite(curve.knots[i])) return fmt::format("knot {} is not finite", i);
  const auto [least, greatest] = std::minmax_element(curve.weights.begin(), curve.weights.end());
  if (*greatest > max_weight_ratio * *least)
    return fmt::format("weights {:.3g} and {:.3g} differ by more than a factor of {:.0g}", *least, *greatest,
                       max_weight_ratio);
  return knot_fault(curve);
}

bool has_far_pole(const Nurbs& curve, const CadFace& face) {
  const Vec2 centre = face.curves.front().poles.front();
  return std::any_of(curve.poles.begin(), curve.poles.end(),
                     [&](Vec2 p) { return !(norm(p - centre) <= 1000 * face.diameter); });
}

void splines_are_sound(const ArcGraph& graph, Findings& findings) {
  for (std::size_t i = 0; i < graph.splines.size(); ++i) {
    std::string fault = structure_fault(graph.splines[i]);
    if (fault.empty()) fault = number_fault(graph.splines[i]);
    if (!fault.empty()) findings.add("spline {}: {}", i, fault);
  }
}

void graph_indices_exist(const ArcGraph& graph, Findings& findings) {
  const std::size_t num_curves = graph.face.curves.size();
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    const GraphNode& node = graph.nodes[i];
    if (node.curve != -1 && !is_index(node.curve, num_curves))
      findings.add("node {}: curve {} does not exist", i, node.curve);
  }
  for (std::size_t i = 0; i < graph.arcs.size(); ++i) {
    const GraphArc& arc = graph.arcs[i];
    if (!is_index(arc.from, graph.nodes.size()) || !is_index(arc.to, graph.nodes.size()))
      findings.add("arc {}: an end node does not exist", i);
    for (const ArcPiece& piece : arc.pieces)
      if (!is_index(piece.curve, num_curves + graph.splines.size()))
        findings.add("arc {}: curve {} does not exist", i, piece.curve);
  }
}

namespace {

/// Boundary arcs follow CAD curves, inner arcs splines or, all along, the sides of interfaces in the regions of lower
/// numbers.
bool may_follow(const CadFace& face, const GraphArc& arc, int curve) {
  if (arc.is_boundary) return curve < face.num_curves();
  const bool begins_on_cad_curve = arc.pieces.front().curve < face.num_curves();
  if (curve >= face.num_curves()) return !begins_on_cad_curve;
  return begins_on_cad_curve && face.is_interface(curve) && curve < face.partners[curve];
}

/// A part of a curve that an arc covers.
struct Part {
  int curve;
  double low, high;
  auto operator<=>(const Part&) const = default;
};

/// Of the boundary arcs, or of the others that follow CAD curves; sorted.
std::vector<Part> covered_parts(const ArcGraph& graph, bool by_boundary_arcs) {
  std::vector<Part> parts;
  for (const GraphArc& arc : graph.arcs)
    for (const ArcPiece& piece : arc.pieces)
      if (arc.is_boundary == by_boundary_arcs && piece.curve < graph.face.num_curves())
        parts.push_back({piece.curve, std::min(piece.t0, piece.t1), std::max(piece.t0, piece.t1)});
  std::sort(parts.begin(), parts.end());
  return parts;
}

/// The parameter of curve c from which its parts do not cover it exactly once; none if they do. `i`: the first part of
/// this curve, or of a later one; it is moved on to the first of a later one.
std::optional<double> fault_of_cover(const Nurbs& curve, int c, const std::vector<Part>& parts, std::size_t& i) {
  const double tol = 1e-9 * (curve.end() - curve.begin());
  double t = curve.begin();
  for (; i < parts.size() && parts[i].curve == c && std::abs(parts[i].low - t) <= tol; ++i) t = parts[i].high;
  const bool has_more = i < parts.size() && parts[i].curve == c;
  while (i < parts.size() && parts[i].curve == c) ++i;
  return has_more || std::abs(t - curve.end()) > tol ? std::optional<double>(t) : std::nullopt;
}

}  // namespace

void pieces_are_sound(const ArcGraph& graph, Findings& findings) {
  for (std::size_t i = 0; i < graph.nodes.size(); ++i)
    if (!is_finite(graph.nodes[i].position) || !is_finite(graph.nodes[i].t))
      findings.add("node {} contains a number that is not finite", i);
  for (std::size_t i = 0; i < graph.arcs.size(); ++i) {
    const GraphArc& arc = graph.arcs[i];
    if (arc.pieces.empty()) findings.add("arc {} has no pieces", i);
    if (arc.length < 0) findings.add("arc {}: its length is negative", i);
    for (const ArcPiece& piece : arc.pieces) {
      const Nurbs& curve = graph.curve(piece.curve);
      const double tol = 1e-12 * (curve.end() - curve.begin());
      const auto is_inside = [&](double t) { return t >= curve.begin() - tol && t <= curve.end() + tol; };
      if (!is_inside(piece.t0) || !is_inside(piece.t1) || piece.t0 == piece.t1)
        findings.add("arc {}: parameters {:.9g} to {:.9g} are not a part of curve {}", i, piece.t0, piece.t1,
                     piece.curve);
      if (!may_follow(graph.face, arc, piece.curve))
        findings.add("arc {}: boundary arcs follow CAD curves, inner arcs splines or the first side of an interface",
                     i);
    }
  }
}

void arcs_are_chains(const ArcGraph& graph, Findings& findings) {
  for (std::size_t i = 0; i < graph.splines.size(); ++i)
    if (has_far_pole(graph.splines[i], graph.face))
      findings.add("spline {} has a pole farther out than 1000 diameters", i);
  const double tol = gap_tol * graph.face.diameter;
  for (std::size_t i = 0; i < graph.arcs.size(); ++i) {
    const GraphArc& arc = graph.arcs[i];
    Vec2 end = graph.nodes[arc.from].position;
    const auto meet = [&](Vec2 next) {
      if (distance(end, next) > tol)
        findings.add("arc {} is broken: {} and {} do not meet", i, position_text(graph.face, end),
                     position_text(graph.face, next));
    };
    for (const ArcPiece& piece : arc.pieces) {
      meet(curve::point(graph.curve(piece.curve), piece.t0));
      end = curve::point(graph.curve(piece.curve), piece.t1);
    }
    meet(graph.nodes[arc.to].position);
  }
}

void boundary_is_covered(const ArcGraph& graph, Findings& findings) {
  const std::vector<Part> outer = covered_parts(graph, true), inner = covered_parts(graph, false);
  const auto is_of = [](const Part& part, int c) { return part.curve < c; };
  const auto has_part = [&](const std::vector<Part>& parts, int c) {
    const auto first = std::lower_bound(parts.begin(), parts.end(), c, is_of);
    return first != parts.end() && first->curve == c;
  };
  std::size_t next_outer = 0, next_inner = 0;
  for (int c = 0; c < graph.face.num_curves(); ++c) {
    const Nurbs& curve = graph.face.curves[c];
    const bool is_interface = graph.face.is_interface(c);
    const bool is_closed = is_interface && has_part(inner, std::min(c, graph.face.partners[c]));
    if (is_closed && has_part(outer, c))
      return findings.add("inner and boundary arcs both follow the interface of curve {}", c);
    if (is_closed && c > graph.face.partners[c]) continue;
    const std::optional<double> fault =
        is_closed ? fault_of_cover(curve, c, inner, next_inner) : fault_of_cover(curve, c, outer, next_outer);
    if (fault)
      return findings.add("the {} arcs do not cover curve {} exactly once, near parameter {:.9g}",
                          is_closed ? "inner" : "boundary", c, *fault);
  }
}

void node_kinds_fit(const ArcGraph& graph, Findings& findings) {
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    const GraphNode& node = graph.nodes[i];
    const bool must_be_outer = node.kind == NodeKind::corner || node.kind == NodeKind::boundary;
    const bool must_be_inner = node.kind == NodeKind::crossing;
    if ((must_be_outer && node.curve < 0) || (must_be_inner && node.curve >= 0))
      findings.add("node {}: boundary nodes and corners name a CAD curve, crossings do not", i);
    const bool must_be_shared = node.kind == NodeKind::interface || node.kind == NodeKind::junction;
    if (must_be_shared && (node.curve < 0 || !graph.face.is_interface(node.curve)))
      findings.add("node {}: nodes on interfaces and junctions name the curve of an interface", i);
    if (node.valence < 0 || node.valence > 64) findings.add("node {}: valence {} is outside 0 to 64", i, node.valence);
    if (node.curve < 0) continue;
    const Nurbs& curve = graph.face.curves[node.curve];
    const double tol = 1e-9 * (curve.end() - curve.begin());
    if (node.t < curve.begin() - tol || node.t > curve.end() + tol ||
        distance(curve::point(curve, node.t), node.position) > gap_tol * graph.face.diameter)
      findings.add("node {} does not lie on curve {} at its parameter, near {}", i, node.curve,
                   position_text(graph.face, node.position));
  }
}

}  // namespace quadrille::check
