#include "sew/chart_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "curve/move_ends.hpp"
#include "curve/nurbs.hpp"
#include "sew/cut_curve.hpp"
#include "sew/sew_regions.hpp"
#include "surface/nurbs_surface.hpp"
#include "surface/space_extent.hpp"

namespace quadrille::sew {
namespace {

constexpr double image_accuracy = 1e-7;  // diameters, of curves of one chart to each other
constexpr int samples_of_piece = 16;

struct ChartNode {
  Vec2 image;
  Vec3 space;
};

struct MeetingCurve {
  const Nurbs* image = nullptr;
  const SpaceCurve* space = nullptr;
  int cad_edge = 0;
  bool is_round = false;  ///< closed, and smooth where it closes: the seam is no node
  std::array<int, 2> ends{-1, -1};
  std::vector<Cut> cuts;
  bool is_twin = false;  ///< the other side of a curve before it

  bool has(int node) const {
    return ends[0] == node || ends[1] == node ||
           std::ranges::any_of(cuts, [&](const Cut& cut) { return cut.place == node; });
  }
};

// A curve in space as two in planes, for operations that do not mix coordinates.
Nurbs in_plane(const SpaceCurve& curve, double Vec3::*second) {
  Nurbs result{curve.degree, curve.knots, {}, curve.weights};
  for (const Vec3& pole : curve.poles) result.poles.push_back({pole.x, pole.*second});
  return result;
}

SpaceCurve in_space(const Nurbs& xy, const Nurbs& xz) {
  SpaceCurve curve{xy.degree, xy.knots, {}, xy.weights};
  for (std::size_t i = 0; i < xy.poles.size(); ++i)
    curve.poles.push_back({xy.poles[i].x, xy.poles[i].y, xz.poles[i].y});
  return curve;
}

/// Finds nodes and cuts.
class Meeting {
 public:
  Meeting(const CadFace& face, const std::vector<ChartCurve>& inner, const MeetOptions& options)
      : face_(face), options_(options), size_(surface::diameter(*face.chart)) {
    for (int c = 0; c < face.num_curves(); ++c)
      curves_.push_back(
          {&face.curves[c], &face.chart->space_curves[c], face.curve_cad_edges[c], is_round_loop(c), {}, {}});
    for (const ChartCurve& c : inner)
      curves_.push_back({&c.image, &c.space, c.cad_edge, curve::has_smooth_seam(c.image), {}, {}});
    for (MeetingCurve& c : curves_) c.ends = {-1, -1};
    for (int c = 0; c < face.num_curves(); ++c) curves_[c].is_twin = face.is_interface(c) && face.partners[c] < c;
  }

  std::vector<ChartPiece> pieces() {
    add_joints();
    add_inner_ends();
    const int num_ends = static_cast<int>(nodes_.size());
    for (int n = num_joints_; n < num_ends; ++n) cut_at(n);
    for (int a = num_outer(); a < num_curves(); ++a)
      for (int b = num_outer(); b < a; ++b) add_crossings(curves_[b], curves_[a]);
    std::vector<ChartPiece> all;
    for (int c = 0; c < num_curves(); ++c) {
      if (curves_[c].is_twin) continue;
      for (ChartPiece& piece : pieces_of(c))
        if (c < num_outer() || !is_known(piece, all)) all.push_back(std::move(piece));
    }
    return all;
  }

 private:
  int num_outer() const { return face_.num_curves(); }
  int num_curves() const { return static_cast<int>(curves_.size()); }
  bool is_round_loop(int c) const { return face_.next_in_loop(c) == c && curve::has_smooth_seam(face_.curves[c]); }

  int add_node(const ChartNode& node) {
    nodes_.push_back(node);
    return static_cast<int>(nodes_.size()) - 1;
  }

  /// Joints of several regions at one place are one node.
  void add_joints() {
    for (int c = 0; c < num_outer(); ++c) {
      if (curves_[c].is_round) continue;
      const ChartNode joint{face_.curves[c].poles.front(), curves_[c].space->poles.front()};
      const auto known = std::ranges::find(nodes_, joint.image, &ChartNode::image);
      curves_[c].ends[0] = known == nodes_.end() ? add_node(joint) : static_cast<int>(known - nodes_.begin());
    }
    for (int c = 0; c < num_outer(); ++c) curves_[c].ends[1] = curves_[face_.next_in_loop(c)].ends[0];
    num_joints_ = static_cast<int>(nodes_.size());
  }

  int nearest_node(Vec3 x) const {
    int nearest = -1;
    double least = options_.tolerance;
    for (std::size_t n = 0; n < nodes_.size(); ++n)
      if (const double d = distance(nodes_[n].space, x); d <= least) least = d, nearest = static_cast<int>(n);
    return nearest;
  }

  void add_inner_ends() {
    for (int c = num_outer(); c < num_curves(); ++c) {
      MeetingCurve& curve = curves_[c];
      if (curve.is_round) continue;
      for (const int end : {0, 1}) {
        const ChartNode here{end == 0 ? curve.image->poles.front() : curve.image->poles.back(),
                             end == 0 ? curve.space->poles.front() : curve.space->poles.back()};
        const int known = nearest_node(here.space);
        curve.ends[end] = known >= 0 ? known : add_node(here);
      }
    }
  }

  /// Cuts the curves that pass the node, which moves onto the first of them.
  void cut_at(int n) {
    bool is_first = true;
    for (MeetingCurve& curve : curves_) {
      if (curve.is_twin || curve.has(n)) continue;
      const surface::CurveProjection foot = surface::project(*curve.space, nodes_[n].space);
      if (foot.distance > options_.tolerance) {
        if (is_first && foot.distance <= options_.slip * size_) refuse_slip(n, curve, foot.distance);
        continue;
      }
      if (!curve.is_round && is_near_end(curve, foot.position)) continue;
      curve.cuts.push_back({foot.t, n});
      if (is_first) nodes_[n] = {curve::point(*curve.image, foot.t), foot.position};
      is_first = false;
    }
  }

  bool is_near_end(const MeetingCurve& curve, Vec3 x) const {
    return std::min(distance(x, curve.space->poles.front()), distance(x, curve.space->poles.back())) <=
           2 * options_.tolerance;
  }

  [[noreturn]] void refuse_slip(int n, const MeetingCurve& before, double gap) const {
    const auto own =
        std::ranges::find_if(curves_, [&](const MeetingCurve& c) { return c.ends[0] == n || c.ends[1] == n; });
    throw FormatError(fmt::format(
        "{}: the curve of edge {} ends at {}, {:.3g} before edge {}: let it end there, or give --heal-tolerance {:.1g}",
        options_.file, own->cad_edge, position_text(nodes_[n].space), gap, before.cad_edge, 1.5 * gap / size_));
  }

  void add_crossings(MeetingCurve& a, MeetingCurve& b) {
    const double near = image_accuracy * face_.diameter;
    if (std::min(one_sided_separation(*a.image, *b.image), one_sided_separation(*b.image, *a.image)) <= near) return;
    const std::string what = fmt::format("{}: edges {} and {}", options_.file, a.cad_edge, b.cad_edge);
    for (const CurveCrossing& crossing : curve_crossings(*a.image, *b.image, near, what)) {
      const auto [t_a, t_b] = nearest_in_space(*a.space, crossing.t_a, *b.space, crossing.t_b);
      const Vec3 x = surface::point(*a.space, t_a);
      int node = nearest_node(x);
      if (node < 0) node = add_node({curve::point(*a.image, t_a), x});
      if (!a.has(node)) a.cuts.push_back({t_a, node});
      if (!b.has(node)) b.cuts.push_back({t_b, node});
    }
  }

  /// Newton's method for the least distance, from parameters that are nearly right.
  static std::pair<double, double> nearest_in_space(const SpaceCurve& a, double t_a, const SpaceCurve& b, double t_b) {
    for (int step = 0; step < 8; ++step) {
      const auto p = surface::derivatives(a, t_a), q = surface::derivatives(b, t_b);
      const Vec3 off = p[0] - q[0];
      const double aa = norm2(p[1]), ab = dot(p[1], q[1]), bb = norm2(q[1]), det = aa * bb - ab * ab;
      if (!(det > 0)) break;
      const double f = dot(off, p[1]), g = dot(off, q[1]);
      t_a = std::clamp(t_a - (bb * f - ab * g) / det, a.begin(), a.end());
      t_b = std::clamp(t_b - (ab * f - aa * g) / det, b.begin(), b.end());
    }
    return {t_a, t_b};
  }

  /// The image has the knots of the curve in space, and more: near one of them both are cut there.
  static void move_cuts_to_knots(MeetingCurve& curve) {
    const std::vector<double>& knots = curve.image->knots;
    for (Cut& cut : curve.cuts)
      for (const double knot : knots)
        if (std::abs(knot - cut.t) <= 1e-8 * (knots.back() - knots.front())) cut.t = knot;
  }

  std::vector<ChartPiece> pieces_of(int c) {
    MeetingCurve& curve = curves_[c];
    move_cuts_to_knots(curve);
    const std::vector<CutPiece> images = cut_curve(*curve.image, curve.cuts, curve.ends[0]),
                                xy = cut_curve(in_plane(*curve.space, &Vec3::y), curve.cuts, curve.ends[0]),
                                xz = cut_curve(in_plane(*curve.space, &Vec3::z), curve.cuts, curve.ends[0]);
    const bool is_whole = images.front().start < 0;
    const int seam = is_whole ? add_node({curve.image->poles.front(), curve.space->poles.front()}) : -1;
    std::vector<ChartPiece> pieces;
    for (std::size_t i = 0; i < images.size(); ++i) {
      const bool is_last = i + 1 == images.size(), has_ends = is_whole || !curve.is_round;
      ChartPiece piece{c,
                       images[i].curve,
                       in_space(xy[i].curve, xz[i].curve),
                       images[i].start,
                       0,
                       has_ends && i == 0,
                       has_ends && is_last};
      piece.to = !is_last ? images[i + 1].start : curve.is_round ? images.front().start : curve.ends[1];
      if (is_whole) piece.from = piece.to = seam;
      curve::move_ends(piece.space.poles, nodes_[piece.from].space, nodes_[piece.to].space);
      curve::move_ends(piece.image.poles, nodes_[piece.from].image, nodes_[piece.to].image);
      pieces.push_back(std::move(piece));
    }
    return pieces;
  }

  /// Whether another piece lies along it.
  bool is_known(const ChartPiece& piece, const std::vector<ChartPiece>& all) const {
    return std::ranges::any_of(all, [&](const ChartPiece& other) {
      if (std::minmax({other.from, other.to}) != std::minmax({piece.from, piece.to})) return false;
      for (int i = 1; i < samples_of_piece; ++i) {
        const double t = piece.space.begin() + (piece.space.end() - piece.space.begin()) * i / samples_of_piece;
        if (surface::project(other.space, surface::point(piece.space, t)).distance > options_.tolerance) return false;
      }
      return true;
    });
  }

  const CadFace& face_;
  const MeetOptions& options_;
  double size_;  ///< diameter in space
  std::vector<MeetingCurve> curves_;
  std::vector<ChartNode> nodes_;
  int num_joints_ = 0;
};

}  // namespace

std::vector<ChartPiece> chart_pieces(const CadFace& face, const std::vector<ChartCurve>& curves,
                                     const MeetOptions& options) {
  return Meeting(face, curves, options).pieces();
}

}  // namespace quadrille::sew
