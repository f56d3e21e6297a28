#include "stage/fieldsolve.hpp"

#include <gtest/gtest.h>

#include "../support/texts.hpp"
#include "base/error.hpp"
#include "field/evaluate.hpp"
#include "two_squares.hpp"

namespace quadrille::stage {
namespace {

using namespace testing_stages;

struct Fieldsolve : testing::Test {
  TriMesh mesh = two_squares();
  CriticalPoints points = corners_of(mesh.face, "digest of x.field.h5");
  FieldsolveOptions options;
  quadrille::Run run;

  Field solved() { return fieldsolve({as_input(mesh, "x.tri.h5"), {}, {}, {}}, options, run); }
  Field of_orders(const OrderMap& orders) {
    FieldsolveInput input{as_input(mesh, "x.tri.h5"), {}, "order-map", {}};
    input.orders.emplace(as_input(orders, "orders.json"));
    return fieldsolve(input, options, run);
  }
  Field of_nodes() {
    FieldsolveInput input{as_input(mesh, "x.tri.h5"), {}, {}, {}};
    input.nodes.emplace(as_input(points, "x.crit.json"));
    return fieldsolve(input, options, run);
  }
  Field aligned(const GivenAlignment& directions) {
    FieldsolveInput input{as_input(mesh, "x.tri.h5"), {}, {}, {}};
    input.alignment.emplace(as_input(directions, "align.json"));
    return fieldsolve(input, options, run);
  }
  template <typename Value>
  Value reported(const std::string& key) {
    for (const auto& [name, value] : run.report().entries())
      if (name == key) return std::get<Value>(value);
    ADD_FAILURE() << key << " is not reported";
    return {};
  }
};

/// Along the axes v = e^(4 i angle) is 1.
TEST_F(Fieldsolve, TheFieldOfSquaresIsOneInEachRegion) {
  options.order = 3;
  const Field field = solved();
  EXPECT_EQ(field.mesh.face.num_regions(), 2);
  EXPECT_EQ(field.elem_order, std::vector<int>(mesh.num_elems(), 3));
  for (const double error : field.elem_error) EXPECT_LT(error, 1e-12);
  for (const double value : field.v) EXPECT_NEAR(value, 0, 1e-12);
  EXPECT_EQ(reported<long long>("solve.field_order"), 3);
  EXPECT_LT(reported<double>("solve.max_error"), 1e-12);
  const ProvenanceStep& step = field.provenance.back();
  EXPECT_EQ(step.tool, "fieldsolve");
  ASSERT_EQ(step.inputs.size(), 1u);
  EXPECT_EQ(step.inputs[0].sha256, "digest of x.tri.h5");
  expect_contains(step.options, R"("field-order":3)");
}

TEST_F(Fieldsolve, ErrorsAreEstimatedUnlessTheyAreMadeLater) {
  options.estimates_errors = false;
  EXPECT_TRUE(solved().elem_error.empty());
  for (const auto& [name, value] : run.report().entries()) EXPECT_NE(name, "solve.max_error");
}

TEST_F(Fieldsolve, AnOrderMapReplacesTheOrder) {
  OrderMap orders{std::vector<int>(mesh.num_elems(), 2)};
  orders.elem_order.back() = 5;
  const Field field = of_orders(orders);
  EXPECT_EQ(field.elem_order, orders.elem_order);
  EXPECT_EQ(reported<long long>("solve.field_order"), 5);
  EXPECT_EQ(field.provenance.back().inputs.at(1).format, "order-map");
}

TEST_F(Fieldsolve, NodesMakeAPhase) {
  const Field field = of_nodes();
  EXPECT_EQ(field.kind, FieldKind::phase);
  EXPECT_EQ(field.region_phases.size(), 2u);
  EXPECT_EQ(field.provenance.back().inputs.at(1).format, "critical-points");
}

TEST_F(Fieldsolve, NodesMustBelongToTheMeshAndItsFace) {
  points.corners[0].joint = 99;
  expect_contains(message_of<FormatError>([&] { of_nodes(); }), "x.crit.json");
  points = corners_of(mesh.face, "digest of x.field.h5");
  points.origin = {3, 0};
  EXPECT_EQ(message_of<FormatError>([&] { of_nodes(); }),
            "x.crit.json: its origin differs from that of the mesh: it belongs to another face");
  points = corners_of(mesh.face, "digest of x.field.h5");
  points.corners[0].valence = 2;
  points.index_sum = points.index_sum_expected = 8;
  EXPECT_THROW(of_nodes(), FormatError) << "the index sum is not 4 in the region";
}

/// Only the elements of nodes may be those of another mesh.
TEST_F(Fieldsolve, NodesMayBeOfAnotherMesh) {
  CriticalPoint node{{0.5, 0.5}, 1, 3, 9999, {}, {}, 0};
  points.critical_points = {node};
  points.corners[0].valence = 2;
  EXPECT_EQ(message_of<FormatError>([&] { of_nodes(); }), "");
}

TEST_F(Fieldsolve, DirectionsTurnTheCrossAndAreReported) {
  GivenAlignment directions;
  AlignmentFeature at_point;
  at_point.points = {{0.5, 0.5}};
  at_point.angle = pi / 4, at_point.width = 0.2;
  directions.features = {at_point};
  const Field field = aligned(directions);
  const double misalignment = reported<double>("align.rms_degrees");
  EXPECT_GT(misalignment, 0.1);
  EXPECT_LT(misalignment, 45) << "that of the field without the directions";
  EXPECT_EQ(field.provenance.back().inputs.at(1).format, "alignment");
  options.align_strength = 100;
  aligned(directions);
  EXPECT_LT(reported<double>("align.rms_degrees"), misalignment);
}

TEST_F(Fieldsolve, OptionsThatExcludeEachOtherAreRefused) {
  options.solve.method = FieldMethod::dg;
  options.order = 13;
  EXPECT_EQ(message_of<UsageError>([&] { solved(); }), "--field-order is at most 12 with --method dg");
  options.order = 8;
  options.nodes_file = "x.crit.json";
  EXPECT_EQ(message_of<UsageError>([&] { options.validate(); }), "--nodes needs --method cg and --corners lift");
  options.nodes_file.clear();
  options.align_file = "align.json";
  EXPECT_EQ(message_of<UsageError>([&] { options.validate(); }), "--align needs --method cg");
  options = {};
  options.order = 21;
  EXPECT_EQ(message_of<UsageError>([&] { solved(); }), "--field-order: 21 is outside its interval (1 to 20)");
}

TEST_F(Fieldsolve, BrokenMeshesAreRefused) {
  mesh.elem2vertices[0][0] = 999;
  expect_contains(message_of<FormatError>([&] { solved(); }), "x.tri.h5: TRI-R");
}

}  // namespace
}  // namespace quadrille::stage
