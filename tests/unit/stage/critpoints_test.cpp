#include "stage/critpoints.hpp"

#include <gtest/gtest.h>

#include "../region_samples.hpp"
#include "../support/polygon_field.hpp"
#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille::stage {
namespace {

const FileIdentity file{"x.field.h5", "digest"};

std::vector<Vec2> positions(const CriticalPoints& points) {
  std::vector<Vec2> found;
  for (const CriticalPoint& node : points.critical_points) found.push_back(node.position);
  return found;
}

TEST(Critpoints, TheNodesAreThoseOfTheParts) {
  const Field field = adapted_field(polygon_face(regular_polygon(5, 0.1)));
  quadrille::Run run(2);
  Report report;
  const CriticalPoints points = critpoints({field, file}, {}, run);
  EXPECT_EQ(positions(points), positions(choice::choose_nodes(field, {}, 1, report)));
  EXPECT_FALSE(points.critical_points.empty());
  ASSERT_EQ(points.provenance.size(), field.provenance.size() + 1);
  EXPECT_EQ(points.provenance.back().tool, "critpoints");
  EXPECT_EQ(points.provenance.back().inputs.at(0).format, "field");
  expect_contains(points.provenance.back().options, R"("feature-size":"auto")");
}

TEST(Critpoints, EachRegionHasItsNodesAndPrescribedCorners) {
  const Field field = samples::two_regions_field();
  CritpointsOptions options;
  quadrille::Run run;
  EXPECT_EQ(critpoints({field, file}, options, run).corners.size(), 8U);
  options.corner_valences = {"4:5=2"};
  const CriticalPoints points = critpoints({field, file}, options, run);
  ASSERT_EQ(points.critical_points.size(), 1U);
  EXPECT_GT(points.critical_points[0].position.x, 1) << "in the second region";
}

TEST(Critpoints, FieldsOfThePhaseFormAreRefused) {
  const Field field = samples::phase_field();
  quadrille::Run run;
  expect_contains(message_of<FormatError>([&] { critpoints({field, file}, {}, run); }), "x.field.h5: ");
}

TEST(Critpoints, WrongOptionsAreRefused) {
  const Field field = samples::field();
  CritpointsOptions options;
  quadrille::Run run;
  options.choose.max_valence = 4;
  EXPECT_EQ(message_of<UsageError>([&] {
              critpoints({field, file}, options, run);
            }),
            "--max-valence: 4 is outside its interval (5 to 12)");
  options = {};
  options.feature_size = "small";
  EXPECT_THROW(options.validate(), UsageError);
  options = {};
  options.clearances = {"wall"};
  EXPECT_THROW(options.validate(), UsageError);
}

TEST(Critpoints, TheFaceAloneTellsWhichOptionsDoNotFit) {
  const CadFace face = samples::face();
  CritpointsOptions options;
  EXPECT_NO_THROW(require_critpoints_of(face, options));
  options.choose.topology = topology::GridKind::o;
  EXPECT_THROW(require_critpoints_of(face, options), UsageError) << "no hole";
  options = {};
  options.clearances = {"hole=0.1"};
  EXPECT_THROW(require_critpoints_of(face, options), UsageError) << "no such boundary";
  options = {};
  options.corner_valences = {"0:2=1"};
  EXPECT_THROW(require_critpoints_of(face, options), UsageError) << "no such corner";
}

}  // namespace
}  // namespace quadrille::stage
