#pragma once
// Charts with closed forms: the unit sphere in stereographic projection, X = (2x, 2y, 1 - r^2) / (1 + r^2), lambda =
// ln(2 / (1 + r^2)). Rational curves of the chart are rational curves in space with the same parameter, and the
// coordinates of the chart are the parameters of a biquadratic rational surface: all is exact.

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "model/charted_face.hpp"
#include "samples.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::samples {

inline Vec3 on_sphere(Vec2 x) { return Vec3{2 * x.x, 2 * x.y, 1 - norm2(x)} / (1 + norm2(x)); }
inline double sphere_log_scale(Vec2 x) { return std::log(2 / (1 + norm2(x))); }

/// The part of the sphere over a rectangle of the chart in which the weights 1 + x0 x1 + y0 y1, of its corners, are
/// positive.
inline NurbsSurface sphere_patch(Vec2 low, Vec2 high) {
  NurbsSurface s;
  s.degree_u = s.degree_v = 2;
  s.knots_u = {low.x, low.x, low.x, high.x, high.x, high.x};
  s.knots_v = {low.y, low.y, low.y, high.y, high.y, high.y};
  // Bernstein coefficients of t and t^2 on an interval.
  const auto linear = [](double a, double b, int i) { return a + (b - a) * i / 2; };
  const auto square = [](double a, double b, int i) { return i == 0 ? a * a : i == 1 ? a * b : b * b; };
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double r2 = square(low.x, high.x, i) + square(low.y, high.y, j), w = 1 + r2;
      s.poles.push_back(Vec3{2 * linear(low.x, high.x, i), 2 * linear(low.y, high.y, j), 1 - r2} / w);
      s.weights.push_back(w);
    }
  return s;
}

/// The image of a rational curve of one span on the sphere, of twice the degree.
inline SpaceCurve on_sphere(const Nurbs& curve) {
  const int p = curve.degree;
  const auto binomial = [](int n, int k) {
    return std::round(std::exp(std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1)));
  };
  using Homogeneous = std::array<double, 3>;  // of the plane: w x, w y, w
  std::vector<Homogeneous> h;
  for (int i = 0; i <= p; ++i)
    h.push_back({curve.weights[i] * curve.poles[i].x, curve.weights[i] * curve.poles[i].y, curve.weights[i]});
  SpaceCurve result;
  result.degree = 2 * p;
  result.knots.assign(2 * p + 1, curve.begin());
  result.knots.resize(4 * p + 2, curve.end());
  for (int k = 0; k <= 2 * p; ++k) {
    const auto product = [&](int a, int b) {
      double sum = 0;
      for (int i = std::max(0, k - p); i <= std::min(k, p); ++i)
        sum += binomial(p, i) * binomial(p, k - i) * h[i][a] * h[k - i][b];
      return sum / binomial(2 * p, k);
    };
    const double r2 = product(0, 0) + product(1, 1), w2 = product(2, 2);
    result.poles.push_back(Vec3{2 * product(0, 2), 2 * product(1, 2), w2 - r2} / (w2 + r2));
    result.weights.push_back(w2 + r2);
  }
  return result;
}

/// The chart with these straight triangles, `order` <= 8.
inline Chart chart_on_sphere(const CadFace& face, const std::vector<Vec2>& vertices,
                             const std::vector<std::array<int, 3>>& triangles, int order, Vec2 low, Vec2 high) {
  Chart chart;
  chart.order = order;
  chart.elem2vertices = triangles;
  for (const auto& [a, b, c] : triangles)
    for (const Vec2 xi : spectral::tri_nodes(order)) {
      const Vec2 x =
          vertices[a] + (1 + xi.x) / 2 * (vertices[b] - vertices[a]) + (1 + xi.y) / 2 * (vertices[c] - vertices[a]);
      chart.nodes.push_back(x);
      chart.uv.push_back(x);
      chart.space_nodes.push_back(on_sphere(x));
      chart.log_scale.push_back(sphere_log_scale(x));
    }
  chart.elem_surface.assign(triangles.size(), 0);
  chart.surfaces = {sphere_patch(low, high)};
  for (const Nurbs& curve : face.curves) chart.space_curves.push_back(on_sphere(curve));
  chart.closedness = 1e-9;
  return chart;
}

/// The face of samples::face(), scaled by 1/2: a patch of the sphere with four corners at right angles, cut into 2 n^2
/// triangles.
inline CadFace sphere_face(int n = 2, int order = 6) {
  CadFace f = face();
  f.name = "patch";
  f.diameter /= 2;
  f.fit_distance = 0;
  for (Nurbs& curve : f.curves)
    for (Vec2& pole : curve.poles) pole = pole / 2;
  for (Joint& joint : f.joints) joint.position = joint.position / 2;
  std::vector<Vec2> vertices;
  std::vector<std::array<int, 3>> triangles;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) vertices.push_back({0.5 * i / n, 0.5 * j / n});
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = c - 1;
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    }
  f.chart = std::make_shared<const Chart>(chart_on_sphere(f, vertices, triangles, order, {0, 0}, {0.5, 0.5}));
  return f;
}

/// What cad2chart would write of it.
inline ChartedFace charted_face() {
  return {{{"cad2chart", "0.1.0", {{"step", std::string(64, 'a')}}, R"({"face":"0"})"}}, sphere_face(1, 2)};
}

/// A quarter of the circle about the origin, counter-clockwise from k quarter turns on; parameter 0 to 1.
inline Nurbs quarter_circle(double radius, int k) {
  const auto at = [&](int i) { return radius * unit(pi / 2 * i); };
  const double w = std::sqrt(0.5);
  return {2, {0, 0, 0, 1, 1, 1}, {at(k), at(k) + at(k + 1), at(k + 1)}, {1, w, 1}};
}

/// Half of the cap of the sphere whose chart is the disc of radius 0.8: a half disc, in six sectors of three triangles.
inline CadFace cap_face(int order = 8) {
  constexpr double radius = 0.8, inner = 0.4;
  CadFace f;
  f.name = "cap";
  f.diameter = 2 * radius;
  f.curves = {line({-radius, 0}, {radius, 0}), quarter_circle(radius, 0), quarter_circle(radius, 1)};
  f.curve_names = {"axis", "rim", "rim"};
  f.curve_cad_edges = {0, 1, 1};
  f.loop_offsets = {0, 3};
  f.joints = {{{-radius, 0}, -pi / 2, 0, pi / 2, true},
              {{radius, 0}, 0, pi / 2, pi / 2, true},
              {f.curves[2].poles.front(), pi, pi, pi, false}};
  Chart chart;
  chart.order = order;
  // Vertices: 0 the centre, 1 + i on the inner polygon, 8 + i on the rim.
  const auto add = [&](std::array<int, 3> vertices, auto&& map) {
    chart.elem2vertices.push_back(vertices);
    for (const Vec2 xi : spectral::tri_nodes(order)) chart.nodes.push_back(map((1 + xi.x) / 2, (1 + xi.y) / 2));
  };
  for (int i = 0; i < 6; ++i) {
    const auto rim = [i](double s) { return radius * unit(pi / 6 * (i + s)); };
    const Vec2 a = inner * unit(pi / 6 * i), b = inner * unit(pi / 6 * (i + 1));
    const auto ring = [=](double s, double t) { return (1 - t) * ((1 - s) * a + s * b) + t * rim(s); };
    add({0, 1 + i, 2 + i}, [&](double p, double q) { return p * a + q * b; });
    add({1 + i, 8 + i, 9 + i}, [&](double p, double q) { return ring(q, p + q); });
    add({1 + i, 9 + i, 2 + i}, [&](double p, double q) { return ring(p + q, p); });
  }
  chart.uv = chart.nodes;
  for (const Vec2 x : chart.nodes) {
    chart.space_nodes.push_back(on_sphere(x));
    chart.log_scale.push_back(sphere_log_scale(x));
  }
  chart.elem_surface.assign(chart.elem2vertices.size(), 0);
  chart.surfaces = {sphere_patch({-radius, 0}, {radius, radius})};
  for (const Nurbs& curve : f.curves) chart.space_curves.push_back(on_sphere(curve));
  chart.closedness = 1e-9;
  f.chart = std::make_shared<const Chart>(std::move(chart));
  return f;
}

/// The same as a file.
inline ChartedFace charted_cap() { return {charted_face().provenance, cap_face()}; }

}  // namespace quadrille::samples
