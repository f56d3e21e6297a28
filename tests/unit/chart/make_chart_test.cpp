#include "chart/make_chart.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <functional>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "space_faces.hpp"

namespace quadrille {
namespace {

using Complex = std::complex<double>;

CadFace chart_of(const SpaceFace& face, double closedness = 1e-6) {
  Report report;
  chart::ChartOptions options;
  options.closedness = closedness;
  const auto t0 = clock();
  CadFace f = chart::make_chart(face, options, report);
  std::printf("cpu %.3f\n", double(clock() - t0) / CLOCKS_PER_SEC);
  for (const auto& [k, v] : report.entries()) {
    std::printf("%s ", k.c_str());
    std::visit(
        [](const auto& x) {
          if constexpr (std::is_arithmetic_v<std::decay_t<decltype(x)>>) std::printf("%g\n", double(x));
        },
        v);
  }
  for (size_t i = 0; i < f.joints.size(); ++i)
    std::printf("joint %zu: angle %.12f corner %d poles %zu\n", i, f.joints[i].interior_angle, f.joints[i].is_corner,
                f.curves[i].poles.size());
  for (size_t i = 0; i < f.joints.size(); ++i) { for (double tol : {1e-7, 1e-5, 1e-3}) std::printf("breaks %zu: %zu of %zu spans, seam %d\n", i, curve::smoothness_breaks(f.curves[i],tol).size(), f.curves[i].knots.size(), curve::has_smooth_seam(f.curves[i],tol)); }
  return f;
}

/// Greatest distance of the chart from exact(x), the motion that fits best removed.
double misfit(const Chart& chart, const std::function<Complex(Vec3)>& exact) {
  const std::size_t n = chart.nodes.size();
  std::vector<Complex> z, w;
  Complex zm, wm;
  for (std::size_t i = 0; i < n; ++i) {
    z.emplace_back(chart.nodes[i].x, chart.nodes[i].y), w.push_back(exact(chart.space_nodes[i]));
    zm += z[i] / double(n), wm += w[i] / double(n);
  }
  Complex turn;
  for (std::size_t i = 0; i < n; ++i) turn += (w[i] - wm) * std::conj(z[i] - zm);
  turn /= std::abs(turn);
  double most = 0;
  for (std::size_t i = 0; i < n; ++i) most = std::max(most, std::abs((z[i] - zm) * turn - (w[i] - wm)));
  return most;
}

TEST(MakeChart, CylinderIsUnrolled) {
  const SpaceFace face = tests::face_of(tests::swept(tests::line({2, 0, 0}, {2, 0, 3}), 0, 2), {{0, 1, 2, 3}}, 12, 5);
  const CadFace f = chart_of(face);
  const double e = misfit(*f.chart, [](Vec3 x) { return Complex(2 * std::atan2(x.y, x.x), x.z); });
  std::printf("misfit %g\n", e);
  EXPECT_LT(e, 1e-9);
}

TEST(MakeChart, ConeIsUnrolled) {
  const SpaceFace face = tests::face_of(tests::swept(tests::line({1, 0, 1}, {3, 0, 3}), 0, 3), {{0, 1, 2, 3}}, 16, 5);
  const CadFace f = chart_of(face);
  const double e = misfit(*f.chart, [](Vec3 x) { return std::polar(norm(x), -std::atan2(x.y, x.x) / std::sqrt(2)); });
  std::printf("misfit %g\n", e);
  EXPECT_LT(e, 1e-9);
}

TEST(MakeChart, CapIsStereographic) {
  const double v0 = std::acos(0.8);
  const SpaceFace face = tests::face_of(tests::swept(tests::profile_arc(0, 1, v0, pi / 2), 0, 2 * pi), {{0}}, 24, 8);
  const CadFace f = chart_of(face);
  // The image of the rim has radius 0.8.
  const double e = misfit(*f.chart, [](Vec3 x) { return Complex(x.x, x.y) / (1 + x.z) * 1.6; });
  std::printf("misfit %g\n", e);
  EXPECT_LT(e, 1e-9);
}

TEST(MakeChart, HalfCap) {
  const double v0 = std::acos(0.8);
  const SpaceFace face = tests::face_of(tests::swept(tests::profile_arc(0, 1, v0, pi / 2), 0, pi), {{0, 1, 3}}, 12, 8);
  const CadFace f = chart_of(face);
}
TEST(MakeChart, HalfSphere) {
  const SpaceFace face = tests::face_of(tests::swept(tests::profile_arc(0, 1, 0, pi / 2), 0, 2 * pi), {{0}}, 24, 12);
  const CadFace f = chart_of(face);
  const double e = misfit(*f.chart, [](Vec3 x) { return Complex(x.x, x.y) / (1 + x.z); });
  std::printf("misfit %g\n", e);
}
TEST(MakeChart, Torus) {
  const SpaceFace face = tests::face_of(tests::swept(tests::profile_arc(3, 1, -1, 1), 0, 1), {{0, 1, 2, 3}}, 12, 8);
  const CadFace f = chart_of(face);
}
TEST(MakeChart, Tube) {
  const SpaceFace face = tests::face_of(tests::swept(tests::line({1, 0, 0}, {1, 0, 1}), 0, 2 * pi), {{0}, {2}}, 36, 5);
  const CadFace f = chart_of(face);
  const double e = misfit(*f.chart, [](Vec3 x) { return std::polar(std::exp(-x.z), std::atan2(x.y, x.x)); });
  std::printf("misfit %g\n", e);
}
TEST(MakeChart, Zone) {
  const SpaceFace face =
      tests::face_of(tests::swept(tests::profile_arc(0, 1, std::acos(0.8), 1.2), 0, 2 * pi), {{0}, {2}}, 36, 5);
  const CadFace f = chart_of(face);
  const double e = misfit(*f.chart, [](Vec3 x) { return Complex(x.x, x.y) / (1 + x.z) * 1.6; });
  std::printf("misfit %g\n", e);
}
TEST(MakeChart, Hole) {
  const SpaceFace face = tests::cap_with_hole(1, 0.4, 0.3, 36, 8);
  const CadFace f = chart_of(face);
}
TEST(MakeChart, ExactSphere) {
  const SpaceFace face = tests::face_of(tests::swept(tests::profile_arc(0, 1, 0, pi / 2), 0, 2*pi), {{0}}, 24, 12);
  const CadFace f = chart_of(face, 1e-9);
  const double e = misfit(*f.chart, [](Vec3 x) { return Complex(x.x, x.y) / (1 + x.z); });
  std::printf("misfit %g\n", e);
}
TEST(MakeChart, Exact) {
  const SpaceFace face = tests::face_of(tests::swept(tests::line({2, 0, 0}, {2, 0, 3}), 0, 2), {{0, 1, 2, 3}}, 12, 5);
  const CadFace f = chart_of(face, 1e-9);
  const double e = misfit(*f.chart, [](Vec3 x) { return Complex(2 * std::atan2(x.y, x.x), x.z); });
  std::printf("misfit %g\n", e);
}

}  // namespace
}  // namespace quadrille
