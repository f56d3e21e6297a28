#include "layers/wall_line.hpp"

#include <algorithm>
#include <cmath>

#include "curve/nurbs.hpp"
#include "layers/layer_rules.hpp"

namespace quadrille::layers {
namespace {

constexpr int max_steps = 40;

}  // namespace

Vec2 direction(const curve::CurveTable& table, const ArcPiece& piece, bool at_end) {
  const bool forwards = piece.t0 <= piece.t1;
  const double t = at_end ? piece.t1 : piece.t0;
  const Vec2 along = curve::tangent(table.curve(piece.curve), t, forwards == at_end);
  return forwards ? along : -along;
}

WallLine::WallLine(const curve::CurveTable& table, std::vector<ArcPiece> pieces)
    : table_(&table), pieces_(std::move(pieces)) {
  for (std::size_t i = 0; i + 1 < pieces_.size(); ++i)
    bends_.push_back(std::abs(cross(direction(table, pieces_[i], true), direction(table, pieces_[i + 1], false))) >
                     layer_constants.least_bend);
  bends_.push_back(false);
}

WallPoint WallLine::entry(const WallPoint& foot, int step) const {
  const int piece = foot.piece + step;
  return {piece, step > 0 ? pieces_[piece].t0 : pieces_[piece].t1};
}

double WallLine::distance_at(Vec2 x, const WallPoint& foot) const {
  return quadrille::distance(x, curve::point(table_->curve(pieces_[foot.piece].curve), foot.t));
}

double WallLine::distance_beyond(Vec2 x, int step) const {
  const ArcPiece& piece = step < 0 ? pieces_.front() : pieces_.back();
  const Vec2 end = curve::point(table_->curve(piece.curve), step < 0 ? piece.t0 : piece.t1);
  return std::abs(cross(direction(*table_, piece, step > 0), x - end));
}

int WallLine::move_foot(Vec2 x, WallPoint& foot) const {
  const ArcPiece& piece = pieces_[foot.piece];
  const Nurbs& curve = table_->curve(piece.curve);
  const double low = std::min(piece.t0, piece.t1), high = std::max(piece.t0, piece.t1);
  double slope = 0;
  for (int step = 0; step < max_steps; ++step) {
    const auto d = curve::derivatives(curve, foot.t, foot.t >= high);
    slope = dot(d[0] - x, d[1]);
    const double speed2 = norm2(d[1]), bend = speed2 + dot(d[0] - x, d[2]);
    if (speed2 == 0) break;
    // Newton where the squared distance is convex, else Gauss-Newton.
    const double next = std::clamp(foot.t - slope / (bend > 0.1 * speed2 ? bend : speed2), low, high);
    const double move = std::abs(next - foot.t);
    foot.t = next;
    if (move <= 1e-14 * (high - low)) break;
  }
  const bool forwards = piece.t0 <= piece.t1;
  if (foot.t <= low && slope > 0) return forwards ? -1 : 1;
  if (foot.t >= high && slope < 0) return forwards ? 1 : -1;
  return 0;
}

double WallLine::follow_pieces(Vec2 x, WallPoint& foot) const {
  int beyond = move_foot(x, foot);
  double nearest = distance_at(x, foot);
  while (beyond != 0) {
    if (!has_piece(foot.piece + beyond)) {
      if (is_extended_[beyond < 0 ? 0 : 1]) nearest = distance_beyond(x, beyond);
      break;
    }
    WallPoint next = entry(foot, beyond);
    const int further = move_foot(x, next);
    const double d = distance_at(x, next);
    if (d >= nearest) break;
    nearest = d, foot = next;
    if (further == -beyond) break;
    beyond = further;
  }
  return nearest;
}

double WallLine::distance(Vec2 x, WallPoint& foot) const {
  double nearest = follow_pieces(x, foot);
  for (const int step : {-1, 1}) {  // in a corner of less than 180 degrees both parts have a nearest point
    const int piece = foot.piece + step;
    if (!has_piece(piece) || !bends_[std::min(piece, foot.piece)]) continue;
    WallPoint other = entry(foot, step);
    move_foot(x, other);
    const double d = distance_at(x, other);
    if (d < nearest) nearest = d, foot = other;
  }
  return nearest;
}

}  // namespace quadrille::layers
