#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

std::string msh22(const QuadMesh& mesh) { return gmsh_msh22(mesh, plane_frame(mesh.face)).bytes; }

/// By a reader that shares no code with the writer.
struct Msh22 {
  std::map<std::array<int, 2>, std::string> names;  ///< by dimension and tag
  std::map<long, Vec2> nodes;
  struct Element {
    int type = 0, group = 0, entity = 0;
    std::vector<long> nodes;
  };
  std::vector<Element> elements;
};

Msh22 parsed(const std::string& text) {
  Msh22 msh;
  std::istringstream in(text);
  std::string line;
  long count = 0;
  const auto next_fields = [&] {
    std::getline(in, line);
    return std::istringstream(line);
  };
  while (std::getline(in, line)) {
    if (line == "$MeshFormat") {
      std::getline(in, line);
      EXPECT_EQ(line, "2.2 0 8");
    } else if (line == "$PhysicalNames") {
      for (next_fields() >> count; count > 0; --count) {
        std::istringstream fields = next_fields();
        int dim = 0, tag = 0;
        std::string name;
        std::getline(fields >> dim >> tag >> std::ws, name);
        EXPECT_TRUE(msh.names.emplace(std::array{dim, tag}, name).second);
      }
    } else if (line == "$Nodes") {
      for (next_fields() >> count; count > 0; --count) {
        long tag = 0;
        Vec2 x;
        double z = 1;
        next_fields() >> tag >> x.x >> x.y >> z;
        EXPECT_EQ(z, 0);
        EXPECT_TRUE(msh.nodes.emplace(tag, x).second);
      }
    } else if (line == "$Elements") {
      next_fields() >> count;
      for (long tag = 1; tag <= count; ++tag) {
        std::istringstream fields = next_fields();
        long number = 0;
        int num_tags = 0;
        Msh22::Element e;
        fields >> number >> e.type >> num_tags >> e.group >> e.entity;
        EXPECT_EQ(number, tag);
        EXPECT_EQ(num_tags, 2);
        for (long node = 0; fields >> node;) e.nodes.push_back(node);
        msh.elements.push_back(e);
      }
    }
  }
  return msh;
}

TEST(Gmsh22, SquareOfOrderOneToTheByte) {
  QuadMesh mesh = refined(hand_made::unit_square(), {1, 1, 5e-7});
  mesh.face.curve_names = {"wall", "wall", "out\"let\"", ""};
  EXPECT_EQ(msh22(mesh), R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
4
1 1 "wall"
1 2 "out'let'"
1 3 "curve_3"
2 4 "domain"
$EndPhysicalNames
$Nodes
4
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
$EndNodes
$Elements
5
1 1 2 1 5 1 2
2 1 2 1 6 2 3
3 1 2 2 7 3 4
4 1 2 3 8 4 1
5 3 2 4 5 1 2 3 4
$EndElements
)");
}

TEST(Gmsh22, HoldsTheNodesOf41) {
  // The same numbers in both versions: whatever follows the version-4 header of a block of nodes.
  const QuadMesh mesh = refined(hand_made::quarter_annulus(), {0.5, 5, 5e-7});
  const Msh22 msh = parsed(msh22(mesh));
  const std::string other = gmsh_msh41(mesh, plane_frame(mesh.face)).bytes;
  ASSERT_EQ(msh.nodes.size(), mesh.nodes.size());
  std::istringstream in(msh22(mesh));
  std::string line;
  while (std::getline(in, line) && line != "$Nodes") {
  }
  for (std::getline(in, line); std::getline(in, line) && line != "$EndNodes";)
    EXPECT_NE(other.find('\n' + line.substr(line.find(' ') + 1) + '\n'), std::string::npos) << line;
}

TEST(Gmsh22, EveryElementIsInOneNamedGroupOfItsDimension) {
  const QuadMesh mesh = refined(hand_made::cut_annulus(4), {0.3, 3, 5e-7});
  const Msh22 msh = parsed(msh22(mesh));
  std::set<int> tags;
  for (const auto& [key, name] : msh.names) {
    EXPECT_GT(key[1], 0);
    EXPECT_TRUE(tags.insert(key[1]).second) << "a tag of both dimensions";
  }
  std::size_t lines = 0;
  std::set<int> blocks;
  for (const Msh22::Element& e : msh.elements) {
    const bool is_line = e.type == 26;
    EXPECT_EQ(e.nodes.size(), is_line ? 4u : 16u);
    EXPECT_TRUE(msh.names.count({is_line ? 1 : 2, e.group}));
    lines += is_line;
    if (!is_line) blocks.insert(e.entity);
    EXPECT_FALSE(tags.count(e.entity)) << "a tag of a group and of an entity";
  }
  EXPECT_EQ(lines, mesh.boundary_edges.size());
  EXPECT_EQ(msh.elements.size() - lines, mesh.elem_block.size());
  EXPECT_EQ(blocks.size(), 4u);
}

TEST(Gmsh22, EveryOrderUpToTenHasItsTypes) {
  const std::array<int, 11> lines{0, 1, 8, 26, 27, 28, 62, 63, 64, 65, 66};
  const std::array<int, 11> quads{0, 3, 10, 36, 37, 38, 47, 48, 49, 50, 51};
  for (int order = 1; order <= 10; ++order) {
    const Msh22 msh = parsed(msh22(refined(hand_made::l_shape(), {1, order, 5e-7})));
    for (const Msh22::Element& e : msh.elements) {
      EXPECT_EQ(e.type, e.nodes.size() == order + 1u ? lines[order] : quads[order]);
      EXPECT_EQ(std::set<long>(e.nodes.begin(), e.nodes.end()).size(), e.nodes.size());
    }
  }
}

}  // namespace
}  // namespace quadrille::exports
