#pragma once
// Faces that are the whole domain of a surface of revolution, with fine triangles of a grid in its parameters.

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "../curved_surfaces.hpp"
#include "model/space_face.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::tests {

/// The curve in which the surface ends: side 0: v least, 1: u greatest, 2: v greatest, 3: u least; with the domain on
/// its left in the plane of u and v.
inline SpaceCurve side_curve(const NurbsSurface& s, int side) {
  const bool along_u = side % 2 == 0;
  SpaceCurve curve{along_u ? s.degree_u : s.degree_v, along_u ? s.knots_u : s.knots_v, {}, {}};
  const int nu = s.num_poles_u(), nv = s.num_poles_v();
  for (int k = 0; k < (along_u ? nu : nv); ++k) {
    const int i = along_u ? k : (side == 1 ? nu - 1 : 0), j = along_u ? (side == 2 ? nv - 1 : 0) : k;
    curve.poles.push_back(s.poles[i * nv + j]);
    curve.weights.push_back(s.weights[i * nv + j]);
  }
  return side >= 2 ? surface::reversed(curve) : curve;
}

/// The whole surface as a face: `loops` are lists of sides; sides in none are degenerate (poles) or seams. `nu` and
/// `nv` steps of the grid.
inline SpaceFace face_of(const NurbsSurface& s, const std::vector<std::vector<int>>& loops, int nu, int nv) {
  SpaceFace f;
  f.surface = s;
  f.face.loop_offsets = {0};
  std::array<int, 4> side2curve{-1, -1, -1, -1};
  for (const auto& loop : loops) {
    for (const int side : loop) {
      side2curve[side] = static_cast<int>(f.curves.size());
      f.curves.push_back(side_curve(s, side));
      f.face.curve_names.push_back("curve" + std::to_string(side));
      f.face.unnamed_curves.push_back(side2curve[side]);
      f.face.curve_cad_edges.push_back(side);
    }
    f.face.loop_offsets.push_back(static_cast<int>(f.curves.size()));
  }
  const double u0 = s.knots_u.front(), u1 = s.knots_u.back(), v0 = s.knots_v.front(), v1 = s.knots_v.back();
  const auto uv = [&](int i, int j) { return Vec2{u0 + (u1 - u0) * i / nu, v0 + (v1 - v0) * j / nv}; };
  const bool pole0 = side2curve[0] < 0, pole1 = side2curve[2] < 0;
  std::map<std::pair<int, int>, int> numbers;
  const auto vertex = [&](int i, int j) {
    if ((j == 0 && pole0) || (j == nv && pole1)) i = 0;
    if (s.is_closed_u && i == nu) i = 0;
    const auto [found, is_new] = numbers.try_emplace({i, j}, static_cast<int>(f.vertices.size()));
    if (is_new) f.vertices.push_back(surface::point(s, uv(i, j)));
    return found->second;
  };
  const auto add = [&](std::array<std::pair<int, int>, 3> corners) {
    std::array<int, 3> v{};
    std::array<Vec2, 3> at;
    for (int k = 0; k < 3; ++k)
      v[k] = vertex(corners[k].first, corners[k].second), at[k] = uv(corners[k].first, corners[k].second);
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) return;
    f.triangles.push_back(v), f.triangle_uv.push_back(at);
  };
  for (int i = 0; i < nu; ++i)
    for (int j = 0; j < nv; ++j) {
      add({std::pair(i, j), std::pair(i + 1, j), std::pair(i + 1, j + 1)});
      add({std::pair(i, j), std::pair(i + 1, j + 1), std::pair(i, j + 1)});
    }
  for (int side = 0; side < 4; ++side) {
    if (side2curve[side] < 0) continue;
    const int n = side % 2 == 0 ? nu : nv;
    const double begin = side % 2 == 0 ? u0 : v0, range = side % 2 == 0 ? u1 - u0 : v1 - v0;
    for (int k = 0; k < n; ++k) {
      const auto at = [&](int m) {
        return side == 0   ? vertex(m, 0)
               : side == 1 ? vertex(nu, m)
               : side == 2 ? vertex(nu - m, nv)
                           : vertex(0, nv - m);
      };
      f.boundary_edges.push_back(
          {{at(k), at(k + 1)}, side2curve[side], begin + range * k / n, begin + range * (k + 1) / n});
    }
  }
  std::stable_sort(f.boundary_edges.begin(), f.boundary_edges.end(),
                   [](const auto& a, const auto& b) { return a.curve != b.curve ? a.curve < b.curve : a.t0 < b.t0; });
  return f;
}

/// A part of the cone x^2 + y^2 = z^2, z <= 1, from its apex, `angle` about z (radians), as a CAD kernel has it: the
/// apex has the same parameters in all triangles, and one triangle has its corners on one line.
inline SpaceFace cone_with_apex(double angle) {
  const NurbsSurface s = revolved(line({0, 0, 0}, {1, 0, 1}), 0, angle);
  SpaceFace f = face_of(s, {{1, 2, 3}}, 12, 5);
  const auto number = [&](int i, int j) {
    const Vec3 x = surface::point(s, {angle * i / 12, j / 5.0});
    return static_cast<int>(std::min_element(f.vertices.begin(), f.vertices.end(),
                                             [&](Vec3 a, Vec3 b) { return distance(a, x) < distance(b, x); }) -
                            f.vertices.begin());
  };
  const int apex = number(0, 0), a = number(5, 1), b = number(6, 1), c = number(6, 2);
  for (std::size_t t = 0; t < f.triangles.size(); ++t) {
    auto& corners = f.triangles[t];
    const auto has = [&](int v) { return std::count(corners.begin(), corners.end(), v) > 0; };
    for (int k = 0; k < 3 && has(a) && has(b); ++k) {  // the diagonal a b of a, b, c and the apex becomes apex c
      const bool is_inner = has(apex);
      if (corners[k] == (is_inner ? b : a)) {
        corners[k] = is_inner ? c : apex;
        f.triangle_uv[t][k] = is_inner ? Vec2{angle / 2, 0.4} : Vec2{};
        break;
      }
    }
    for (int k = 0; k < 3; ++k)
      if (corners[k] == apex) f.triangle_uv[t][k] = {0, 0};
  }
  return f;
}

/// A part of the surface z = x y / 2 with one smooth rim whose curvature jumps: quadratic pieces in x and y, from the
/// middle of one to its middle again. `n` triangles along each of the `pieces`.
inline SpaceFace rim_of_quadratic_pieces(int pieces, int n) {
  const auto corner = [&](int k) {
    const double angle = 2 * std::numbers::pi * k / pieces;
    return (k % 2 == 0 ? 1 : 0.8) * Vec2{std::cos(angle), std::sin(angle)};
  };
  SpaceFace f;
  f.surface = {1, 1, {0, 0, 1, 1}, {0, 0, 1, 1}, {{-2, -2, 2}, {-2, 2, -2}, {2, -2, -2}, {2, 2, 2}}, {1, 1, 1, 1}};
  SpaceCurve rim{4, {0, 0, 0, 0, 0}, {}, {}};
  for (int k = 0; k <= pieces; ++k) {
    // Between the middles of the sides of a polygon, a quadratic piece; the first and the last one are halves.
    Vec2 a = (corner(k) + corner(k + pieces - 1)) / 2, b = corner(k), c = (corner(k) + corner(k + 1)) / 2;
    const Vec2 ab = (a + b) / 2, bc = (b + c) / 2, middle = (ab + bc) / 2;
    if (k == 0) a = middle, b = bc;
    if (k == pieces) b = ab, c = middle;
    // Of degree 4, with the product of both coordinates; a pole at which two pieces meet is left out.
    const std::array<Vec2, 5> xy{a, (a + b) / 2, (a + 4 * b + c) / 6, (b + c) / 2, c};
    const std::array<double, 5> product{a.x * a.y, (a.x * b.y + b.x * a.y) / 2,
                                        (a.x * c.y + 4 * b.x * b.y + c.x * a.y) / 6, (b.x * c.y + c.x * b.y) / 2,
                                        c.x * c.y};
    for (int i = k == 0 ? 0 : 1; i < (k == pieces ? 5 : 4); ++i)
      rim.poles.push_back({xy[i].x, xy[i].y, product[i] / 2}), rim.weights.push_back(1);
    rim.knots.insert(rim.knots.end(), k == pieces ? 5 : 3, k == pieces ? pieces : k + 0.5);
  }
  f.curves = {rim};
  f.face.loop_offsets = {0, 1};
  f.face.curve_names = {"rim"}, f.face.curve_cad_edges = {0};
  const int around = pieces * n, rings = n;
  const auto add_vertex = [&](Vec3 on_rim, double part) {
    f.vertices.push_back({part * on_rim.x, part * on_rim.y, part * part * on_rim.z});
  };
  for (int j = 0; j < rings; ++j)
    for (int i = 0; i < around; ++i)
      add_vertex(surface::point(rim, static_cast<double>(i) / n), 1 - static_cast<double>(j) / rings);
  add_vertex({}, 0);
  const auto add = [&](int a, int b, int c) {
    f.triangles.push_back({a, b, c});
    std::array<Vec2, 3> uv;
    for (int k = 0; k < 3; ++k) {
      const Vec3 x = f.vertices[f.triangles.back()[k]];
      uv[k] = {(x.x + 2) / 4, (x.y + 2) / 4};
    }
    f.triangle_uv.push_back(uv);
  };
  for (int j = 0; j < rings; ++j)
    for (int i = 0; i < around; ++i) {
      const int a = j * around + i, b = j * around + (i + 1) % around;
      if (j + 1 == rings) {
        add(a, b, rings * around);
        continue;
      }
      add(a, b, b + around), add(a, b + around, a + around);
    }
  for (int i = 0; i < around; ++i)
    f.boundary_edges.push_back({{i, (i + 1) % around}, 0, static_cast<double>(i) / n, static_cast<double>(i + 1) / n});
  return f;
}

/// A circle on the unit sphere about its point at `polar` from z, in the plane y = 0, at the polar angle `radius` from
/// it; counter-clockwise seen from outside.
inline SpaceCurve circle_on_sphere(double polar, double radius) {
  SpaceCurve circle = profile_arc(0, std::sin(radius), 0, 2 * std::numbers::pi);
  for (Vec3& p : circle.poles) {
    const double x = p.x, y = p.z, z = std::cos(radius);
    p = {x * std::cos(polar) + z * std::sin(polar), y, z * std::cos(polar) - x * std::sin(polar)};
  }
  return circle;
}

/// The cap of the unit sphere around z up to polar angle `outer`, with a round hole about `polar`. `n` vertices around.
inline SpaceFace cap_with_hole(double outer, double polar, double inner, int n, int rings) {
  SpaceFace f;
  f.surface = sphere(1);
  f.curves = {circle_on_sphere(0, outer), surface::reversed(circle_on_sphere(polar, inner))};
  f.face.loop_offsets = {0, 1, 2};
  f.face.curve_names = {"rim", "hole"}, f.face.curve_cad_edges = {0, 1};
  const double turn = 2 * std::numbers::pi;
  const auto plane = [](Vec3 x) { return Vec2{x.x, x.y} / (1 + x.z); };
  std::vector<Vec2> uv;
  for (int j = 0; j <= rings; ++j)
    for (int i = 0; i < n; ++i) {
      const Vec3 a = surface::point(f.curves[0], turn * i / n), b = surface::point(f.curves[1], turn * (n - i) / n);
      const double part = static_cast<double>(j) / rings;
      const Vec2 z = (1 - part) * plane(a) + part * plane(b);
      Vec3 x = Vec3{2 * z.x, 2 * z.y, 1 - norm2(z)} / (1 + norm2(z));
      if (j == 0) x = a;
      if (j == rings) x = b;
      f.vertices.push_back(x);
      const double u = std::atan2(x.y, x.x);
      uv.push_back(surface::project(f.surface, x, {u < 0 ? u + turn : u, std::asin(x.z)}).uv);
    }
  const auto add = [&](int a, int b, int c) {
    std::array<Vec2, 3> at{uv[a], uv[b], uv[c]};
    for (Vec2& p : at) p.x -= turn * std::round((p.x - at[0].x) / turn);
    f.triangles.push_back({a, b, c}), f.triangle_uv.push_back(at);
  };
  for (int j = 0; j < rings; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * n + i, b = j * n + (i + 1) % n;
      add(a, b, b + n), add(a, b + n, a + n);
    }
  for (int i = 0; i < n; ++i) f.boundary_edges.push_back({{i, (i + 1) % n}, 0, turn * i / n, turn * (i + 1) / n});
  for (int i = 0; i < n; ++i)
    f.boundary_edges.push_back({{rings * n + (n - i) % n, rings * n + n - i - 1}, 1, turn * i / n, turn * (i + 1) / n});
  return f;
}

}  // namespace quadrille::tests
