#include <gtest/gtest.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "../support/texts.hpp"
#include "base/error.hpp"
#include "occ/occ_blocks.hpp"
#include "occ/write_cad.hpp"
#include "surface_samples.hpp"

namespace quadrille::occ {
namespace {

double area(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties, 1e-8);
  return properties.Mass();
}

int count_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape found;
  TopExp::MapShapes(shape, kind, found);
  return found.Extent();
}

TEST(SurfaceBlocks, blocks_share_edges_on_the_exact_surface) {
  const TopoDS_Shape shape = occ_blocks(samples::blocks_on_sphere(0, false, false), 1).shape;
  EXPECT_TRUE(BRepCheck_Analyzer(shape).IsValid());
  EXPECT_EQ(count_of(shape, TopAbs_FACE), 2);
  EXPECT_EQ(count_of(shape, TopAbs_EDGE), 7);
  EXPECT_EQ(count_of(shape, TopAbs_VERTEX), 6);
  EXPECT_NEAR(area(shape), samples::area_on_sphere(0, 0.5, 0, 0.5), 1e-6);
}

TEST(SurfaceBlocks, lengths_have_the_unit_of_the_shape) {
  const TopoDS_Shape shape = occ_blocks(samples::blocks_on_sphere(0, false, false), 10).shape;
  EXPECT_TRUE(BRepCheck_Analyzer(shape).IsValid());
  EXPECT_NEAR(area(shape), 100 * samples::area_on_sphere(0, 0.5, 0, 0.5), 1e-4);
}

// The poles and the seam of the parameters are beside the blocks, across them, at a corner, and inside one.
TEST(SurfaceBlocks, seams_and_poles_are_no_obstacle) {
  for (const double a : {0.1, -0.1, 0.0, -0.25, -0.3})
    for (const bool is_one : {true, false}) {
      if (a == -0.25 && !is_one) continue;  // the line between the blocks leads through the pole
      const TopoDS_Shape shape = occ_blocks(samples::blocks_on_sphere(a, true, is_one), 1).shape;
      EXPECT_TRUE(BRepCheck_Analyzer(shape).IsValid()) << a << " " << is_one;
      EXPECT_NEAR(area(shape), samples::area_on_sphere(a, a + 0.5, a, a + 0.5), 1e-6) << a << " " << is_one;
    }
}

TEST(SurfaceBlocks, the_file_has_curves_in_the_parameters_and_names) {
  const std::string step = step_of_blocks(samples::blocks_on_sphere(0, false, false));
  expect_counts(step, {{"ADVANCED_FACE('block_0'", 1}, {"ADVANCED_FACE('block_1'", 1}, {"EDGE_CURVE('side 0'", 2}});
  EXPECT_GT(count(step, "PCURVE("), 6);
  EXPECT_EQ(step_of_blocks(samples::blocks_on_sphere(0, false, false)), step);
}

TEST(SurfaceBlocks, several_surfaces_are_refused) {
  BlockLayout layout = samples::blocks_on_sphere(0, false, false);
  Chart chart = *layout.face.chart;
  chart.surfaces.push_back(chart.surfaces.front());
  layout.face.chart = std::make_shared<const Chart>(chart);
  EXPECT_THROW(occ_blocks(layout, 1), ComputeError);
}

}  // namespace
}  // namespace quadrille::occ
