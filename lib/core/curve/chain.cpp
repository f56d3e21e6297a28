#include "curve/chain.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::curve {
namespace {

constexpr double greatest_snap = 1e-3;  ///< of a chain's length
constexpr double same_fraction = 1e-12;

}  // namespace

CurveTable::CurveTable(const CadFace& face, const std::vector<Nurbs>& splines) : face_(&face), splines_(&splines) {}

const Nurbs& CurveTable::curve(int id) const {
  return id < face_->num_curves() ? face_->curves[id] : (*splines_)[id - face_->num_curves()];
}

const ArcLength& CurveTable::arc_length(int id) const {
  const auto known = tables_.find(id);
  return known != tables_.end() ? known->second : tables_.emplace(id, curve(id)).first->second;
}

Chain::Chain(const CurveTable& table, std::vector<ArcPiece> pieces) : table_(&table), pieces_(std::move(pieces)) {
  double length = 0;
  for (const ArcPiece& piece : pieces_) {
    const ArcLength& arc = table_->arc_length(piece.curve);
    arc_lengths_.push_back(&arc);
    starts_.push_back(arc.at(piece.t0));
    length += std::abs(arc.at(piece.t1) - starts_.back());
    ends_.push_back(length);
  }
}

Chain::Place Chain::place(double s) const {
  const double target = std::clamp(s, 0.0, 1.0) * length();
  const size_t i =
      std::min<size_t>(std::lower_bound(ends_.begin(), ends_.end(), target) - ends_.begin(), pieces_.size() - 1);
  const ArcPiece& piece = pieces_[i];
  const double before = i == 0 ? 0 : ends_[i - 1];
  const bool backwards = piece.t0 > piece.t1;
  double t;
  if (target <= before)
    t = piece.t0;
  else if (target >= ends_[i])
    t = piece.t1;
  else
    t = arc_lengths_[i]->parameter(starts_[i] + (backwards ? before - target : target - before));
  const auto [low, high] = std::minmax(piece.t0, piece.t1);
  return {i, std::clamp(t, low, high)};
}

ChainPoint Chain::at(double s) const {
  const auto [i, t] = place(s);
  const ArcPiece& piece = pieces_[i];
  const Nurbs& curve = table_->curve(piece.curve);
  // At the far end of a piece the tangent is the limit from inside the piece, not of the curve beyond the piece.
  const Vec2 along = tangent(curve, t, t == std::max(piece.t0, piece.t1));
  return {point(curve, t), piece.t0 > piece.t1 ? -along : along, static_cast<int>(i), t};
}

Vec2 Chain::position(double s) const {
  const auto [i, t] = place(s);
  return point(table_->curve(pieces_[i].curve), t);
}

std::vector<double> Chain::joint_fractions() const {
  std::vector<double> fractions;
  for (size_t i = 0; i + 1 < ends_.size(); ++i) fractions.push_back(ends_[i] / length());
  return fractions;
}

bool Chain::is_smooth_seam(size_t i) const {
  const ArcPiece &a = pieces_[i], &b = pieces_[i + 1];
  if (a.curve != b.curve || !table_->is_cad_curve(a.curve)) return false;
  const Nurbs& curve = table_->curve(a.curve);
  const bool meets = (a.t1 == curve.end() && b.t0 == curve.begin()) || (a.t1 == curve.begin() && b.t0 == curve.end());
  return meets && has_smooth_seam(curve);
}

bool Chain::is_whole_curve(size_t i) const {
  const double length = ends_[i] - (i == 0 ? 0 : ends_[i - 1]);
  return length >= arc_lengths_[i]->total() * (1 - 1e-9);
}

bool Chain::is_at_end(double fraction) const {
  const double reach = std::clamp(tolerance::same_point * table_->diameter() / length(), same_fraction, greatest_snap);
  const bool is_at_start = fraction < 0.5;
  const double from_end = is_at_start ? fraction : 1 - fraction;
  if (from_end < same_fraction) return true;
  if (from_end > reach) return false;
  const size_t last = pieces_.size() - 1;
  const double joint = (is_at_start ? ends_[0] : (last > 0 ? ends_[last - 1] : 0)) / length();
  return std::abs(fraction - joint) >= same_fraction || !is_whole_curve(is_at_start ? 0 : last);
}

std::vector<double> Chain::break_fractions() const {
  std::vector<double> fractions;
  for (size_t i = 0; i + 1 < ends_.size(); ++i)
    if (!is_smooth_seam(i)) fractions.push_back(ends_[i] / length());
  for (size_t i = 0; i < pieces_.size(); ++i) {
    const ArcPiece& piece = pieces_[i];
    if (!table_->is_cad_curve(piece.curve)) continue;
    const auto [low, high] = std::minmax(piece.t0, piece.t1);
    for (const double t : smoothness_breaks(table_->curve(piece.curve)))
      if (low < t && t < high) {
        const double inside = std::abs(arc_lengths_[i]->between(piece.t0, t));
        fractions.push_back(((i == 0 ? 0 : ends_[i - 1]) + inside) / length());
      }
  }
  std::sort(fractions.begin(), fractions.end());
  const auto same = [](double a, double b) { return b - a < same_fraction; };
  fractions.erase(std::unique(fractions.begin(), fractions.end(), same), fractions.end());
  std::erase_if(fractions, [&](double f) { return is_at_end(f); });
  return fractions;
}

}  // namespace quadrille::curve
