#include "triangulate/boundary_mesh.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "faces.hpp"
#include "triangulate/outline.hpp"

namespace quadrille::triangulate {
namespace {

using namespace testing_faces;

struct Meshed {
  explicit Meshed(CadFace f, double size)
      : face(std::move(f)),
        outline(face, 1e-13),
        fit(outline, 8),
        limits{size, radians(40.0), 1e-12 * face.diameter},
        boundary(fit, {}, limits, draft) {}
  CadFace face;
  Outline outline;
  EdgeFit fit;
  EdgeLimits limits;
  Draft draft;
  BoundaryMesh boundary;
};

void expect_closed_loops(const Meshed& m) {
  std::vector<int> starts(m.draft.vertices.size(), 0), ends = starts;
  for (const Segment& s : m.boundary.segments()) ++starts[s.from], ++ends[s.to];
  EXPECT_EQ(starts, ends);
  EXPECT_EQ(*std::max_element(starts.begin(), starts.end()), 1);
}

TEST(BoundaryMesh, ACircleIsDividedEvenlyByItsTurn) {
  const Meshed m(make_face({circle({0, 0}, 1)}), 10);
  ASSERT_EQ(m.boundary.segments().size(), 9u);
  for (const Segment& s : m.boundary.segments()) EXPECT_NEAR(s.length(), 2 * pi / 9, 1e-12);
  expect_closed_loops(m);
}

TEST(BoundaryMesh, ASideIsDividedEvenlyByTheSize) {
  const Meshed m(square(), 0.4);
  ASSERT_EQ(m.boundary.segments().size(), 12u);
  for (const Segment& s : m.boundary.segments()) EXPECT_NEAR(s.length(), 1.0 / 3, 1e-15);
  expect_closed_loops(m);
}

TEST(BoundaryMesh, AnEdgeThatMissesTheCurveIsSplitAtAKnot) {
  // Its fifth derivative jumps at 0.3, where it is C4.
  const Nurbs bow{5,
                  {0, 0, 0, 0, 0, 0, 0.3, 1, 1, 1, 1, 1, 1},
                  {{1, 0}, {1, 0.1}, {0.9, 0.2}, {0.6, 0.35}, {0.35, 0.2}, {0.1, 0.15}, {0, 0}},
                  std::vector<double>(7, 1.0)};
  const Meshed m(make_face({{curve::segment({0, 0}, {1, 0}), bow}}), 10);
  const auto& segments = m.boundary.segments();
  EXPECT_TRUE(
      std::any_of(segments.begin(), segments.end(), [](const Segment& s) { return s.curve == 1 && s.t1 == 0.3; }));
  expect_closed_loops(m);
}

TEST(BoundaryMesh, SplittingHalvesByArcLengthOnTheCurve) {
  Meshed m(make_face({circle({0, 0}, 2)}), 10);
  const Segment whole = m.boundary.segments()[3];
  const int middle = m.boundary.split(3);
  const Segment& first = m.boundary.segments()[3];
  const Segment& second = m.boundary.segments().back();
  EXPECT_EQ(first.to, middle);
  EXPECT_EQ(second.from, middle);
  EXPECT_EQ(second.to, whole.to);
  EXPECT_NEAR(first.length(), second.length(), 1e-13);
  EXPECT_NEAR(norm(m.draft.vertices[middle]), 2, 1e-15);
  expect_closed_loops(m);
}

/// A spline through points of a parabola that are moved off it by turns, above a straight side.
CadFace rippled_bow(double ripple) {
  std::vector<double> parameters;
  std::vector<Vec2> points;
  for (int i = 0; i <= 12; ++i) {
    const double x = 1 - i / 12.0;
    parameters.push_back(i);
    points.push_back({x, 2 * x * (1 - x) + (i % 3 == 1 ? ripple : 0)});
  }
  return make_face({{curve::segment({0, 0}, {1, 0}),
                     curve::cubic_spline(parameters, points, {-1.0 / 12, 1.0 / 6}, {-1.0 / 12, -1.0 / 6})}});
}

/// The greatest ratio of the length of a segment to what is allowed at the junctions at its ends.
double greatest_ratio_at_knots(const Meshed& m) {
  double greatest = 0;
  for (const Segment& s : m.boundary.segments()) {
    for (const Junction& j : m.outline.junctions())
      if (j.position == m.draft.vertices[s.from] || j.position == m.draft.vertices[s.to])
        greatest = std::max(greatest, s.length() / greatest_edge_length(j));
  }
  return greatest;
}

TEST(BoundaryMesh, SegmentsAtKnotsAreShortWhereTheSlopeOfTheCurvatureJumps) {
  const Meshed rippled(rippled_bow(4e-3), 10), smooth(rippled_bow(0), 10);
  EXPECT_LE(greatest_ratio_at_knots(rippled), 1 + 1e-8);
  EXPECT_GT(greatest_ratio_at_knots(rippled), 0.5);
  EXPECT_EQ(greatest_ratio_at_knots(smooth), 0);
  expect_closed_loops(rippled);
}

TEST(BoundaryMesh, SegmentsAtKnotsHaveTheSameLengthsOnTheMirroredFace) {
  const auto lengths = [](const Meshed& m) {
    std::vector<double> all;
    for (const Segment& s : m.boundary.segments()) all.push_back(s.length());
    std::sort(all.begin(), all.end());
    return all;
  };
  const CadFace face = rippled_bow(4e-3);
  const auto here = lengths(Meshed(face, 10)), there = lengths(Meshed(moved(face, 1, 1, {3, 4}, true), 10));
  ASSERT_EQ(here.size(), there.size());
  for (std::size_t i = 0; i < here.size(); ++i) EXPECT_NEAR(here[i], there[i], 1e-9);
}

TEST(BoundaryMesh, GapsBoundTheLengthsOnBothSides) {
  Meshed m(make_face({circle({0, 0}, 1), hole({0.399, 0}, 0.6)}), 10);
  m.boundary.resolve_gaps(2.5);
  expect_closed_loops(m);
  const auto& segments = m.boundary.segments();
  double shortest = 10;
  for (const Segment& a : segments) {
    shortest = std::min(shortest, a.length());
    for (const Segment& b : segments) {
      if (a.curve == b.curve) continue;
      EXPECT_LE(a.length(), 2.5 * segment_distance(a, b) * (1 + 1e-5));
    }
  }
  EXPECT_LT(shortest, 2.5e-3);
  EXPECT_GT(shortest, 0.5e-3);
}

TEST(BoundaryMesh, TouchingCurvesAreNamedWithTheirPlace) {
  Meshed m(make_face({circle({0, 0}, 1), hole({0.5, 0}, 0.5)}), 10);
  try {
    m.boundary.resolve_gaps(2.5);
    FAIL() << "no error";
  } catch (const ComputeError& error) {
    EXPECT_NE(std::string(error.what()).find("touches or crosses itself"), std::string::npos) << error.what();
  }
}

TEST(BoundaryMesh, GradingLimitsTheGrowthAlongTheBoundary) {
  Meshed m(make_face({polygon({{0, 0}, {1, 0}, {1, 0.01}, {0.99, 1}, {0, 1}})}), 10);
  m.boundary.grade(0.5);
  const auto& segments = m.boundary.segments();
  for (const Segment& a : segments)
    for (const Segment& b : segments)
      EXPECT_LE(a.length(), 2.001 * (b.length() + 0.5 * distance(a.samples[2], b.centre)));
}

}  // namespace
}  // namespace quadrille::triangulate
