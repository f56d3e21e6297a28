#include "triangulate/corner_fans.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "triangulate/junction_clearance.hpp"
#include "triangulate/singularity.hpp"

namespace quadrille::triangulate {
namespace {

constexpr double acute_angle = radians(75.0);
constexpr double sector_angle = radians(60.0);
constexpr double slack = 1 + 1e-9;
/// Least radius of a ring, in diameters. Coordinates have 16 digits: the curved elements of smaller rings are not valid
/// for certain.
constexpr double least_radius = 1e-11;

/// Whether the curves at a corner are so close to each other, inside or outside the face, that segments along them
/// would be bisected without end.
bool is_sharp(const Junction& junction) {
  return junction.interior_angle < acute_angle || junction.interior_angle > 2 * pi - acute_angle;
}

/// The parameter at which the piece, followed from its start (`from_start`) or its end, leaves the circle of this
/// radius around the apex.
double parameter_at_radius(const Outline& outline, const SmoothPiece& piece, bool from_start, double radius) {
  const Nurbs& curve = outline.face().curves[piece.curve];
  const curve::ArcLength& length = outline.arc_length(piece.curve);
  const Vec2 apex = outline.at(piece.curve, from_start ? piece.t0 : piece.t1);
  double t = length.parameter(from_start ? piece.s0 + radius : piece.s1 - radius);
  for (int iteration = 0; iteration < 20; ++iteration) {
    const auto d = curve::derivatives(curve, t);
    const Vec2 way = d[0] - apex;
    const double step = (norm2(way) - radius * radius) / (2 * dot(way, d[1]));
    t = std::clamp(t - step, piece.t0, piece.t1);
    if (!(std::abs(step) > 1e-15 * (piece.t1 - piece.t0))) break;
  }
  return t;
}

/// The number of rings around the apex triangles, at most `needed`, such that none is smaller than `least`.
int layers_above(double least, double radius, int needed, double factor) {
  int layers = 0;
  for (; layers < needed && radius * factor >= least; ++layers) radius *= factor;
  return layers;
}

std::vector<double> ring_radii(double radius, int layers, double factor) {
  std::vector<double> radii(layers + 1);
  for (int ring = layers; ring >= 0; --ring) {
    radii[ring] = radius;
    radius *= factor;
  }
  return radii;
}

void place_sides(const Outline& outline, Fan& fan) {
  const SmoothPiece& out = outline.pieces()[fan.junction];
  const SmoothPiece& in = outline.pieces()[out.previous];
  fan.t_out.clear();
  fan.t_in.clear();
  for (const double radius : fan.radii) {
    fan.t_out.push_back(parameter_at_radius(outline, out, true, radius));
    fan.t_in.push_back(parameter_at_radius(outline, in, false, radius));
  }
}

/// Whether the longest edges of the fan along its curves satisfy the limits. Together they turn by at most the corner's
/// angle: the chords then enclose at least about half of it, and the triangles between the curves cannot fold.
bool keeps_limits(const EdgeFit& fit, const Fan& fan, const EdgeLimits& limits) {
  const auto& pieces = fit.outline().pieces();
  const SmoothPiece& out = pieces[fan.junction];
  const SmoothPiece& in = pieces[out.previous];
  const std::size_t last = fan.radii.size() - 1;
  const double out0 = last > 0 ? fan.t_out[last - 1] : out.t0, in1 = last > 0 ? fan.t_in[last - 1] : in.t1;
  double turns = 0;
  const auto keeps = [&](const SmoothPiece& piece, double t0, double t1) {
    if (piece.is_straight) return true;
    const double turn = fit.turn(piece.curve, t0, t1);
    turns += turn;
    return turn <= limits.turn * slack && fit.error(piece.curve, t0, t1) <= limits.curve_tol;
  };
  return keeps(out, out0, fan.t_out[last]) && keeps(in, fan.t_in[last], in1) &&
         turns <= fit.outline().junctions()[fan.junction].interior_angle * slack;
}

bool shape_fan(const EdgeFit& fit, const TriangulateOptions& options, const EdgeLimits& limits, double clearance,
               Fan& fan) {
  const Outline& outline = fit.outline();
  const Junction& junction = outline.junctions()[fan.junction];
  const SmoothPiece& out = outline.pieces()[fan.junction];
  const SmoothPiece& in = outline.pieces()[out.previous];
  fan.radius = std::min({limits.size, clearance / 3, out.length() / 3, in.length() / 3});
  fan.num_sectors = std::max(1, static_cast<int>(std::ceil(junction.interior_angle / (sector_angle * slack))));
  const double smallest = least_radius * outline.face().diameter;
  constexpr int max_rounds = 60;
  for (int round = 0; round < max_rounds; ++round) {
    const double exponent_layers = fan_layers(junction_singularity(junction, fan.radius), options.fan_factor);
    int layers = static_cast<int>(exponent_layers);
    if (layers > 0 && options.fan_layers >= 0) layers = options.fan_layers;
    if (layers == 0 && !is_sharp(junction)) return false;
    layers = layers_above(smallest, fan.radius, layers, options.fan_factor);
    fan.radii = ring_radii(fan.radius, layers, options.fan_factor);
    place_sides(outline, fan);
    if (keeps_limits(fit, fan, limits)) break;
    fan.radius *= 0.8;
  }
  return true;
}

/// The vertices of one ring, from the outgoing to the incoming curve.
std::vector<int> add_ring(const Outline& outline, const Fan& fan, std::size_t ring, Draft& draft) {
  const SmoothPiece& out = outline.pieces()[fan.junction];
  const SmoothPiece& in = outline.pieces()[out.previous];
  const Vec2 apex = outline.junctions()[fan.junction].position;
  const Vec2 first = outline.at(out.curve, fan.t_out[ring]), last = outline.at(in.curve, fan.t_in[ring]);
  const double start = angle_of(first - apex);
  double sweep = wrap_two_pi(angle_of(last - apex) - start);
  // At the tip of a needle the two chords may coincide up to rounding.
  const double omega = outline.junctions()[fan.junction].interior_angle;
  if (sweep - omega > pi) sweep -= 2 * pi;
  if (omega - sweep > pi) sweep += 2 * pi;
  std::vector<int> vertices{draft.add_vertex(first)};
  for (int i = 1; i < fan.num_sectors; ++i)
    vertices.push_back(draft.add_vertex(apex + fan.radii[ring] * unit(start + sweep * i / fan.num_sectors)));
  vertices.push_back(draft.add_vertex(last));
  return vertices;
}

/// Splits each quad between two rings into two triangles, symmetrically about the bisector: the larger triangle of the
/// outermost quads lies at the curve.
void add_quads(const std::vector<int>& inner, const std::vector<int>& outer, int layer, Draft& draft) {
  const int count = static_cast<int>(inner.size()) - 1;
  for (int i = 0; i < count; ++i) {
    const int a = inner[i], b = outer[i], c = outer[i + 1], d = inner[i + 1];
    if (2 * i < count) {
      draft.add_triangle(a, b, c, layer);
      draft.add_triangle(a, c, d, layer);
    } else {
      draft.add_triangle(a, b, d, layer);
      draft.add_triangle(b, c, d, layer);
    }
  }
}

}  // namespace

std::vector<Fan> plan_fans(const EdgeFit& fit, const TriangulateOptions& options, const EdgeLimits& limits) {
  const Outline& outline = fit.outline();
  const Clearance clearance(outline);
  std::vector<Fan> fans;
  for (int j = 0; j < static_cast<int>(outline.junctions().size()); ++j) {
    const Junction& junction = outline.junctions()[j];
    const bool may_be_singular = fan_layers(junction_singularity(junction, limits.size), options.fan_factor) > 0;
    if (!may_be_singular && !is_sharp(junction)) continue;
    Fan fan;
    fan.junction = j;
    if (shape_fan(fit, options, limits, clearance.at_junction(j), fan)) fans.push_back(fan);
  }
  return fans;
}

void build_fan(const Outline& outline, Fan& fan, Draft& draft) {
  const SmoothPiece& out = outline.pieces()[fan.junction];
  const SmoothPiece& in = outline.pieces()[out.previous];
  const int apex = draft.add_vertex(outline.junctions()[fan.junction].position);
  std::vector<int> inner(fan.num_sectors + 1, apex);
  double t_out = out.t0, t_in = in.t1;
  for (std::size_t ring = 0; ring < fan.radii.size(); ++ring) {
    const std::vector<int> outer = add_ring(outline, fan, ring, draft);
    if (ring == 0) {
      for (int i = 0; i < fan.num_sectors; ++i) draft.add_triangle(apex, outer[i], outer[i + 1], 0);
    } else {
      add_quads(inner, outer, static_cast<int>(ring), draft);
    }
    draft.edges.push_back({inner.front(), outer.front(), out.curve, t_out, fan.t_out[ring]});
    draft.edges.push_back({outer.back(), inner.back(), in.curve, fan.t_in[ring], t_in});
    t_out = fan.t_out[ring];
    t_in = fan.t_in[ring];
    inner = outer;
  }
  fan.rim = inner;
}

}  // namespace quadrille::triangulate
