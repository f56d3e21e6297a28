#include <gtest/gtest.h>

#include <cstring>

#include "base/base64.hpp"
#include "export/writers.hpp"
#include "two_hexes.hpp"

namespace quadrille::exports {
namespace {

/// The numbers of an array, behind the eight bytes of its size.
template <class Number>
std::vector<Number> array_of(const std::string& text, const std::string& name) {
  const std::size_t at = text.find("Name=\"" + name + "\""), first = text.find('\n', at) + 1;
  const std::string code = text.substr(first, text.find('\n', first) - first);
  const auto digit = [](char c) -> unsigned {
    return c >= 'a' ? c - 'a' + 26u : c >= 'A' ? c - 'A' + 0u : c >= '0' ? c - '0' + 52u : c == '+' ? 62u : 63u;
  };
  std::string bytes;
  for (std::size_t k = 12; k + 4 <= code.size(); k += 4) {
    unsigned bits = 0;
    for (std::size_t c = k; c < k + 4; ++c) bits = bits << 6 | (code[c] == '=' ? 0 : digit(code[c]));
    for (const int shift : {16, 8, 0}) bytes += static_cast<char>(bits >> shift & 255);
  }
  std::vector<Number> numbers((bytes.size() - (code.ends_with("==")  ? 2
                                               : code.ends_with('=') ? 1
                                                                     : 0)) /
                              sizeof(Number));
  std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(Number));
  return numbers;
}

TEST(VtuHex, NodesOfAHexahedronHaveVtksOrder) {
  // vtkLagrangeHexahedron::PointIndexFromIJK of VTK 9.1, order 3, the first coordinate fastest.
  const std::vector<int> index{0,  8,  9,  1,  14, 48, 49, 10, 15, 50, 51, 11, 3,  12, 13, 2,  24, 40, 41, 26, 32, 56,
                               57, 36, 33, 58, 59, 37, 30, 44, 45, 28, 25, 42, 43, 27, 34, 60, 61, 38, 35, 62, 63, 39,
                               31, 46, 47, 29, 4,  16, 17, 5,  22, 52, 53, 18, 23, 54, 55, 19, 7,  20, 21, 6};
  const HexMesh mesh = two_hexes({.order = 3, .first_corner = 1});
  const std::string text = vtu_lagrange(mesh).bytes;
  const std::vector<int> connectivity = array_of<int>(text, "connectivity");
  ASSERT_EQ(connectivity.size(), 128u);
  for (int elem = 0; elem < 2; ++elem)
    for (std::size_t k = 0; k < 64; ++k)
      EXPECT_EQ(connectivity[64 * elem + index[k]], mesh.elem_nodes[64 * elem + k]) << k;
  EXPECT_EQ(array_of<unsigned char>(text, "types"), (std::vector<unsigned char>{72, 72}));
  EXPECT_NE(text.find("version=\"2.2\""), std::string::npos) << "older versions exchange two upright edges";
}

TEST(VtuHex, PointsAreEquispacedOrControlPoints) {
  const auto z = [](double x) { return x * x; };
  const HexMesh mesh = two_hexes({.order = 2, .map = [&](Vec3 x) { return Vec3{x.x, x.y, z(x.z)}; }});
  const std::vector<double> points = array_of<double>(vtu_lagrange(mesh).bytes, "Points");
  const std::vector<double> controls = array_of<double>(vtu_bezier(mesh).bytes, "Points");
  ASSERT_EQ(points.size(), 3 * mesh.nodes.size());
  EXPECT_EQ(points[3 * 15 + 2], 0.25);
  EXPECT_NEAR(controls[3 * 15 + 2], 0, 1e-15) << "of z^2 on [0, 1]: 0, 0, 1";
  EXPECT_EQ(controls[3 * 30 + 2], 1);
}

TEST(VtuHex, RegionsLayersAndFacesAreNumbered) {
  HexMesh mesh = two_hexes({.order = 2, .layers = 2, .first_corner = 3});
  join_ends(mesh, 2);
  const Exported exported = vtu_lagrange(mesh);
  EXPECT_EQ(array_of<int>(exported.bytes, "region_id"), (std::vector<int>{0, 1, 0, 1}));
  EXPECT_EQ(array_of<int>(exported.bytes, "layer_id"), (std::vector<int>{0, 0, 1, 1}));
  ASSERT_EQ(exported.side_files.size(), 1u);
  const std::string& faces = exported.side_files[0].bytes;
  EXPECT_EQ(array_of<int>(faces, "name_id"), (std::vector<int>{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 4, 4, 2, 2, 3, 3}));
  EXPECT_EQ(array_of<int>(faces, "connectivity").size(), 18u * 9u);
  ASSERT_EQ(exported.losses.size(), 1u);
  EXPECT_NE(exported.losses[0].find("\"bottom\" and \"top\""), std::string::npos);
}

}  // namespace
}  // namespace quadrille::exports
