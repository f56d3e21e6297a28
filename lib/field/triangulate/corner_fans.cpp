#include "triangulate/corner_fans.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <span>
#include <tuple>

#include "base/angle.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "triangulate/outline.hpp"
#include "triangulate/triangle_sizes.hpp"

namespace quadrille::triangulate {
namespace {

struct FanConstants {
  double acute_angle = radians(75.0), sector_angle = radians(60.0);
  double slack = 1 + tolerance::round_off;
};
constexpr FanConstants fan_constants;

/// Whether two curves at a place are so close to each other, inside or outside the face, that segments along them would
/// be bisected without end. `group`: the junctions there. Outside is between the end of a sector and the start of the
/// next one, unless both are the sides of a slit. The end of a slit is sharp: without vertices beside it the slit could
/// be one edge, at which nothing is cut.
bool is_sharp(const Outline& outline, const std::vector<int>& group) {
  const auto direction = [&](int piece) {
    const SmoothPiece& out = outline.pieces()[piece];
    return angle_of(curve::tangent(outline.face().curves[out.curve], out.t0));
  };
  return std::any_of(group.begin(), group.end(), [&](int junction) {
    const double inside = outline.junctions()[junction].interior_angle;
    double outside = 2 * pi;
    int next = junction;
    for (const int other : group) {
      // Between the sides of a slit there is nothing but rounding.
      const double turn = other == junction ? -inside : direction(other) - direction(junction) - inside;
      const double gap = std::max(0.0, wrap_two_pi(turn + tolerance::same_angle) - tolerance::same_angle);
      if (gap < outside) outside = gap, next = other;
    }
    const bool is_slit = next != junction && outline.pieces()[outline.pieces()[junction].previous].partner == next;
    return inside < fan_constants.acute_angle || (!is_slit && outside < fan_constants.acute_angle);
  });
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

/// The radii of at most `layers` rings around the apex triangles, and of these, innermost first: none is below `least`.
std::vector<double> ring_radii(double radius, int layers, double factor, double least) {
  std::vector<double> radii{radius};
  while (std::ssize(radii) <= layers && radii.back() * factor >= least) radii.push_back(radii.back() * factor);
  std::reverse(radii.begin(), radii.end());
  return radii;
}

/// Sectors of at most `sector_angle`. Between rings there are at least two beside a curved side, so that the larger
/// triangle of each quad lies there (add_quads): the other one would fold.
int num_sectors(const Outline& outline, const Fan& fan) {
  const SmoothPiece& out = outline.pieces()[fan.junction];
  const bool needs_two = fan.radii.size() > 1 && !(out.is_straight && outline.pieces()[out.previous].is_straight);
  const double sectors =
      outline.junctions()[fan.junction].interior_angle / (fan_constants.sector_angle * fan_constants.slack);
  return std::max(needs_two ? 2 : 1, static_cast<int>(std::ceil(sectors)));
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
    return turn <= limits.turn * fan_constants.slack && fit.error(piece.curve, t0, t1) <= limits.curve_tol;
  };
  return keeps(out, out0, fan.t_out[last]) && keeps(in, fan.t_in[last], in1) &&
         turns <= fit.outline().junctions()[fan.junction].interior_angle * fan_constants.slack;
}

/// Sets radii and side vertices of the fans `fans`, whose junctions are in one place, to the same radii. Returns false
/// if they are not needed and have no layers.
bool shape_fans(const EdgeFit& fit, const TriangulateOptions& options, const EdgeLimits& limits, bool is_needed,
                std::span<Fan> fans) {
  const Outline& outline = fit.outline();
  double radius = limits.size;
  for (const Fan& fan : fans) radius = std::min(radius, fan.radius);
  const double smallest = options.least_fan_radius * outline.face().diameter;
  constexpr int max_rounds = 60;
  for (int round = 0; round < max_rounds; ++round) {
    int layers = 0;
    for (const Fan& fan : fans)
      layers = std::max(
          layers, fan_layers(junction_singularity(outline.junctions()[fan.junction], radius), options.fan_factor));
    if (layers > 0 && options.fan_layers >= 0) layers = options.fan_layers;
    if (layers == 0 && !is_needed) return false;
    bool do_keep = true;
    for (Fan& fan : fans) {
      fan.radius = radius;
      fan.radii = ring_radii(radius, layers, options.fan_factor, smallest);
      fan.num_sectors = num_sectors(outline, fan);
      place_sides(outline, fan);
      do_keep = do_keep && keeps_limits(fit, fan, limits);
    }
    if (do_keep) break;
    radius *= 0.8;
  }
  return true;
}

/// The vertices of fans on slits, where two fans, or both ends of one, meet.
class SlitVertices {
 public:
  SlitVertices(const Outline& outline, Draft& draft) : outline_(&outline), draft_(&draft) {}

  int apex(int junction) {
    const Junction& there = outline_->junctions()[junction];
    const auto [found, is_new] = apexes_.try_emplace(there.place, 0);
    if (is_new) found->second = draft_->add_vertex(there.position);
    return found->second;
  }
  /// The vertex of ring `ring` at the start or the end of a piece.
  int side(int piece, bool at_start, std::size_t ring, Vec2 position) {
    if (outline_->pieces()[piece].partner < 0) return draft_->add_vertex(position);
    const bool is_second = outline_->is_second_side(piece);
    const auto [found, is_new] = sides_.try_emplace(
        {is_second ? outline_->pieces()[piece].partner : piece, is_second ? !at_start : at_start, ring}, 0);
    if (is_new) found->second = draft_->add_vertex(position);
    return found->second;
  }

 private:
  const Outline* outline_;
  Draft* draft_;
  std::map<int, int> apexes_;                                ///< by place
  std::map<std::tuple<int, bool, std::size_t>, int> sides_;  ///< by first side, its end, and ring
};

/// The vertices of one ring, from the outgoing to the incoming curve.
std::vector<int> add_ring(const Outline& outline, const Fan& fan, std::size_t ring, SlitVertices& slits, Draft& draft) {
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
  std::vector<int> vertices{slits.side(fan.junction, true, ring, first)};
  for (int i = 1; i < fan.num_sectors; ++i)
    vertices.push_back(draft.add_vertex(apex + fan.radii[ring] * unit(start + sweep * i / fan.num_sectors)));
  vertices.push_back(slits.side(out.previous, false, ring, last));
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

void build_fan(const Outline& outline, Fan& fan, SlitVertices& slits, Draft& draft) {
  const SmoothPiece& out = outline.pieces()[fan.junction];
  const SmoothPiece& in = outline.pieces()[out.previous];
  const int apex = slits.apex(fan.junction);
  std::vector<int> inner(fan.num_sectors + 1, apex);
  double t_out = out.t0, t_in = in.t1;
  for (std::size_t ring = 0; ring < fan.radii.size(); ++ring) {
    const std::vector<int> outer = add_ring(outline, fan, ring, slits, draft);
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

}  // namespace

std::vector<Fan> plan_fans(const EdgeFit& fit, const TriangulateOptions& options, const EdgeLimits& limits) {
  const Outline& outline = fit.outline();
  const auto& junctions = outline.junctions();
  const Clearance clearance(outline);
  const TriangleSizes sizes({}, limits.size, options.growth, options.size_points);
  std::map<int, std::vector<int>> places;
  for (int j = 0; j < static_cast<int>(junctions.size()); ++j) places[junctions[j].place].push_back(j);
  std::vector<Fan> fans;
  for (const auto& [place, group] : places) {
    const bool is_needed = is_sharp(outline, group);
    const auto has_layers = [&](int j) {
      return fan_layers(junction_singularity(junctions[j], limits.size), options.fan_factor) > 0;
    };
    if (!is_needed && std::none_of(group.begin(), group.end(), has_layers)) continue;
    std::vector<Fan> fans_here;
    for (const int j : group) {
      Fan fan;
      fan.junction = j;
      const SmoothPiece &out = outline.pieces()[j], &in = outline.pieces()[out.previous];
      fan.radius =
          std::min({sizes.at(junctions[j].position), clearance.at_junction(j) / 3, out.length() / 3, in.length() / 3});
      fans_here.push_back(std::move(fan));
    }
    if (shape_fans(fit, options, limits, is_needed, fans_here))
      std::move(fans_here.begin(), fans_here.end(), std::back_inserter(fans));
  }
  return fans;
}

void build_fans(const Outline& outline, std::span<Fan> fans, Draft& draft) {
  SlitVertices slits(outline, draft);
  for (Fan& fan : fans) build_fan(outline, fan, slits, draft);
}

}  // namespace quadrille::triangulate
