#include "chart/intrinsic_triangles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "chart/surface_mesh.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::chart {
namespace {

constexpr double longest_side = 0.04, shortest_half = 1e-4;  // of the size of the face
constexpr double most_turn = 0.3;                            // of the normal along a side, radians
// Along a side so short, of the size of the face, a normal that turns by more is that of a surface that turns over.
constexpr double short_side = 4e-4, turned_over = 2.5, beside_pole = 4e-3;
constexpr double flat_angle = 1e-6;  // the least angle of a triangle with its corners on one line, radians
constexpr double least_gain = 1e-9;  // radians: rounding errors flip nothing
constexpr std::size_t most_triangles = 40000;

/// The angle opposite to side a, in [0, pi].
double angle_opposite(double a, double b, double c) {
  const double area4 = std::sqrt(std::max((a + b + c) * (b + c - a) * (c + a - b) * (a + b - c), 0.0));
  return std::atan2(area4, b * b + c * c - a * a);
}

/// Whether the angles opposite to the side that two triangles share, with the other sides b and c, are below pi
/// together by more than rounding errors: whether their cotangents have a positive sum. Flips of such a side make no
/// least angle greater.
bool is_delaunay(double side, double b1, double c1, double b2, double c2) {
  constexpr double rounding = 1e-9;
  const auto area4 = [side](double b, double c) {
    return std::sqrt(std::max((side + b + c) * (b + c - side) * (c + side - b) * (side + b - c), 0.0));
  };
  const double area1 = area4(b1, c1), area2 = area4(b2, c2);
  const double cosines = (b1 * b1 + c1 * c1 - side * side) * area2 + (b2 * b2 + c2 * c2 - side * side) * area1;
  return cosines > rounding * ((b1 * b1 + c1 * c1) * area2 + (b2 * b2 + c2 * c2) * area1);
}

double least_angle(double a, double b, double c) {
  return std::min({angle_opposite(a, b, c), angle_opposite(b, c, a), angle_opposite(c, a, b)});
}

class Builder {
 public:
  Builder(const SpaceFace& face, const std::vector<SpaceLength>& lengths) : face_(face), lengths_(lengths) {
    result_.vertices = face.vertices, result_.boundary_edges = face.boundary_edges;
    for (std::size_t t = 0; t < face.triangles.size(); ++t)
      result_.triangles.push_back({face.triangles[t], face.triangle_uv[t], {}, {}});
    set_normals();
    glue();
    measure();
  }

  // Triangles of the kernel with a corner at a pole may have all corners on one line of the surface. A side of these
  // would be halved at a point where a vertex is already: they are flipped before.
  IntrinsicTriangles made() {
    if (has_pole()) flip_sides(flat_angle);
    while (result_.triangles.size() < most_triangles && split_sides()) continue;
    require_no_fold();
    flip_sides(pi);
    return std::move(result_);
  }

 private:
  /// A side: 3 t + k.
  IntrinsicTriangle& of(int side) { return result_.triangles[side / 3]; }
  const IntrinsicTriangle& of(int side) const { return result_.triangles[side / 3]; }
  static int next(int side) { return side % 3 == 2 ? side - 2 : side + 1; }
  static int last(int side) { return next(next(side)); }
  int num_sides() const { return 3 * static_cast<int>(result_.triangles.size()); }
  double length(int side) const { return of(side).lengths[side % 3]; }
  int across(int side) const { return of(side).across[side % 3]; }
  int vertex(int side) const { return of(side).vertices[side % 3]; }  ///< at which the side begins
  Vec2 uv(int side) const { return of(side).uv[side % 3]; }

  Vec3 normal(int side) const { return result_.normals[vertex(side)]; }
  bool is_pole(int side) const { return norm2(normal(side)) == 0; }

  void set_normals();
  void glue();
  void measure();
  void flip_sides(double most_angle);
  void flip_if_better(int side, double most_angle);
  bool split_sides();
  void split(int side);
  double turn(int side) const;
  bool is_to_be_split(int side) const;
  Vec2 middle_uv(int side) const;
  bool has_pole() const;
  void require_no_fold() const;
  std::pair<Vec3, Vec2> middle(int side) const;
  void set(int t, const std::array<int, 3>& vertices, const std::array<Vec2, 3>& uv,
           const std::array<double, 3>& lengths, const std::array<int, 3>& across);
  Vec2 whole_periods(Vec2 difference) const;

  const SpaceFace& face_;
  const std::vector<SpaceLength>& lengths_;
  IntrinsicTriangles result_;
  std::vector<int> suspects_;  ///< sides that may be flipped
  double size_ = 0;            ///< of the face, a length
};

void Builder::set_normals() {
  std::vector<bool> is_set(result_.vertices.size(), false);
  result_.normals.resize(result_.vertices.size());
  for (int side = 0; side < num_sides(); ++side)
    if (!is_set[vertex(side)])
      result_.normals[vertex(side)] = face_normal(face_, uv(side)), is_set[vertex(side)] = true;
}

void Builder::glue() {
  std::map<std::pair<int, int>, int> side_of;
  for (int side = 0; side < num_sides(); ++side) side_of[{vertex(side), vertex(next(side))}] = side;
  for (int side = 0; side < num_sides(); ++side) {
    const auto other = side_of.find({vertex(next(side)), vertex(side)});
    of(side).across[side % 3] = other == side_of.end() ? num_sides() : other->second;
  }
  for (int b = 0; b < static_cast<int>(result_.boundary_edges.size()); ++b) {
    const auto found = side_of.find({result_.boundary_edges[b].vertices[0], result_.boundary_edges[b].vertices[1]});
    if (found == side_of.end()) throw Defect("an edge of the boundary belongs to no fine triangle");
    of(found->second).across[found->second % 3] = -1 - b;
  }
  for (int side = 0; side < num_sides(); ++side)
    if (across(side) == num_sides()) throw Defect("a side of a fine triangle is neither shared nor on the boundary");
}

void Builder::measure() {
  for (const Vec3& x : result_.vertices) size_ = std::max(size_, distance(x, result_.vertices.front()));
  for (int side = 0; side < num_sides(); ++side) {
    const Vec3 a = result_.vertices[vertex(side)], b = result_.vertices[vertex(next(side))];
    of(side).lengths[side % 3] = distance(a, b);
    if (across(side) < 0 && a == b)
      throw ComputeError(fmt::format("edge {} has no length at {}: remove it in the CAD system",
                                     face_.face.curve_cad_edges[result_.boundary_edges[-1 - across(side)].curve],
                                     position_text(a)));
  }
}

// Only where one of the two triangles has an angle up to `most_angle`.
// Of two diagonals of a convex quadrangle, the Delaunay one has the greater least angle; angles only grow, so that this
// comes to an end.
void Builder::flip_sides(double most_angle) {
  suspects_.clear();
  for (int side = 0; side < num_sides(); ++side) suspects_.push_back(side);
  for (std::size_t i = 0; i < suspects_.size(); ++i)
    if (across(suspects_[i]) >= 0) flip_if_better(suspects_[i], most_angle);
  suspects_.clear();
}

void Builder::set(int t, const std::array<int, 3>& vertices, const std::array<Vec2, 3>& uv,
                  const std::array<double, 3>& lengths, const std::array<int, 3>& across) {
  result_.triangles[t] = {vertices, uv, lengths, across};
  for (int k = 0; k < 3; ++k) {
    suspects_.push_back(3 * t + k);
    if (across[k] >= 0) of(across[k]).across[across[k] % 3] = 3 * t + k;
  }
}

Vec2 Builder::whole_periods(Vec2 difference) const {
  const NurbsSurface& s = face_.surface;
  const double u = s.knots_u.back() - s.knots_u.front(), v = s.knots_v.back() - s.knots_v.front();
  return {s.is_closed_u ? u * std::round(difference.x / u) : 0, s.is_closed_v ? v * std::round(difference.y / v) : 0};
}

// The side a b, with c on its left and d on its right, becomes d c.
void Builder::flip_if_better(int side, double most_angle) {
  const int other = across(side), bc = next(side), ca = last(side), ad = next(other), db = last(other);
  const int a = vertex(side), b = vertex(bc), c = vertex(ca), d = vertex(db);
  const double ab = length(side), l_bc = length(bc), l_ca = length(ca), l_ad = length(ad), l_db = length(db);
  if (is_delaunay(ab, l_bc, l_ca, l_ad, l_db)) return;
  const double at_a = angle_opposite(l_bc, ab, l_ca) + angle_opposite(l_db, ab, l_ad);
  const double at_b = angle_opposite(l_ca, ab, l_bc) + angle_opposite(l_ad, ab, l_db);
  if (c == d || std::max(at_a, at_b) >= pi) return;
  const double cd = std::sqrt(std::max(l_ca * l_ca + l_ad * l_ad - 2 * l_ca * l_ad * std::cos(at_a), 0.0));
  const double before = std::min(least_angle(ab, l_bc, l_ca), least_angle(ab, l_ad, l_db));
  if (before > most_angle) return;
  if (!(std::min(least_angle(l_ad, cd, l_ca), least_angle(l_db, l_bc, cd)) > before + least_gain)) return;
  // The parameters of a pole differ from triangle to triangle.
  const Vec2 uv_d = uv(db) + whole_periods(is_pole(bc) ? uv(side) - uv(ad) : uv(bc) - uv(other));
  const std::array uv_one{uv(side), uv_d, uv(ca)}, uv_two{uv_d, uv(bc), uv(ca)};
  const int one = side / 3, two = other / 3;
  const std::array across_one{across(ad), 3 * two + 2, across(ca)}, across_two{across(db), across(bc), 3 * one + 1};
  set(one, {a, d, c}, uv_one, {l_ad, cd, l_ca}, across_one);
  set(two, {d, b, c}, uv_two, {l_db, l_bc, cd}, across_two);
}

/// Of the normal along a side, radians; 0 where the parametrisation degenerates at an end.
double Builder::turn(int side) const {
  const Vec3 a = normal(side), b = normal(next(side));
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

bool Builder::is_to_be_split(int side) const {
  return length(side) > longest_side * size_ || (length(side) > 2 * shortest_half * size_ && turn(side) > most_turn);
}

/// One side of each triangle that has any to be split: the longest of them.
bool Builder::split_sides() {
  const int num_triangles = static_cast<int>(result_.triangles.size());
  bool has_split = false;
  for (int t = 0; t < num_triangles; ++t) {
    int longest = -1;
    for (int side = 3 * t; side < 3 * t + 3; ++side)
      if ((longest < 0 || length(side) > length(longest)) && is_to_be_split(side)) longest = side;
    if (longest >= 0) split(longest), has_split = true;
  }
  return has_split;
}

// Sides are halved where the normal turns: short ones with opposite normals at their ends lie across a fold, but for
// those beside a tip.
void Builder::require_no_fold() const {
  std::vector<Vec3> poles;
  for (int side = 0; side < num_sides(); ++side)
    if (is_pole(side)) poles.push_back(result_.vertices[vertex(side)]);
  for (int side = 0; side < num_sides(); ++side) {
    if (across(side) < 0 || length(side) > short_side * size_ || !(turn(side) > turned_over)) continue;
    const Vec3 at = result_.vertices[vertex(side)];
    if (std::ranges::any_of(poles, [&](Vec3 pole) { return distance(pole, at) < beside_pole * size_; })) continue;
    throw ComputeError(fmt::format(
        "the face has no chart: its triangles turn over near {}, where the surface is folded: cut the face there, or "
        "draw the surface without the fold, in the CAD system",
        position_text(at)));
  }
}

bool Builder::has_pole() const {
  return std::ranges::any_of(result_.normals, [](Vec3 normal) { return norm2(normal) == 0; });
}

/// The mean of the parameters of both ends that count, which are continuous along the side.
Vec2 Builder::middle_uv(int side) const {
  const auto corner = [&](int at) { return is_pole(at) ? corner_parameters(face_, uv(at)) : CornerParameters{uv(at)}; };
  const CornerParameters a = corner(side), b = corner(next(side));
  const auto mean = [](double of_a, bool counts_a, double of_b, bool counts_b) {
    return counts_a == counts_b ? (of_a + of_b) / 2 : counts_a ? of_a : of_b;
  };
  return {mean(a.uv.x, a.has_u, b.uv.x, b.has_u), mean(a.uv.y, a.has_v, b.uv.y, b.has_v)};
}

/// The point of the surface, or of the curve, in the middle of a side, with its parameters. Those in the middle say
/// nothing where a triangle has a pole inside.
std::pair<Vec3, Vec2> Builder::middle(int side) const {
  const Vec2 uv_middle = middle_uv(side);
  if (across(side) >= 0) {
    const Vec3 chord = (result_.vertices[vertex(side)] + result_.vertices[vertex(next(side))]) / 2;
    const Vec3 x = surface::point(face_.surface, uv_middle);
    if (distance(x, chord) <= length(side) / 2) return {x, uv_middle};
    const surface::SurfaceProjection foot = surface::project(face_.surface, chord, uv_middle);
    return {foot.position, foot.uv + whole_periods(uv_middle - foot.uv)};
  }
  const FineBoundaryEdge& edge = result_.boundary_edges[-1 - across(side)];
  const SpaceLength& length = lengths_[edge.curve];
  const Vec3 x = surface::point(length.curve(), length.parameter((length.at(edge.t0) + length.at(edge.t1)) / 2));
  const Vec2 foot = surface::project(face_.surface, x, uv_middle).uv;
  return {x, foot + whole_periods(uv_middle - foot)};
}

// The side a b, with c on its left and d on its right, is halved at m.
void Builder::split(int side) {
  const std::pair<Vec3, Vec2> at = middle(side);
  const Vec3 x = at.first;
  const Vec2 uv_m = at.second;
  const int m = static_cast<int>(result_.vertices.size()), other = across(side);
  result_.vertices.push_back(x);
  result_.normals.push_back(face_normal(face_, uv_m));
  const auto length_to = [&](int v) { return distance(x, result_.vertices[v]); };
  const auto halve = [&](int s, Vec2 uv_middle, int first, int second) {
    const IntrinsicTriangle old = of(s);
    const int i = s % 3, j = (i + 1) % 3, k = (i + 2) % 3, one = s / 3,
              two = static_cast<int>(result_.triangles.size());
    const double median = length_to(old.vertices[k]);
    result_.triangles.emplace_back();
    set(one, {old.vertices[i], m, old.vertices[k]}, {old.uv[i], uv_middle, old.uv[k]},
        {length_to(old.vertices[i]), median, old.lengths[k]}, {first, 3 * two + 2, old.across[k]});
    set(two, {m, old.vertices[j], old.vertices[k]}, {uv_middle, old.uv[j], old.uv[k]},
        {length_to(old.vertices[j]), old.lengths[j], median}, {second, old.across[j], 3 * one + 1});
  };
  if (other < 0) {
    FineBoundaryEdge& edge = result_.boundary_edges[-1 - other];
    const SpaceLength& length = lengths_[edge.curve];
    FineBoundaryEdge end = edge;
    edge.t1 = end.t0 = length.parameter((length.at(edge.t0) + length.at(edge.t1)) / 2);
    edge.vertices[1] = end.vertices[0] = m;
    halve(side, uv_m, other, -1 - static_cast<int>(result_.boundary_edges.size()));
    result_.boundary_edges.push_back(end);
    return;
  }
  const Vec2 uv_other = uv_m + whole_periods(middle_uv(other) - uv_m);
  const int second = num_sides();  // m b
  halve(side, uv_m, other, other);
  halve(other, uv_other, second, 3 * (side / 3));
}

}  // namespace

IntrinsicTriangles delaunay_triangles(const SpaceFace& face, const std::vector<SpaceLength>& lengths) {
  return Builder(face, lengths).made();
}

}  // namespace quadrille::chart
