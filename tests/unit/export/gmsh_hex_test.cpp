#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>

#include "base/error.hpp"
#include "export/format_table.hpp"
#include "export/writers.hpp"
#include "two_hexes.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

TEST(GmshHex, ThePageShowsWhatIsWritten) {
  EXPECT_NE(page("msh.md").find("```\n" + gmsh_msh41(two_hexes_of_the_pages()).bytes + "```\n"), std::string::npos);
}

/// The numbers of a line.
std::vector<int> numbers(const std::string& line) {
  std::istringstream in(line);
  std::vector<int> result;
  for (int number = 0; in >> number;) result.push_back(number);
  return result;
}

/// The lines of a section.
std::vector<std::string> section(const std::string& text, const std::string& name) {
  const std::string begin = "$" + name + "\n", end = "$End" + name + "\n";
  const std::size_t first = text.find(begin), last = text.find(end);
  if (first == std::string::npos || last == std::string::npos) return {};
  std::istringstream in(text.substr(first + begin.size(), last - first - begin.size()));
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::map<int, std::array<double, 3>> node_positions(const std::string& text22) {
  std::map<int, std::array<double, 3>> nodes;
  for (const std::string& line : section(text22, "Nodes")) {
    std::istringstream in(line);
    int tag = 0;
    std::array<double, 3> x{};
    if (in >> tag >> x[0] >> x[1] >> x[2]) nodes[tag] = x;
  }
  return nodes;
}

TEST(GmshHex, NodesOfAHexahedronHaveGmshsOrder) {
  // As gmsh.model.mesh.getElementProperties(92) lists them, in thirds.
  const char* const thirds =
      "000 300 330 030 003 303 333 033 100 200 010 020 001 002 310 320 301 302 230 130 331 332 031 032 103 203 013 023 "
      "313 323 233 133 110 120 220 210 101 201 202 102 011 012 022 021 311 321 322 312 231 131 132 232 113 213 223 123 "
      "111 211 221 121 112 212 222 122";
  const std::string text = gmsh_msh22(two_hexes({.order = 3})).bytes;
  const auto nodes = node_positions(text);
  const std::vector<int> element = numbers(section(text, "Elements").at(12));
  ASSERT_EQ(element.size(), 5u + 64u);
  EXPECT_EQ(element[1], 92);
  std::istringstream in(thirds);
  std::size_t k = 5;
  for (std::string at; in >> at; ++k)
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(nodes.at(element[k])[axis], (at[axis] - '0') / 3.0 * (axis < 2 ? 2 : 1), 1e-15) << k << ' ' << axis;
  EXPECT_EQ(k, element.size());
}

TEST(GmshHex, EveryOrderUpToNineHasItsTypesAndNodes) {
  const std::array<int, 10> hex_types{0, 5, 12, 92, 93, 94, 95, 96, 97, 98};
  for (int order = 1; order <= 9; ++order) {
    const HexMesh mesh = two_hexes({.order = order, .layers = 2, .first_corner = 3, .map = bent});
    const std::string text = gmsh_msh22(mesh).bytes;
    std::map<int, int> types;
    for (const std::string& line : section(text, "Elements")) {
      const std::vector<int> element = numbers(line);
      if (element.size() < 2) continue;
      ++types[element[1]];
      const std::set<int> nodes(element.begin() + 5, element.end());
      EXPECT_EQ(nodes.size(), element.size() - 5);
      if (element[1] == hex_types[order]) {
        EXPECT_EQ(static_cast<int>(nodes.size()), mesh.nodes_per_elem());
      }
    }
    EXPECT_EQ(types.size(), 2u);
    EXPECT_EQ(types[hex_types[order]], 4);
  }
  EXPECT_THROW(export_mesh(two_hexes({.order = 10}), *find_export_format("msh")), ComputeError);
}

TEST(GmshHex, FacesOfGroupsPointOutwardsAndThoseOfInterfacesAreWrittenOnce) {
  const std::string text = gmsh_msh22(two_hexes({.order = 1, .first_corner = 2})).bytes;
  const auto nodes = node_positions(text);
  std::map<int, int> counts;
  for (const std::string& line : section(text, "Elements")) {
    const std::vector<int> e = numbers(line);
    if (e.size() != 9u) continue;
    ++counts[e[3]];
    std::array<std::array<double, 3>, 3> x{nodes.at(e[5]), nodes.at(e[6]), nodes.at(e[7])};
    const auto along = [&](int point, int axis) { return x[point][axis] - x[0][axis]; };
    for (int axis = 0; axis < 3; ++axis) {
      const int p = (axis + 1) % 3, q = (axis + 2) % 3;
      const double normal = along(1, p) * along(2, q) - along(1, q) * along(2, p);
      const double outside = axis == 0 ? x[0][0] - 1.5 : x[0][axis] - (axis == 1 ? 1 : 0.5);
      EXPECT_TRUE(normal == 0 || normal * outside > 0) << line;
    }
  }
  EXPECT_EQ(counts, (std::map<int, int>{{1, 5}, {2, 1}, {3, 2}, {4, 2}, {5, 1}}));
}

TEST(GmshHex, PeriodicGroupsAreLinkedNodeByNode) {
  HexMesh mesh = two_hexes({.order = 2, .layers = 2, .first_corner = 1});
  join_ends(mesh, 2);
  const std::string text = gmsh_msh22(mesh).bytes;
  const auto nodes = node_positions(text);
  const std::vector<std::string> lines = section(text, "Periodic");
  ASSERT_EQ(lines.size(), 4u + 15u);
  EXPECT_EQ(lines[0], "1");
  EXPECT_EQ(lines[1], "2 12 11");  // surfaces 5 and 4 behind seven groups
  EXPECT_EQ(lines[2], "Affine 1 0 0 0 0 1 0 0 0 0 1 2 0 0 0 1");
  for (std::size_t k = 4; k < lines.size(); ++k) {
    const std::vector<int> pair = numbers(lines[k]);
    const auto &slave = nodes.at(pair[0]), &master = nodes.at(pair[1]);
    EXPECT_EQ(slave, (std::array<double, 3>{master[0], master[1], master[2] + 2}));
  }
  EXPECT_NE(gmsh_msh41(mesh).bytes.find("\n$Periodic\n1\n2 5 4\n16 1 0 0 0 "), std::string::npos);
}

}  // namespace
}  // namespace quadrille::exports
