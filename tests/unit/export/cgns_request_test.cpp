#include "export/cgns_request.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "export/writers.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

TEST(CgnsRequest, ReadsBackWhatWasWritten) {
  const QuadMesh mesh = two_quads();
  const Frame frame = plane_frame(mesh.face);
  for (const std::string& bytes : {cgns_unstructured(mesh, frame).bytes, cgns_structured(mesh, frame).bytes}) {
    EXPECT_EQ(to_bytes(cgns_request(bytes)), bytes);
    EXPECT_THROW(cgns_request(bytes.substr(0, bytes.size() - 1)), Defect);
    EXPECT_THROW(cgns_request(bytes + "x"), Defect);
  }
}

TEST(CgnsRequest, EveryMemberIsWritten) {
  CgnsRequest request{true, 3, {{"wall", "BCWall"}}, {{}}};
  request.zones[0] = {"zone",
                      "family",
                      {2, 3},
                      {{0.5}, {-1}},
                      {{"section", "QUAD_4", 5, 7, {1, 2}}},
                      {{"side", "wall", {1, 2, 3, 4}}},
                      {{"connection", "donor", {1}, {2}, {-1}}}};
  const CgnsRequest read = cgns_request(to_bytes(request));
  EXPECT_TRUE(read.is_structured);
  EXPECT_EQ(read.cell_dimension, 3);
  EXPECT_EQ(read.families.at(0).boundary, "BCWall");
  const CgnsZone& zone = read.zones.at(0);
  EXPECT_EQ(zone.x, (std::vector<std::vector<double>>{{0.5}, {-1}}));
  EXPECT_EQ(zone.sections.at(0).first, 5);
  EXPECT_EQ(zone.sections.at(0).count, 7);
  EXPECT_EQ(zone.boundaries.at(0).range, (std::vector<std::int64_t>{1, 2, 3, 4}));
  EXPECT_EQ(zone.connections.at(0).donor_range, std::vector<std::int64_t>{2});
  EXPECT_EQ(zone.connections.at(0).transform, std::vector<std::int64_t>{-1});
}

}  // namespace
}  // namespace quadrille::exports
