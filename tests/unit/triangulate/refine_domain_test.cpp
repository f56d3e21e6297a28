#include "triangulate/refine_domain.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "faces.hpp"

namespace quadrille::triangulate {
namespace {

using namespace testing_faces;

struct Refined {
  Refined(CadFace f, double size)
      : face(std::move(f)),
        outline(face, 1e-13),
        fit(outline, 8),
        boundary(fit, {}, {size, radians(40.0), 1e-12 * face.diameter}, draft) {
    boundary.resolve_gaps(2.5);
  }
  CadFace face;
  Outline outline;
  EdgeFit fit;
  Draft draft;
  BoundaryMesh boundary;
};

double angle_at(Vec2 a, Vec2 b, Vec2 c) { return std::atan2(cross(b - a, c - a), dot(b - a, c - a)); }

TEST(RefineDomain, AnglesOfARefinedSquareAreAboveTwentyDegrees) {
  Refined r(square(), 0.2);
  DomainRefiner refiner(r.boundary, r.draft, 0.2, 0.5);
  refiner.refine();
  double area = 0;
  for (const auto& [i, j, k] : refiner.triangles()) {
    const Vec2 a = r.draft.vertices[i], b = r.draft.vertices[j], c = r.draft.vertices[k];
    area += cross(b - a, c - a) / 2;
    for (const double angle : {angle_at(a, b, c), angle_at(b, c, a), angle_at(c, a, b)})
      EXPECT_GT(angle, radians(20.0));
    EXPECT_LT(std::max({distance(a, b), distance(b, c), distance(c, a)}), 0.4);
  }
  EXPECT_NEAR(area, 1, 1e-14);
}

TEST(RefineDomain, ElementsAreSmallWhereTheGapIsSmall) {
  Refined r(make_face({circle({0, 0}, 1), hole({0.395, 0}, 0.6)}), 0.5);
  DomainRefiner refiner(r.boundary, r.draft, 0.5, 0.5);
  refiner.refine();
  double least = 1;
  for (const auto& [i, j, k] : refiner.triangles())
    least =
        std::min(least, cross(r.draft.vertices[j] - r.draft.vertices[i], r.draft.vertices[k] - r.draft.vertices[i]));
  EXPECT_GT(least, 0);
  EXPECT_LT(std::sqrt(least), 0.02);
}

TEST(RefineDomain, SplitsTheSegmentAskedFor) {
  Refined r(square(), 0.5);
  DomainRefiner refiner(r.boundary, r.draft, 0.5, 0.5);
  const Segment first = r.boundary.segments().front();
  const std::size_t before = r.boundary.segments().size();
  EXPECT_TRUE(refiner.split_between(first.from, first.to));
  EXPECT_EQ(r.boundary.segments().size(), before + 1);
  EXPECT_FALSE(refiner.split_between(first.from, first.to));
}

TEST(RefineDomain, CrossingLoopsAreRefused) {
  Draft draft;
  const CadFace face =
      make_face({polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}), polygon({{3, 1}, {3, 2}, {5, 2}, {5, 1}})});
  const Outline outline(face, 1e-13);
  const EdgeFit fit(outline, 8);
  BoundaryMesh boundary(fit, {}, {10, 1, 1e-12}, draft);
  EXPECT_THROW(DomainRefiner(boundary, draft, 10, 0.5), ComputeError);
}

}  // namespace
}  // namespace quadrille::triangulate
