#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "base/error.hpp"
#include "export/format_table.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

std::string msh_text(const QuadMesh& mesh) { return gmsh_msh41(mesh, plane_frame(mesh.face)).bytes; }

/// What this test needs of a file, by a reader that shares no code with the writer.
struct Msh {
  std::map<std::pair<int, int>, std::string> names;
  std::map<long, Vec2> nodes;
  std::map<long, int> node_dim;
  std::map<std::pair<int, int>, int> entity_group;
  struct Element {
    int dim, entity, type;
    std::vector<long> nodes;
  };
  std::map<long, Element> elements;
};

Msh parsed(const std::string& text) {
  Msh msh;
  std::istringstream in(text);
  std::string word;
  while (in >> word) {
    if (word == "$PhysicalNames") {
      int count = 0;
      in >> count;
      for (int k = 0; k < count; ++k) {
        int dim = 0, tag = 0;
        in >> dim >> tag >> std::ws;
        std::string name;
        std::getline(in, name);
        msh.names[{dim, tag}] = name.substr(1, name.size() - 2);
      }
    } else if (word == "$Entities") {
      std::array<int, 4> counts{};
      for (int& c : counts) in >> c;
      for (int dim = 0; dim < 3; ++dim)
        for (int k = 0; k < counts[dim]; ++k) {
          int tag = 0, num_groups = 0, group = 0, num_bounding = 0;
          double skipped = 0;
          in >> tag;
          for (int c = 0; c < (dim == 0 ? 3 : 6); ++c) in >> skipped;
          in >> num_groups;
          if (num_groups > 0) in >> group, msh.entity_group[{dim, tag}] = group;
          if (dim == 0) continue;
          in >> num_bounding;
          for (int b = 0; b < num_bounding; ++b) in >> skipped;
        }
    } else if (word == "$Nodes") {
      long blocks = 0, count = 0, low = 0, high = 0;
      in >> blocks >> count >> low >> high;
      for (long b = 0; b < blocks; ++b) {
        int dim = 0, entity = 0, parametric = 0;
        long n = 0;
        in >> dim >> entity >> parametric >> n;
        std::vector<long> tags(n);
        for (long& tag : tags) in >> tag;
        for (const long tag : tags) {
          Vec2 x;
          double z = 0;
          in >> x.x >> x.y >> z;
          EXPECT_TRUE(msh.nodes.emplace(tag, x).second) << "node tag twice";
          msh.node_dim[tag] = dim;
        }
      }
      EXPECT_EQ(static_cast<long>(msh.nodes.size()), count);
    } else if (word == "$Elements") {
      long blocks = 0, count = 0, low = 0, high = 0;
      in >> blocks >> count >> low >> high;
      for (long b = 0; b < blocks; ++b) {
        Msh::Element e{};
        long n = 0;
        in >> e.dim >> e.entity >> e.type >> n >> std::ws;
        for (long k = 0; k < n; ++k) {
          std::string line;
          std::getline(in, line);
          std::istringstream fields(line);
          long tag = 0;
          fields >> tag;
          e.nodes.clear();
          for (long node = 0; fields >> node;) e.nodes.push_back(node);
          EXPECT_TRUE(msh.elements.emplace(tag, e).second) << "element tag twice";
        }
      }
      EXPECT_EQ(static_cast<long>(msh.elements.size()), count);
    }
  }
  return msh;
}

TEST(Gmsh, SquareOfOrderOneInFull) {
  const std::string text = msh_text(refined(hand_made::unit_square(), {1, 1, 5e-7}));
  const Msh msh = parsed(text);
  EXPECT_EQ(text.substr(0, 23), "$MeshFormat\n4.1 0 8\n$En");
  EXPECT_EQ(msh.nodes.size(), 4u);
  EXPECT_EQ(msh.elements.size(), 5u);
  EXPECT_EQ(msh.names.at({1, 1}), "side_0");
  EXPECT_EQ(msh.names.at({2, 5}), "domain");
  std::vector<Vec2> corners;
  for (const long node : msh.elements.at(5).nodes) corners.push_back(msh.nodes.at(node));
  EXPECT_EQ(corners, (std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
}

TEST(Gmsh, NodesOfAQuadComeInGmshSequence) {
  // Order 3 on the square: corners, sides travelling round, then the four inner nodes counter-clockwise.
  const Msh msh = parsed(msh_text(refined(hand_made::unit_square(), {1, 3, 5e-7})));
  const Msh::Element quad = msh.elements.rbegin()->second;
  const std::vector<Vec2> thirds{{0, 0}, {3, 0}, {3, 3}, {0, 3}, {1, 0}, {2, 0}, {3, 1}, {3, 2},
                                 {2, 3}, {1, 3}, {0, 2}, {0, 1}, {1, 1}, {2, 1}, {2, 2}, {1, 2}};
  ASSERT_EQ(quad.nodes.size(), thirds.size());
  EXPECT_EQ(quad.type, 36);
  for (std::size_t k = 0; k < thirds.size(); ++k)
    EXPECT_NEAR(distance(msh.nodes.at(quad.nodes[k]), thirds[k] / 3), 0, 1e-15) << k;
}

TEST(Gmsh, EveryOrderUpToTenHasItsTypesAndNodes) {
  for (int order = 1; order <= 10; ++order) {
    const QuadMesh mesh = refined(hand_made::l_shape(), {0.5, order, 5e-7});
    const Msh msh = parsed(msh_text(mesh));
    EXPECT_EQ(msh.nodes.size(), mesh.nodes.size());
    std::size_t lines = 0;
    for (const auto& [tag, e] : msh.elements) {
      EXPECT_EQ(static_cast<int>(e.nodes.size()), e.dim == 1 ? order + 1 : (order + 1) * (order + 1));
      EXPECT_EQ(std::set<long>(e.nodes.begin(), e.nodes.end()).size(), e.nodes.size());
      lines += e.dim == 1;
    }
    EXPECT_EQ(lines, mesh.boundary_edges.size());
    EXPECT_EQ(msh.elements.size() - lines, static_cast<std::size_t>(mesh.num_elems()));
  }
  EXPECT_THROW(export_mesh(refined(hand_made::unit_square(), {1, 11, 5e-7}), *find_export_format("msh")), ComputeError);
}

TEST(Gmsh, NodesBelongToTheEntityOfLowestDimension) {
  const QuadMesh mesh = refined(hand_made::l_shape(), {0.5, 2, 5e-7});
  std::array<int, 3> counts{};
  const Msh msh = parsed(msh_text(mesh));
  for (const auto& [tag, dim] : msh.node_dim) ++counts[dim];
  EXPECT_EQ(counts[0], 8);       // the layout's nodes
  EXPECT_EQ(counts[1], 10 * 3);  // ten arcs of two elements of order 2
  EXPECT_EQ(counts[2], 3 * 9);   // 3 x 3 nodes inside each block
}

TEST(Gmsh, CurvesOfOneNameAreOneGroup) {
  QuadMesh mesh = refined(hand_made::unit_square(), {0.5, 2, 5e-7});
  mesh.face.curve_names = {"wall", "outlet \"east\"", "wall", ""};
  const Msh msh = parsed(msh_text(mesh));
  std::map<std::string, int> lines;
  for (const auto& [tag, e] : msh.elements)
    if (e.dim == 1) ++lines[msh.names.at({1, msh.entity_group.at({1, e.entity})})];
  EXPECT_EQ(lines, (std::map<std::string, int>{{"wall", 4}, {"outlet 'east'", 2}, {"curve_3", 2}}));
}

TEST(Gmsh, OriginIsAddedAndDigitsAreKept) {
  QuadMesh mesh = refined(hand_made::quarter_annulus(), {0.5, 4, 5e-7});
  const Msh near = parsed(msh_text(mesh));
  mesh.face.origin = {1024, -2048};
  const Msh far = parsed(msh_text(mesh));
  for (const auto& [tag, x] : near.nodes) EXPECT_EQ(far.nodes.at(tag), (x + Vec2{1024, -2048}));
}

TEST(Gmsh, HighOrderNodesLieOnTheSamePolynomial) {
  // Radius along the outer arc: equispaced nodes of the GLL interpolant are as near to the circle as the GLL nodes'
  // span.
  const QuadMesh mesh = refined(hand_made::quarter_annulus(), {0.2, 8, 5e-7});
  const Msh msh = parsed(msh_text(mesh));
  for (const auto& [tag, e] : msh.elements) {
    if (e.dim != 1) continue;
    const std::string name = msh.names.at({1, msh.entity_group.at({1, e.entity})});
    for (const long node : e.nodes) {
      if (name == "side_1") {
        EXPECT_NEAR(norm(msh.nodes.at(node)), 2, 1e-12);
      } else if (name == "side_3") {
        EXPECT_NEAR(norm(msh.nodes.at(node)), 1, 1e-12);
      }
    }
  }
}

}  // namespace
}  // namespace quadrille::exports
