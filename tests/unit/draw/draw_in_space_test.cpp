#include "draw/draw_in_space.hpp"

#include <gtest/gtest.h>

#include "../chart_samples.hpp"
#include "base/error.hpp"

namespace quadrille::draw {
namespace {

/// Two quads on the sphere: the first lower in z than the second.
QuadMesh curved_mesh() {
  QuadMesh mesh = samples::quad_mesh();
  mesh.face = samples::sphere_face(1, 2);
  for (Vec2& x : mesh.nodes) x = Vec2{1 - x.x, 1 - x.y} / 2;
  for (const Vec2 x : mesh.nodes) mesh.space_nodes.push_back(samples::on_sphere(x));
  return mesh;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(DrawInSpace, AxesAreThoseOfTheViewer) {
  const SpaceView above = space_view(curved_mesh(), Vec3{0, 0, 2});
  EXPECT_EQ(above.right, (Vec3{1, 0, 0}));
  EXPECT_EQ(above.up, (Vec3{0, 1, 0}));
  EXPECT_EQ(above.at({3, 4, 5}), (Vec2{3, 4}));
  EXPECT_EQ(above.depth({3, 4, 5}), 5);
  const SpaceView front = space_view(curved_mesh(), Vec3{0, -1, 0});
  EXPECT_EQ(front.right, (Vec3{1, 0, 0}));
  EXPECT_EQ(front.up, (Vec3{0, 0, 1}));
}

TEST(DrawInSpace, IsometricIsOnTheSideOfTheNormal) {
  QuadMesh mesh = curved_mesh();
  EXPECT_NEAR(distance(space_view(mesh, {}).towards, Vec3{1, 1, 1} / std::sqrt(3.0)), 0, 1e-15);
  for (Vec3& x : mesh.space_nodes) x = {-x.x, x.y, -x.z};
  EXPECT_NEAR(distance(space_view(mesh, {}).towards, Vec3{-1, 1, -1} / std::sqrt(3.0)), 0, 1e-15);
}

TEST(DrawInSpace, FarElementsComeFirst) {
  const QuadMesh mesh = curved_mesh();
  const std::string above = draw_in_space(mesh, space_view(mesh, Vec3{0, 0, 1}), {}, quad_title(mesh)),
                    below = draw_in_space(mesh, space_view(mesh, Vec3{0, 0, -1}), {}, quad_title(mesh));
  EXPECT_LT(above.find("elem-0"), above.find("elem-1"));
  EXPECT_GT(below.find("elem-0"), below.find("elem-1"));
  EXPECT_EQ(count(above, "id=\"elem-"), 2u);
  EXPECT_EQ(count(above, "stroke-width:2.2"), 6u);
  EXPECT_EQ(count(above, "#44535f;stroke-width:1.4"), 2u) << "between the blocks, from both sides";
}

TEST(DrawInSpace, WithoutAViewItStandsBesideTheChart) {
  const std::string both = draw_stage(curved_mesh(), {});
  EXPECT_EQ(count(both, "id=\"a-elem-0\""), 1u);
  EXPECT_EQ(count(both, "id=\"b-elem-0\""), 1u);
  DrawOptions options;
  options.view = ViewDirection(Vec3{1, 0, 0});
  EXPECT_EQ(count(draw_stage(curved_mesh(), options), "id=\"elem-0\""), 1u);
  EXPECT_THROW(draw_stage(samples::quad_mesh(), options), UsageError);
}

TEST(DrawInSpace, AChartShowsItsScale) {
  const std::string svg = draw_stage(samples::charted_face(), {});
  EXPECT_EQ(count(svg, "id=\"elem-"), 2u);
  EXPECT_EQ(count(svg, "1.33 to 2 times those in the chart"), 1u);
}

}  // namespace
}  // namespace quadrille::draw
