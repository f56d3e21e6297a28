#include <gtest/gtest.h>

#include <sstream>

#include "base/error.hpp"
#include "export/writers.hpp"
#include "two_hexes.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

TEST(MfemHex, ThePageShowsWhatIsWritten) {
  EXPECT_NE(page("mfem.md").find("```\n" + mfem_mesh13(two_hexes_of_the_pages()).bytes + "```\n"), std::string::npos);
}

/// The lines after the head of the grid function.
std::vector<std::string> nodes_of(const std::string& text) {
  std::istringstream in(text.substr(text.find("Ordering: 1\n\n") + 13));
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line) && !line.empty();) lines.push_back(line);
  return lines;
}

TEST(MfemHex, NodesAreNumberedByVerticesEdgesFacesAndElements) {
  // 12 vertices, 20 edges, 11 faces, 2 elements; a middle of each. The first face is the bottom of the first element.
  const std::vector<std::string> nodes = nodes_of(mfem_mesh10(two_hexes({.order = 2, .first_corner = 1})).bytes);
  ASSERT_EQ(nodes.size(), 45u);
  EXPECT_EQ(nodes[0], "0 0 0");
  EXPECT_EQ(nodes[12], "1 0 0");
  EXPECT_EQ(nodes[12 + 8], "0 0 0.5") << "upright edges follow those of the top";
  EXPECT_EQ(nodes[32], "1 1 0");
  EXPECT_EQ(nodes[33], "1 0 0.5");
  EXPECT_EQ(nodes[38], "3 1 0") << "the bottom of the second element, whose side 3 is known";
  EXPECT_EQ(nodes[44], "3 1 0.5");
}

TEST(MfemHex, NodesOfAFaceRunAsItsFirstElementSeesThem) {
  // The bottom of the first element, of order 3, from corner 3 to corner 2 first, then towards corner 0.
  const std::vector<std::string> nodes = nodes_of(mfem_mesh10(two_hexes({.order = 3})).bytes);
  const auto coordinates = [&](std::size_t k) {
    std::istringstream in(nodes.at(k));
    std::array<double, 3> x{};
    in >> x[0] >> x[1] >> x[2];
    return x;
  };
  const std::size_t first = 12 + 2 * 20;
  EXPECT_GT(coordinates(first + 1)[0], coordinates(first)[0]);
  EXPECT_EQ(coordinates(first + 1)[1], coordinates(first)[1]);
  EXPECT_LT(coordinates(first + 2)[1], coordinates(first)[1]);
}

TEST(MfemHex, VerticesOfPeriodicFacesAreOneWhereMfemCanDistinguishFaces) {
  HexMesh mesh = two_hexes({.order = 2, .layers = 3});
  join_ends(mesh, 3);
  const Exported three = mfem_mesh13(mesh);
  EXPECT_TRUE(three.losses.empty());
  EXPECT_NE(three.bytes.find("\nvertices\n18\n\nnodes\nFiniteElementSpace\nFiniteElementCollection: L2_T1_3D_P2\n"),
            std::string::npos);
  EXPECT_EQ(nodes_of(three.bytes).size(), 6u * 27u);
  mesh = two_hexes({.order = 2, .layers = 2});
  join_ends(mesh, 2);
  const Exported two = mfem_mesh13(mesh);
  ASSERT_EQ(two.losses.size(), 1u);
  EXPECT_NE(two.losses[0].find("\"bottom\" and \"top\" (MFEM identifies"), std::string::npos);
  EXPECT_NE(two.bytes.find("H1_3D_P2"), std::string::npos);
  mesh.face_groups[3].motion.shift.z = 1.9;
  EXPECT_THROW(mfem_mesh13(mesh), ComputeError);
}

TEST(MfemHex, Version10HasATableOfNames) {
  const Exported exported = mfem_mesh10(two_hexes({}));
  ASSERT_EQ(exported.side_files.size(), 1u);
  EXPECT_NE(exported.side_files[0].bytes.find(R"("interfaces": [
    {"id": 5, "name": "between"})"),
            std::string::npos);
  ASSERT_EQ(exported.losses.size(), 1u);
}

}  // namespace
}  // namespace quadrille::exports
