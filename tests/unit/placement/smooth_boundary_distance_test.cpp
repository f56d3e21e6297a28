#include "placement/smooth_boundary_distance.hpp"

#include <gtest/gtest.h>

#include "../triangulate/faces.hpp"
#include "base/angle.hpp"

namespace quadrille::placement {
namespace {

using namespace testing_faces;

struct LogDistance {
  double value = 0;
  Vec2 slope;
};

LogDistance log_distance(const CadFace& face, Vec2 x) {
  LogDistance d;
  d.value = SmoothBoundaryDistance(face).log_smooth(x, d.slope);
  return d;
}

/// What is left when the points of the wall are rounded.
double rounding(const CadFace& face, double wall_distance) { return 1e-12 + 1e-16 * face.diameter / wall_distance; }

/// pi / delta in the rectangle [0, a] x [0, b].
double rectangle_integral(double a, double b, Vec2 x) {
  const auto side = [](double h, double before, double after) {
    return (std::atan2(before, h) + std::atan2(after, h)) / h;
  };
  return side(x.y, x.x, a - x.x) + side(b - x.y, x.x, a - x.x) + side(x.x, x.y, b - x.y) + side(a - x.x, x.y, b - x.y);
}

TEST(SmoothBoundaryDistance, in_a_disc_is_the_power_of_the_point) {
  const Vec2 centre{3, -2};
  const double radius = 2;
  const CadFace face = make_face({circle(centre, radius)});
  for (const double r : {0.0, 0.3, 1.0, 1.9, 1.999, 2 - 1e-6})
    for (const double angle : {0.0, 0.7, 2.5}) {
      const Vec2 x = r * unit(angle);
      const LogDistance d = log_distance(face, centre + x);
      const double power = (radius - r) * (radius + r);
      const double tol = 1e-12 + 1e-15 / (radius - r);  // the point itself is rounded, far from the origin
      EXPECT_NEAR(d.value, std::log(power / (2 * radius)), tol);
      EXPECT_NEAR(distance(d.slope, -2 / power * x), 0, tol * (1 + norm(d.slope)));
    }
}

TEST(SmoothBoundaryDistance, in_a_rectangle_is_known) {
  const CadFace face = make_face({polygon({{0, 0}, {5, 0}, {5, 1}, {0, 1}})});
  for (const Vec2 x : {Vec2{2.5, 0.5}, {0.1, 0.2}, {1, 1e-3}, {1, 1e-6}, {1e-5, 1e-5}}) {
    const double expected = std::log(pi / rectangle_integral(5, 1, x));
    EXPECT_NEAR(log_distance(face, x).value, expected, rounding(face, std::min(x.x, x.y)));
  }
}

TEST(SmoothBoundaryDistance, near_a_long_wall_is_the_plain_distance) {
  const CadFace face = make_face({polygon({{-1e4, 0}, {1e4, 0}, {1e4, 1e4}, {-1e4, 1e4}})});
  const LogDistance d = log_distance(face, {0.3, 0.7});
  EXPECT_NEAR(d.value, std::log(0.7), 2e-4);
  EXPECT_NEAR(d.slope.x, 0, 2e-4);
  EXPECT_NEAR(d.slope.y, 1 / 0.7, 2e-4);
}

TEST(SmoothBoundaryDistance, sees_holes) {
  const CadFace face = annulus();
  for (const double r : {0.5001, 0.6, 0.99}) {
    const Vec2 x = r * unit(1.1);
    const double integral = 2 * pi / (1 - r * r) + 2 * pi * 0.5 / (r * r - 0.25);
    EXPECT_NEAR(log_distance(face, x).value, std::log(pi / integral), 1e-12);
  }
}

TEST(SmoothBoundaryDistance, depends_on_the_curve_and_not_on_its_parameter) {
  CadFace face = make_face({polygon({{0, 0}, {5, 0}, {5, 1}, {0, 1}})});
  // The lower side again, at rest at its beginning; the right side with its speed almost all at one end.
  face.curves[0] = {3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0}, {0, 0}, {0.5, 0}, {5, 0}}, {1, 1, 1, 1}};
  face.curves[1] = {2, {0, 0, 0, 1, 1, 1}, {{5, 0}, {5, 0.5}, {5, 1}}, {1, 0.01, 1}};
  for (const Vec2 x : {Vec2{2.5, 0.5}, {0.1, 0.2}, {1e-3, 1e-3}, {4.999, 0.999}, {4.9999, 0.5}})
    EXPECT_NEAR(log_distance(face, x).value, std::log(pi / rectangle_integral(5, 1, x)),
                rounding(face, SmoothBoundaryDistance(face).nearest(x).distance));
}

TEST(SmoothBoundaryDistance, its_gradient_is_that_of_its_value) {
  const CadFace face = stadium();
  const double h = 1e-6;
  for (const Vec2 x : {Vec2{0.2, 0.3}, {1.7, 0.2}, {-1.2, -0.95}}) {
    const auto at = [&](double dx, double dy) { return log_distance(face, x + Vec2{dx, dy}).value; };
    const Vec2 slope{(at(h, 0) - at(-h, 0)) / (2 * h), (at(0, h) - at(0, -h)) / (2 * h)};
    EXPECT_NEAR(distance(log_distance(face, x).slope, slope), 0, 1e-6);
  }
}

TEST(SmoothBoundaryDistance, knows_the_plain_distance_too) {
  const CadFace face = annulus();
  const SmoothBoundaryDistance walls(face);
  for (const double r : {0.5001, 0.6, 0.74, 0.8, 0.9999})
    EXPECT_NEAR(walls.nearest(r * unit(0.4)).distance, std::min(r - 0.5, 1 - r), 1e-13);
}

using namespace testing_faces;

TEST(MostInteriorPoint, of_symmetric_faces_is_the_centre) {
  const CadFace face = make_face({polygon({{0, 0}, {3, 0}, {3, 1}, {0, 1}})});
  EXPECT_LT(distance(most_interior_point(face, {{{0, 0}, 0, false}}), {1.5, 0.5}), 1e-9);
  EXPECT_LT(distance(most_interior_point(half_disc(), {{{0, 0}, 0, false}}),
                     most_interior_point(half_disc(), curve::symmetries(half_disc()))),
            1e-9);
}

TEST(MostInteriorPoint, stays_on_the_mirror_axis_and_moves_with_the_face) {
  const Vec2 on_axis = most_interior_point(l_shape(), curve::symmetries(l_shape()));
  EXPECT_NEAR(on_axis.x, on_axis.y, 1e-12);
  const CadFace face = make_face({polygon({{0, 0}, {3, 0}, {2, 1}, {0, 1.3}})});
  const CadFace image = moved(face, 5, 0.7, {3, 1}, true);
  const Vec2 x = most_interior_point(face, curve::symmetries(face));
  const Vec2 expected = 5 * curve::Isometry{{0, 0}, 0.7, true}.turned(x) + Vec2{3, 1};
  EXPECT_LT(distance(most_interior_point(image, curve::symmetries(image)), expected), 1e-9 * image.diameter);
}

TEST(MostInteriorPoint, of_a_thin_face_lies_in_its_middle_line) {
  const CadFace face = make_face({polygon({{0, 0}, {1, 0}, {1.002, 0.01}, {0, 0.01}})});
  EXPECT_NEAR(curve::FaceBoundary(face).signed_distance(most_interior_point(face, {{{0, 0}, 0, false}})), 0.005, 1e-4);
}

}  // namespace
}  // namespace quadrille::placement
