#include <gtest/gtest.h>

#include "base/error.hpp"
#include "export/netcdf_request.hpp"
#include "export/writers.hpp"
#include "two_hexes.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

const NetcdfVariable& variable(const NetcdfRequest& file, const std::string& name) {
  for (const NetcdfVariable& v : file.variables)
    if (v.name == name) return v;
  throw Defect("no variable " + name);
}

std::string text_of(const NetcdfRequest& file, const std::string& name) {
  return std::get<std::string>(variable(file, name).values);
}

std::vector<std::int32_t> integers(const NetcdfRequest& file, const std::string& name) {
  return std::get<std::vector<std::int32_t>>(variable(file, name).values);
}

std::string type_of(const NetcdfRequest& file, const std::string& block) {
  return std::get<std::string>(variable(file, "connect" + block).attributes.at(0).values);
}

/// Names as rows of 33 characters.
std::string rows(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += name + std::string(33 - name.size(), '\0');
  return all;
}

TEST(Exodus, BlocksAreRegionsAndSideSetsBoundaries) {
  const QuadMesh mesh = two_quads();
  const Exported exported = exodus(mesh, plane_frame(mesh.face));
  const NetcdfRequest file = netcdf_request(exported.bytes);
  EXPECT_EQ(type_of(file, "1"), "QUAD9");
  EXPECT_EQ(text_of(file, "eb_names"), rows({"left", "right"}));
  EXPECT_EQ(text_of(file, "ss_names"), rows({"wall", "in___out", "curve_3"}));
  EXPECT_EQ(integers(file, "connect2").size(), 9u);
  ASSERT_EQ(exported.losses.size(), 1u);
  EXPECT_EQ(exported.losses[0], "1 name is written in at most 32 plain letters: \"in & out\" as in___out");
  EXPECT_EQ(type_of(netcdf_request(exodus(two_straight_quads(), plane_frame(mesh.face)).bytes), "1"), "QUAD4");
}

TEST(Exodus, HexahedraHaveBlocksAndSideSets) {
  const NetcdfRequest file = netcdf_request(exodus(two_hexes({.order = 2, .map = bent})).bytes);
  EXPECT_EQ(type_of(file, "2"), "HEX27");
  EXPECT_EQ(text_of(file, "eb_names"), rows({"fluid", "solid"}));
  EXPECT_EQ(text_of(file, "ss_names"), rows({"wall", "outlet", "bottom", "top", "between"}));
  // Sides 1, 3 and 4 of the first element, 1 and 3 of the second.
  EXPECT_EQ(integers(file, "elem_ss1"), (std::vector<std::int32_t>{1, 1, 1, 2, 2}));
  EXPECT_EQ(integers(file, "side_ss1"), (std::vector<std::int32_t>{1, 3, 4, 1, 3}));
  EXPECT_EQ(type_of(netcdf_request(exodus(two_hexes({})).bytes), "1"), "HEX8");
}

TEST(Exodus, SerendipityElementsHaveNoNodesInside) {
  const QuadMesh quads = two_quads();
  const NetcdfRequest plane = netcdf_request(exodus_serendipity(quads, plane_frame(quads.face)).bytes);
  EXPECT_EQ(type_of(plane, "1"), "QUAD8");
  EXPECT_EQ(integers(plane, "connect1"), (std::vector<std::int32_t>{1, 2, 3, 4, 7, 8, 9, 10}));
  const Exported exported = exodus_serendipity(two_hexes({.order = 2, .map = bent}));
  const NetcdfRequest file = netcdf_request(exported.bytes);
  EXPECT_EQ(type_of(file, "1"), "HEX20");
  EXPECT_EQ(std::get<std::vector<double>>(variable(file, "coordz").values).size(), 32u);  // 12 corners, 20 edges
  ASSERT_EQ(exported.losses.size(), 1u);
  EXPECT_TRUE(exported.losses[0].starts_with("nodes on faces and inside elements are not stored"));
}

}  // namespace
}  // namespace quadrille::exports
