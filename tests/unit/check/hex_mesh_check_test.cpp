#include <gtest/gtest.h>

#include <limits>

#include "../samples.hpp"
#include "rules_of.hpp"

namespace quadrille::check {
namespace {

template <typename Damage>
Rules broken(const Damage& damage) {
  return broken_rules(samples::hex_mesh(), damage);
}

TEST(HexMeshCheck, TheSampleIsValid) {
  EXPECT_EQ(broken([](HexMesh&) {}), Rules{});
}

TEST(HexMeshCheck, HexR01ArraysAgree) {
  EXPECT_EQ(broken([](auto& m) { m.order = 2; }), Rules{"HEX-R01"});
  EXPECT_EQ(broken([](auto& m) { m.num_quads = 3; }), Rules{"HEX-R01"});
  EXPECT_EQ(broken([](auto& m) { m.num_quads = 0; }), Rules{"HEX-R01"});
  EXPECT_EQ(broken([](auto& m) { m.quad_block.pop_back(); }), Rules{"HEX-R01"});
  EXPECT_EQ(broken([](auto& m) { m.elem_scaled_jacobian.pop_back(); }), Rules{"HEX-R01"});
  EXPECT_EQ(broken([](auto& m) { m.face_groups[0].faces.pop_back(); }), Rules{"HEX-R01"});
}
TEST(HexMeshCheck, HexR02IndicesExist) {
  EXPECT_EQ(broken([](auto& m) { m.elem_nodes[3] = 12; }), Rules{"HEX-R02"});
  EXPECT_EQ(broken([](auto& m) { m.quad_block[1] = 2; }), Rules{"HEX-R02"});
  EXPECT_EQ(broken([](auto& m) { m.block_region[1] = 1; }), Rules{"HEX-R02"});
  EXPECT_EQ(broken([](auto& m) { m.face_groups[1].faces[0] = 6; }), Rules{"HEX-R02"});
  EXPECT_EQ(broken([](auto& m) { m.face_groups[4].periodic_with = 6; }), Rules{"HEX-R02"});
  EXPECT_EQ(broken([](auto& m) { m.face_groups[4].periodic_with = 1; }), Rules{"HEX-R02"});
}
TEST(HexMeshCheck, HexR03NumbersAreFinite) {
  EXPECT_EQ(broken([](auto& m) { m.nodes[3].z = std::numeric_limits<double>::quiet_NaN(); }), Rules{"HEX-R03"});
  EXPECT_EQ(broken([](auto& m) { m.diameter = 0; }), Rules{"HEX-R03"});
}
TEST(HexMeshCheck, HexR04StoredBoundsArePositive) {
  EXPECT_EQ(broken([](auto& m) { m.elem_scaled_jacobian[1] = 1.5; }), Rules{"HEX-R04"});
}
TEST(HexMeshCheck, HexR05RootTellsValidity) {
  EXPECT_EQ(broken([](auto& m) { m.least_jacobian_bound = 0.01; }), Rules{"HEX-R05"});
  EXPECT_EQ(broken([](auto& m) { m.is_valid = false; }), Rules{"HEX-R05"});
}
TEST(HexMeshCheck, HexR06NamesAreUnique) {
  EXPECT_EQ(broken([](auto& m) { m.face_groups[1].name = "wall"; }), Rules{"HEX-R06"});
  EXPECT_EQ(broken([](auto& m) { m.face_groups[1].name = ""; }), Rules{"HEX-R06"});
}
TEST(HexMeshCheck, HexR07MeshIsConforming) {
  EXPECT_EQ(broken([](auto& m) { m.nodes.push_back({}); }), Rules{"HEX-R07"});
  EXPECT_EQ(broken([](auto& m) { m.face_groups.erase(m.face_groups.begin()), m.face_groups[3].periodic_with = 4; }),
            Rules{"HEX-R07"});
  EXPECT_TRUE(broken([](auto& m) {  // the second element gets a node of its own on the common face
                m.nodes.push_back(m.nodes[1]);
                m.elem_nodes[8] = 12;
              })
                  .contains("HEX-R07"));
}
TEST(HexMeshCheck, HexR08InterfacesAreShared) {
  const auto with_interface = [](HexMesh& m) { m.face_groups.push_back({"between", {0, 1}, {1, 3}, true}); };
  EXPECT_EQ(broken(with_interface), Rules{});
  EXPECT_EQ(broken([&](auto& m) {
              with_interface(m);
              m.face_groups.back().elems = {0}, m.face_groups.back().faces = {1};
            }),
            Rules{"HEX-R08"});
}
TEST(HexMeshCheck, HexR09JacobiansArePositive) {
  EXPECT_EQ(broken([](auto& m) { m.nodes[10].x = -0.1, m.face_groups[4].periodic_with = -1; }), Rules{"HEX-R09"});
}
TEST(HexMeshCheck, HexR10GroupsArePeriodic) {
  EXPECT_EQ(broken([](auto& m) { m.face_groups[4].motion.shift.z = 0.25; }), Rules{"HEX-R10"});
}

TEST(HexMeshCheck, AMeshThatIsNotValidSaysSo) {
  HexMesh mesh = samples::hex_mesh();
  EXPECT_EQ(validity_warning(mesh), "");
  mesh.is_valid = false;
  mesh.elem_jacobian_bound[1] = mesh.least_jacobian_bound = -1;
  EXPECT_EQ(validity_warning(mesh),
            "the mesh is not valid: 1 of 2 elements are not proved, the worst is element 1 at (0.5, 0, 0)");
}

}  // namespace
}  // namespace quadrille::check
