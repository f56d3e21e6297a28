#include <gtest/gtest.h>

#include "../samples.hpp"
#include "base/error.hpp"
#include "round_trip.hpp"

namespace quadrille::io {

namespace {

using CriticalPointsIo = RoundTrip;

TEST_F(CriticalPointsIo, CriticalPointsSurviveTheRoundTrip) {
  expect_same_bytes(samples::critical_points());
  EXPECT_EQ(read_stage<CriticalPoints>(read_input(path("second"))).critical_points[1].error, 2e-9);
  EXPECT_EQ(stage_format(read_input(path("first"))), "critical-points");
}

TEST_F(CriticalPointsIo, ResolvedPointsSurviveTheRoundTrip) {
  expect_same_bytes(samples::resolved_points());
  const CriticalPoints points = read_stage<CriticalPoints>(read_input(path("second")));
  EXPECT_EQ(points.form, NodeForm::phase);
  EXPECT_EQ(points.critical_points[1].source, NodeSource::cluster);
  EXPECT_EQ(points.corners[0].source, NodeSource::absorb);
  EXPECT_EQ(points.boundary_nodes[0].t, 0.5);
  EXPECT_EQ(points.changes[1].before[1].valence, 5);
  EXPECT_EQ(points.clusters[0].members.size(), 1u);
  EXPECT_EQ(points.zeros[2].index, -1);
  EXPECT_EQ(points.certificate.cells[2].verdict, CellVerdict::open);
  EXPECT_EQ(points.certificate.disc_radii, (std::vector<double>{0.0625}));
}

TEST_F(CriticalPointsIo, NodesAddedByHandNeedPlaceAndValenceOnly) {
  const std::string text =
      R"({"format": "critical-points", "version": [2, 0], "producer": "an editor", "provenance": [],
    "origin": [0, 0], "form": "phase", "critical_points": [{"position": [0.5, 0.5], "valence": 6}],
    "corners": [{"joint": 0, "position": [0, 0], "angle_degrees": 90, "valence": 1, "curves": [3, 0]}],
    "index_sum": {"expected": 4}})";
  const CriticalPoints points = read_stage<CriticalPoints>({{"file", ""}, text});
  EXPECT_EQ(points.critical_points[0].index, -2);
  EXPECT_EQ(points.index_sum, -1) << "4 - 6 and 2 - 1";
  EXPECT_TRUE(points.changes.empty());
}

TEST_F(CriticalPointsIo, UnknownKindsOfChangesAreReadButUnknownFormsAreRefused) {
  const auto read = [](const std::string& form, const std::string& location) {
    return read_stage<CriticalPoints>(
        {{"file", ""},
         R"({"format": "critical-points", "version": [2, 99], "producer": "a later version", "provenance": [],
    "origin": [0, 0], "form": ")" +
             form + R"(", "critical_points": [{"position": [0.5, 0.5], "valence": 3,
      "source": "dream"}], "corners": [], "index_sum": {"expected": 4},
    "changes": [{"kind": "dream", "reason": "later", "before": [], "after": [
      {"position": [0.5, 0.5], "valence": 3, "where": ")" +
             location + R"("}]}]})"});
  };
  const CriticalPoints points = read("phase", "inside");
  EXPECT_EQ(points.critical_points[0].source, NodeSource::other);
  EXPECT_EQ(points.changes[0].kind, ChangeKind::other);
  const auto refusal = [&](const std::string& form, const std::string& location) {
    try {
      read(form, location);
    } catch (const FormatError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refusal("magic", "inside").find("CRT-R12"), std::string::npos);
  EXPECT_NE(refusal("phase", "outside").find("must be inside, corner or boundary, not 'outside' (CRT-R16)"),
            std::string::npos);
}

}  // namespace

}  // namespace quadrille::io
