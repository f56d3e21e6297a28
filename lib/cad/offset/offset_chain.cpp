#include "offset/offset_chain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "curve/chain.hpp"
#include "curve/nurbs.hpp"
#include "model/name_rules.hpp"
#include "offset/offset_curve.hpp"
#include "offset/wall_chains.hpp"
#include "surface/positions.hpp"

namespace quadrille::offset {

namespace {

constexpr int max_steps = 60;

}  // namespace

Vec2 ExtendedCurve::point(double t) const {
  const double inside = std::clamp(t, curve_->begin(), curve_->end());
  return curve::point(*curve_, inside) + (t - inside) * derivative(inside);
}

Vec2 ExtendedCurve::derivative(double t) const {
  const double inside = std::clamp(t, curve_->begin(), curve_->end());
  return curve::derivative(*curve_, inside, inside >= curve_->end());
}

double ExtendedCurve::beside_start(double length) const {
  return curve_->begin() + length / norm(derivative(curve_->begin()));
}

double ExtendedCurve::beside_end(double length) const {
  return curve_->end() + length / norm(derivative(curve_->end()));
}

std::optional<ExtendedCrossing> crossing_near(const ExtendedCurve& a, double t_a, const ExtendedCurve& b, double t_b,
                                              double tolerance) {
  for (int step = 0; step < max_steps; ++step) {
    const Vec2 gap = b.point(t_b) - a.point(t_a), da = a.derivative(t_a), db = b.derivative(t_b);
    if (norm(gap) <= tolerance) return ExtendedCrossing{t_a, t_b, a.point(t_a)};
    const double sine = cross(da, db);
    if (!(std::abs(sine) > 1e-12 * norm(da) * norm(db))) return std::nullopt;
    t_a += cross(gap, db) / sine;
    t_b += cross(gap, da) / sine;
  }
  return std::nullopt;
}

namespace {

/// The part of an offset curve that remains: its ends by parameter, beyond the curve where it is extended.
struct Part {
  double begin = 0, end = 0;
  Vec2 from, to;
};

class ChainMaker {
 public:
  ChainMaker(const CadFace& face, const WallChain& chain, const ChainProfile& profile, const ChartHeights& heights,
             const std::vector<OffsetRequest>& requests)
      : face_(face), chain_(chain), requests_(requests) {
    const double tolerance = offset_constants.fit_tolerance * face.diameter;
    for (std::size_t i = 0; i < chain.curves.size(); ++i) {
      const Nurbs& wall = face.curves[chain.curves[i]];
      curves_.push_back(offset_curve(face, wall, profile.curves[i], heights, tolerance, where(i)));
      const double total = profile.curves[i].is_constant ? 0 : profile.curves[i].by_length.end();
      const auto end = [&](double t, double length) {
        const WallFoot foot{curve::point(wall, t), left_of(curve::tangent(wall, t, length > 0))};
        return heights.in_chart(foot, profile.curves[i].at(length));
      };
      ends_.push_back({end(wall.begin(), 0), end(wall.end(), total)});
      const Nurbs& own = curves_.back();
      parts_.push_back({own.begin(), own.end(), own.poles.front(), own.poles.back()});
    }
    caps_.resize(curves_.size());
  }

  std::vector<heal::LoopCurve> make() {
    const std::size_t count = curves_.size();
    for (std::size_t i = 0; i + 1 < count; ++i) join(i, i + 1);
    if (chain_.is_closed) {
      join(count - 1, 0);
    } else {
      end_at_start();
      end_at_end();
    }
    std::vector<heal::LoopCurve> result;
    for (std::size_t i = 0; i < count; ++i) add_part(i, result);
    return result;
  }

 private:
  std::string where(std::size_t i) const { return requests_[chain_.requests[i]].where; }

  [[noreturn]] void fail(std::size_t i, Vec2 x, const char* why) const {
    throw ComputeError(fmt::format("{}: the curve at this distance {} near {}: use a smaller distance", where(i), why,
                                   surface::position_text(face_, x)));
  }

  void join(std::size_t i, std::size_t j) {
    const Joint& joint = face_.joints[chain_.curves[j]];
    if (!joint.is_corner)
      join_smoothly(i, j);
    else if (joint.interior_angle > offset_constants.least_capped_angle)
      join_by_cap(i, j, joint);
    else
      join_at_crossing(i, j, joint);
  }

  void join_smoothly(std::size_t i, std::size_t j) {
    const Vec2 middle = (curves_[i].poles.back() + curves_[j].poles.front()) / 2;
    parts_[i].to = parts_[j].from = middle;
  }

  void join_by_cap(std::size_t i, std::size_t j, const Joint& joint) {
    const Vec2 ahead = normalized(unit(joint.tangent_in) - unit(joint.tangent_out));
    const Vec2 in = curve::tangent(curves_[i], curves_[i].end(), true),
               out = curve::tangent(curves_[j], curves_[j].begin());
    const double distance = std::max(ends_[i].second, ends_[j].first);
    const auto to_line = [&](Vec2 x, Vec2 direction) {
      return (distance - dot(x - joint.position, ahead)) / dot(direction, ahead);
    };
    const Vec2 a = curves_[i].poles.back(), b = curves_[j].poles.front();
    const ExtendedCurve first(curves_[i]), second(curves_[j]);
    const double beyond_a = to_line(a, in), beyond_b = to_line(b, -out);
    parts_[i].end = first.beside_end(beyond_a);
    parts_[j].begin = second.beside_start(-beyond_b);
    parts_[i].to = a + beyond_a * in;
    parts_[j].from = b - beyond_b * out;
    caps_[i] = true;
  }

  void join_at_crossing(std::size_t i, std::size_t j, const Joint& joint) {
    const double d = ends_[i].second, e = ends_[j].first, angle = joint.interior_angle;
    const ExtendedCurve first(curves_[i]), second(curves_[j]);
    const auto crossing = crossing_near(first, first.beside_end(-(e + d * std::cos(angle)) / std::sin(angle)), second,
                                        second.beside_start((d + e * std::cos(angle)) / std::sin(angle)), tolerance());
    if (!crossing) fail(i, joint.position, "does not go around the corner of the wall");
    parts_[i].end = crossing->t_a;
    parts_[j].begin = crossing->t_b;
    parts_[i].to = parts_[j].from = crossing->position;
  }

  /// Whether the chain and its mirror image make a corner with a line across.
  static bool has_cap(bool is_on_line, const Joint& joint) {
    return is_on_line && 2 * joint.interior_angle > offset_constants.least_capped_angle;
  }

  void end_at_start() {
    const int joint = chain_.curves.front();
    const Joint& corner = face_.joints[joint];
    const Nurbs& boundary = face_.curves[face_.previous_in_loop(joint)];
    const double d = ends_.front().first, angle = corner.interior_angle;
    const ExtendedCurve own(curves_.front()), other(boundary);
    if (has_cap(chain_.begins_on_line, corner)) {
      const Vec2 ahead = -unit(corner.tangent_in), a = curves_.front().poles.front();
      const Vec2 out = curve::tangent(curves_.front(), curves_.front().begin());
      const double beyond = (d - dot(a - corner.position, ahead)) / -dot(out, ahead);
      if (distance(curve::point(boundary, boundary.begin()), corner.position) <= d)
        fail(0, corner.position, "does not end on the boundary beside the wall");
      parts_.front().begin = own.beside_start(-beyond);
      parts_.front().from = a - beyond * out;
      cap_at_start_ = corner.position + d * ahead;
      return;
    }
    const auto crossing = crossing_near(own, own.beside_start(d * std::cos(angle) / std::sin(angle)), other,
                                        other.beside_end(-d / std::sin(angle)), tolerance());
    if (!crossing || crossing->t_b <= boundary.begin() || crossing->t_b > boundary.end())
      fail(0, corner.position, "does not end on the boundary beside the wall");
    parts_.front().begin = crossing->t_a;
    parts_.front().from = curve::point(boundary, crossing->t_b);
  }

  void end_at_end() {
    const std::size_t last = curves_.size() - 1;
    const int joint = face_.next_in_loop(chain_.curves.back());
    const Joint& corner = face_.joints[joint];
    const Nurbs& boundary = face_.curves[joint];
    const double d = ends_.back().second, angle = corner.interior_angle;
    const ExtendedCurve own(curves_.back()), other(boundary);
    if (has_cap(chain_.ends_on_line, corner)) {
      const Vec2 ahead = unit(corner.tangent_out), a = curves_.back().poles.back();
      const Vec2 in = curve::tangent(curves_.back(), curves_.back().end(), true);
      const double beyond = (d - dot(a - corner.position, ahead)) / dot(in, ahead);
      if (distance(curve::point(boundary, boundary.end()), corner.position) <= d)
        fail(last, corner.position, "does not end on the boundary beside the wall");
      parts_.back().end = own.beside_end(beyond);
      parts_.back().to = a + beyond * in;
      cap_at_end_ = corner.position + d * ahead;
      return;
    }
    const auto crossing = crossing_near(own, own.beside_end(-d * std::cos(angle) / std::sin(angle)), other,
                                        other.beside_start(d / std::sin(angle)), tolerance());
    if (!crossing || crossing->t_b < boundary.begin() || crossing->t_b >= boundary.end())
      fail(last, corner.position, "does not end on the boundary beside the wall");
    parts_.back().end = crossing->t_a;
    parts_.back().to = curve::point(boundary, crossing->t_b);
  }

  /// The curve with its extensions: one line along a line.
  void add_part(std::size_t i, std::vector<heal::LoopCurve>& result) const {
    const Nurbs& curve = curves_[i];
    const Part& part = parts_[i];
    const auto add = [&](const Nurbs& piece) {
      const int wall = chain_.curves[i];
      result.push_back({piece, face_.curve_cad_edges[wall], offset_name(face_.curve_names[wall])});
    };
    if (i == 0 && cap_at_start_) add(curve::segment(*cap_at_start_, part.from));
    if (!(part.begin < std::min(part.end, curve.end())) || !(part.end > curve.begin()))
      fail(i, part.from, "leaves nothing between the corners of the wall");
    if (curve::carrier_of(curve).kind == curve::CurveKind::line) {
      add(curve::segment(part.from, part.to));
    } else {
      const double begin = std::max(part.begin, curve.begin()), end = std::min(part.end, curve.end());
      const auto is_extended = [&](bool is_beyond, Vec2 x, Vec2 own_end) {
        return is_beyond && distance(x, own_end) > offset_constants.least_extension * face_.diameter;
      };
      const bool before = is_extended(part.begin < begin, part.from, curve.poles.front());
      const bool after = is_extended(part.end > end, part.to, curve.poles.back());
      const Vec2 from = before ? curve.poles.front() : part.from, to = after ? curve.poles.back() : part.to;
      if (before) add(curve::segment(part.from, from));
      const bool is_whole = begin == curve.begin() && end == curve.end();
      add(curve::with_ends(is_whole ? curve : curve::trimmed(curve, begin, end), from, to));
      if (after) add(curve::segment(to, part.to));
    }
    if (caps_[i]) add(curve::segment(part.to, parts_[i + 1 == parts_.size() ? 0 : i + 1].from));
    if (i + 1 == parts_.size() && cap_at_end_) add(curve::segment(part.to, *cap_at_end_));
  }

  double tolerance() const { return offset_constants.tolerance * face_.diameter / 100; }

  const CadFace& face_;
  const WallChain& chain_;
  const std::vector<OffsetRequest>& requests_;
  std::vector<Nurbs> curves_;                    ///< one for each wall of the chain, whole
  std::vector<std::pair<double, double>> ends_;  ///< distances at both ends of each, in the plane or the chart
  std::vector<Part> parts_;
  std::vector<bool> caps_;                         ///< a line across the bisector follows
  std::optional<Vec2> cap_at_start_, cap_at_end_;  ///< where half of such a line meets the line of symmetry
};

}  // namespace

std::vector<heal::LoopCurve> offset_chain(const CadFace& face, const WallChain& chain, const ChainProfile& profile,
                                          const ChartHeights& heights, const std::vector<OffsetRequest>& requests) {
  return ChainMaker(face, chain, profile, heights, requests).make();
}

}  // namespace quadrille::offset
