// Symmetric in, symmetric out: faces and sizes with a symmetry give meshes with it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "../hand_made.hpp"
#include "block/extract_blocks.hpp"
#include "refine/refine.hpp"
#include "sizing/curve_sizes.hpp"

namespace quadrille::sizing {
namespace {

constexpr double growth = 1.2;
const double slope = std::log(growth);

QuadMesh refined(const SeparatrixGraph& graph, const SizeField& sizes, SizeRule rule) {
  Report report;
  refine::RefineOptions options;
  options.order = 2;
  options.geometry_tol = 1e-5;
  options.size_field = sizes;
  options.size_rule = rule;
  return refine::refine(block::extract_blocks(graph, report), options, report);
}

/// Greatest distance of a node's image from the nearest node.
double misfit(const QuadMesh& mesh, const std::function<Vec2(Vec2)>& image) {
  std::vector<Vec2> sorted = mesh.nodes;
  const auto by_x = [](Vec2 a, Vec2 b) { return a.x < b.x; };
  std::sort(sorted.begin(), sorted.end(), by_x);
  double worst = 0;
  for (const Vec2 node : mesh.nodes) {
    const Vec2 y = image(node);
    double nearest = 1;
    for (auto k = std::lower_bound(sorted.begin(), sorted.end(), y - Vec2{1e-3, 0}, by_x);
         k != sorted.end() && k->x < y.x + 1e-3; ++k)
      nearest = std::min(nearest, distance(*k, y));
    worst = std::max(worst, nearest);
  }
  return worst;
}

Vec2 turned(Vec2 x, double angle) {
  return {std::cos(angle) * x.x - std::sin(angle) * x.y, std::sin(angle) * x.x + std::cos(angle) * x.y};
}

class SizeSymmetry : public testing::TestWithParam<SizeRule> {};

TEST_P(SizeSymmetry, MirroredAtADiagonal) {
  // The L is its own image under (x, y) -> (y, x), and so are a point on the diagonal and a pair of boxes.
  const SizeSources sources{
      {{{0.4, 0.4}, 0.02, 0}}, {{{1.5, 0.2}, {1.7, 0.3}, 0.03}, {{0.2, 1.5}, {0.3, 1.7}, 0.03}}, 0};
  for (const double greatest : {0.5, 0.3, 0.21, 0.1}) {
    const QuadMesh mesh = refined(hand_made::l_shape(), SizeField(greatest, sources, {}, growth), GetParam());
    EXPECT_LE(misfit(mesh, [](Vec2 x) { return Vec2{x.y, x.x}; }), 1e-9) << greatest;
  }
}

TEST_P(SizeSymmetry, TurnedAboutTheCentre) {
  const SeparatrixGraph graph = hand_made::cut_annulus(4);
  for (const double near : {0.2, 0.05, 0.013}) {
    const SizeField sizes(0.4, {}, segments_near(graph.face.curves[1], near, slope), growth);
    const QuadMesh mesh = refined(graph, sizes, GetParam());
    EXPECT_LE(misfit(mesh, [](Vec2 x) { return left_of(x); }), 1e-9) << near;
    EXPECT_LE(misfit(mesh, [](Vec2 x) { return Vec2{x.y, x.x}; }), 1e-9) << near;
  }
}

TEST_P(SizeSymmetry, TurnedWithBreaksInSidesAndAlignedChords) {
  // The S bend is its own image under a half turn; curvature asks for more elements in its bends.
  const SeparatrixGraph graph = hand_made::s_bend();
  const Vec2 ends = curve::point(graph.face.curves[5], graph.face.curves[5].end()) + graph.face.joints[0].position;
  for (const double turn : {20, 33, 70}) {
    std::vector<SizeSegment> segments;
    for (const Nurbs& curve : graph.face.curves) {
      const std::vector<SizeSegment> more = segments_by_curvature(curve, turn, 1e-3, 1, slope);
      segments.insert(segments.end(), more.begin(), more.end());
    }
    const QuadMesh mesh = refined(graph, SizeField(1, {}, segments, growth), GetParam());
    EXPECT_LE(misfit(mesh, [&](Vec2 x) { return ends - x; }), 1e-9) << turn;
  }
}

TEST_P(SizeSymmetry, TurnedFaceGivesTheTurnedMesh) {
  const SizeBall source{{0.4, 1.3}, 0.02, 0};
  const auto motion = [](Vec2 x) { return turned(x, 0.3) + Vec2{5, -7}; };
  SeparatrixGraph graph = hand_made::l_shape();
  const QuadMesh mesh = refined(graph, SizeField(0.3, {{source}, {}, 0}, {}, growth), GetParam());
  for (Nurbs& curve : graph.face.curves)
    for (Vec2& pole : curve.poles) pole = motion(pole);
  for (Nurbs& curve : graph.splines)
    for (Vec2& pole : curve.poles) pole = motion(pole);
  for (GraphNode& node : graph.nodes) node.position = motion(node.position);
  for (Joint& joint : graph.face.joints) joint.position = motion(joint.position);
  const SizeBall moved{in_space(motion({source.position.x, source.position.y})), source.size, 0};
  const QuadMesh other = refined(graph, SizeField(0.3, {{moved}, {}, 0}, {}, growth), GetParam());
  ASSERT_EQ(other.nodes.size(), mesh.nodes.size());
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) EXPECT_LE(distance(other.nodes[i], motion(mesh.nodes[i])), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Rules, SizeSymmetry, testing::Values(SizeRule::nearest, SizeRule::at_most));

}  // namespace
}  // namespace quadrille::sizing
