#include "layout/fine_tolerance.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "../hand_made.hpp"
#include "graph/family_order.hpp"

namespace quadrille::layout {
namespace {

/// A computation that succeeds from a tolerance on.
struct Computation {
  double sufficient;
  std::vector<double> tried = {};
  Report report = {};

  graph::CandidateLayout run(const LayoutOptions& options = {}) {
    return with_fine_tolerance(options, report, [this](const LayoutOptions& o) {
      tried.push_back(o.trace.tolerance);
      if (o.trace.tolerance > sufficient) throw graph::FamilyOrderError("they cross");
      return graph::candidate_layout(hand_made::cut_annulus(4));
    });
  }
};

TEST(FineTolerance, IsNotChangedWithoutNeed) {
  Computation c{1};
  c.run();
  EXPECT_EQ(c.tried.size(), 1u);
  EXPECT_TRUE(c.report.entries().empty());
}

TEST(FineTolerance, IsRefinedWhileLinesOfOneFamilyCrossAndReported) {
  Computation c{1.1e-12};
  EXPECT_EQ(c.run().subdivision.num_faces(), 4);
  ASSERT_EQ(c.tried.size(), 2u);
  EXPECT_NEAR(c.tried[1], 1e-12, 1e-20);
  ASSERT_EQ(c.report.entries().size(), 1u);
  EXPECT_EQ(c.report.entries().front().first, "layout.tolerance");
}

TEST(FineTolerance, IsNotRefinedBelowRoundOffNorForAFixedStep) {
  Computation c{0};
  EXPECT_THROW(c.run(), graph::FamilyOrderError);
  EXPECT_EQ(c.tried.size(), 2u);
  Computation fixed{0};
  LayoutOptions options;
  options.trace.integrator = trace::Integrator::adams_bashforth;
  EXPECT_THROW(fixed.run(options), graph::FamilyOrderError);
  EXPECT_EQ(fixed.tried.size(), 1u);
}

}  // namespace
}  // namespace quadrille::layout
