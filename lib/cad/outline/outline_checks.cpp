#include "outline/outline_checks.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "base/tolerance.hpp"
#include "base/vec2.hpp"
#include "curve/face_boundary.hpp"
#include "curve/nurbs.hpp"
#include "curve/pole_box.hpp"
#include "curve/project.hpp"

namespace quadrille::outline {
namespace {

// A piece of curve `id` of a loop.
struct Piece : ChordPiece {
  Piece(ChordPiece piece, int of_loop, int of_curve)
      : ChordPiece(std::move(piece)), loop(of_loop), id(of_curve), box(curve::pole_box(curve)) {}

  int loop, id;
  curve::PoleBox box;
};

std::pair<Piece, Piece> halves(const Piece& p) {
  auto [first, second] = p.halves();
  return {{std::move(first), p.loop, p.id}, {std::move(second), p.loop, p.id}};
}

// Poles that coincide within rounding have no direction from one to the other.
double polygon_turning(const Nurbs& curve) {
  constexpr double rounding = 1e-12;
  double turning = 0;
  Vec2 last{};
  for (size_t i = 1; i < curve.poles.size(); ++i) {
    const Vec2 leg = curve.poles[i] - curve.poles[i - 1];
    if (norm(leg) <= rounding * norm(curve.poles[i])) continue;
    if (norm2(last) > 0) turning += std::abs(std::atan2(cross(last, leg), dot(last, leg)));
    last = leg;
  }
  return turning;
}

// Bisects the piece until each part turns by less than a straight angle: such a part cannot intersect itself.
void add_simple(const Piece& piece, int depth, std::vector<Piece>& pieces) {
  if (depth == 0 || polygon_turning(piece.curve) < 1.8) {
    pieces.push_back(piece);
    return;
  }
  const auto [first, second] = halves(piece);
  add_simple(first, depth - 1, pieces);
  add_simple(second, depth - 1, pieces);
}

std::vector<Piece> simple_pieces(const std::vector<Nurbs>& loop, int loop_id) {
  std::vector<Piece> pieces;
  for (int c = 0; c < static_cast<int>(loop.size()); ++c)
    for (ChordPiece& piece : chord_pieces(loop[c])) add_simple({std::move(piece), loop_id, c}, 30, pieces);
  // At least three pieces, so that neighbours share one end and not two.
  while (pieces.size() < 3) {
    std::vector<Piece> finer;
    for (const Piece& p : pieces) {
      auto [first, second] = halves(p);
      finer.push_back(std::move(first));
      finer.push_back(std::move(second));
    }
    pieces = std::move(finer);
  }
  return pieces;
}

// Whether a, which ends where b starts, and b leave their common point in one direction, within rounding.
bool form_cusp(const Nurbs& a, const Nurbs& b) {
  const Vec2 back = -curve::tangent(a, a.end(), true), ahead = curve::tangent(b, b.begin());
  return std::abs(std::atan2(cross(back, ahead), dot(back, ahead))) <= tolerance::same_angle;
}

// Where two pieces meet, with the parameters there.
struct Meeting {
  Vec2 position;
  double t_a = 0, t_b = 0;
};

class ContactSearch {
 public:
  explicit ContactSearch(double tol) : tol_(tol) {}

  // Where a and b are closer than the tolerance; std::nullopt if they are farther apart everywhere.
  std::optional<Meeting> meet(const Piece& a, const Piece& b) { return meet(a, b, tol_); }

  std::optional<Meeting> meet(const Piece& a, const Piece& b, double tol) {
    const double d = distance_of_segments(a.a(), a.b(), b.a(), b.b());
    if (d > a.width + b.width + tol) return std::nullopt;
    // For coincident curves the bisection never decides: an exhausted budget means contact.
    if (a.width + b.width <= tol / 4 || --budget_ < 0) return meeting(a, b);
    const bool first = a.width >= b.width;
    const auto [p, q] = halves(first ? a : b);
    if (const auto hit = first ? meet(p, b, tol) : meet(a, p, tol)) return hit;
    return first ? meet(q, b, tol) : meet(a, q, tol);
  }

  // The same if b starts at the end of a: a contact elsewhere than at the common point.
  std::optional<Meeting> meet_again(const Piece& a, const Piece& b) {
    return meet_again(a, b, form_cusp(a.curve, b.curve));
  }

  void restart() { budget_ = 20000; }

 private:
  static double size(const Piece& p) { return p.box.diagonal(); }

  std::optional<Meeting> meet_again(const Piece& a, const Piece& b, bool is_cusp) {
    if (apart(a.curve, b.curve)) return std::nullopt;
    if (std::max(size(a), size(b)) < 10 * tol_) return std::nullopt;
    const auto [a_far, a_near] = halves(a);
    const auto [b_near, b_far] = halves(b);
    const double tol = is_cusp ? tolerance_in_cusp(a_near, b_near) : tol_;
    if (tol == 0) return std::nullopt;
    if (const auto hit = meet(a_far, b_far, tol)) return hit;
    if (const auto hit = meet(a_far, b_near, tol)) return hit;
    if (const auto hit = meet(a_near, b_far, tol)) return hit;
    return meet_again(a_near, b_near, is_cusp);
  }

  // The curves of a cusp come nearer to each other than the tolerance; they are in contact only if they come much
  // nearer than at the far ends of a and b. 0: these ends are so near to the tip that their separation is a rounding
  // error.
  double tolerance_in_cusp(const Piece& a, const Piece& b) const {
    constexpr double largest_tip = 1e6;  // in tolerances: pieces of this size that are as near lie upon each other
    const double separation =
        std::min(curve::project(b.curve, a.a()).distance, curve::project(a.curve, b.b()).distance);
    if (separation > 1e-4 * tol_ + 1e-14 * norm(b.a())) return std::min(tol_, 1e-3 * separation);
    return std::max(size(a), size(b)) > largest_tip * tol_ ? tol_ : 0;
  }

  // The intersection of the chords.
  static Meeting meeting(const Piece& a, const Piece& b) {
    const Vec2 d = a.b() - a.a(), e = b.b() - b.a(), between = b.a() - a.a();
    const double n = cross(d, e);
    const auto fraction = [n](double part) { return n == 0 ? 0.5 : std::clamp(part / n, 0.0, 1.0); };
    const double s = fraction(cross(between, e)), r = fraction(cross(between, d));
    return {a.a() + s * d, a.at(s), b.at(r)};
  }

  // Whether the poles of a and b, seen from the common point, lie in disjoint cones.
  static bool apart(const Nurbs& a, const Nurbs& b) {
    const Vec2 joint = b.poles.front();
    struct Cone {
      Vec2 axis;
      double low = 0, high = 0;
    };
    const auto cone = [joint](auto begin, auto end) {
      Cone c;
      for (auto p = begin; p != end; ++p) {
        const Vec2 d = *p - joint;
        if (norm2(d) == 0) continue;
        if (norm2(c.axis) == 0) c.axis = d;
        const double angle = std::atan2(cross(c.axis, d), dot(c.axis, d));
        c.low = std::min(c.low, angle), c.high = std::max(c.high, angle);
      }
      return c;
    };
    const Cone p = cone(std::next(a.poles.rbegin()), a.poles.rend()),
               q = cone(std::next(b.poles.begin()), b.poles.end());
    if (p.high - p.low > 3 || q.high - q.low > 3) return false;
    const double between = wrap_two_pi(std::atan2(cross(p.axis, q.axis), dot(p.axis, q.axis)));
    return between + q.low > p.high + tolerance::round_off && between + q.high < 2 * pi + p.low - tolerance::round_off;
  }

  double tol_;
  int budget_ = 0;
};

}  // namespace

ChordPiece::ChordPiece(Nurbs piece) : curve(std::move(piece)) {
  for (const Vec2 p : curve.poles) width = std::max(width, distance_to_segment(p, a(), b()));
}

std::pair<ChordPiece, ChordPiece> ChordPiece::halves() const {
  const double middle = (curve.begin() + curve.end()) / 2;
  return {ChordPiece(curve::trimmed(curve, curve.begin(), middle)),
          ChordPiece(curve::trimmed(curve, middle, curve.end()))};
}

std::vector<ChordPiece> chord_pieces(const Nurbs& curve) {
  std::vector<ChordPiece> pieces;
  curve::for_each_span(curve, [&](double t0, double t1) { pieces.emplace_back(curve::trimmed(curve, t0, t1)); });
  return pieces;
}

std::optional<Contact> find_contact(const std::vector<std::vector<Nurbs>>& loops, double tol) {
  std::vector<Piece> pieces;
  std::vector<size_t> next;
  for (int l = 0; l < static_cast<int>(loops.size()); ++l) {
    const size_t first = pieces.size();
    for (Piece& p : simple_pieces(loops[l], l)) pieces.push_back(std::move(p));
    for (size_t i = first; i < pieces.size(); ++i) next.push_back(i + 1 < pieces.size() ? i + 1 : first);
  }
  std::vector<size_t> by_x(pieces.size());
  for (size_t i = 0; i < by_x.size(); ++i) by_x[i] = i;
  std::stable_sort(by_x.begin(), by_x.end(),
                   [&](size_t i, size_t j) { return pieces[i].box.low.x < pieces[j].box.low.x; });

  ContactSearch search(tol);
  for (size_t m = 0; m < by_x.size(); ++m)
    for (size_t n = m + 1; n < by_x.size(); ++n) {
      const auto [i, j] = std::minmax(by_x[m], by_x[n]);
      const Piece &a = pieces[i], &b = pieces[j];
      if (pieces[by_x[n]].box.low.x > pieces[by_x[m]].box.high.x + tol) break;
      if (!a.box.meets(b.box, tol)) continue;
      search.restart();
      const bool is_after = next[i] != j && next[j] == i;
      const Piece &first = is_after ? b : a, &second = is_after ? a : b;
      const auto hit = next[i] == j || is_after ? search.meet_again(first, second) : search.meet(first, second);
      if (hit) return Contact{first.loop, first.id, second.loop, second.id, hit->position, hit->t_a, hit->t_b};
    }
  return std::nullopt;
}

int winding_number(const std::vector<Nurbs>& loop, Vec2 x) { return curve::CurveTree(loop).winding_number(x); }

}  // namespace quadrille::outline
