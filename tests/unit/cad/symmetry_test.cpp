// Symmetries of faces as CAD files hold them: rounded coordinates, circles cut anywhere.
#include "curve/symmetry.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "../support/test_data.hpp"
#include "cad/load_face.hpp"

namespace quadrille::cad {
namespace {

/// Rotations and mirrored isometries.
std::pair<int, int> order_of(const std::string& file) {
  std::ifstream stream(test_data() + "/" + file, std::ios::binary);
  if (!stream) throw std::runtime_error("no " + file);
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  Report report;
  const CadFace face = load_face_guarded(bytes.str(), file, {}, report).face;
  std::pair<int, int> order;
  for (const curve::Isometry& g : curve::symmetries(face)) ++(g.is_mirrored ? order.second : order.first);
  return order;
}

using Order = std::pair<int, int>;

TEST(SymmetriesOfFiles, are_those_of_the_shapes) {
  EXPECT_EQ(order_of("square.step"), Order(4, 4));
  EXPECT_EQ(order_of("annulus.step"), Order(4, 4));
  EXPECT_EQ(order_of("ellipse.step"), Order(2, 2));
  EXPECT_EQ(order_of("stadium.step"), Order(2, 2));
  EXPECT_EQ(order_of("s_bend.step"), Order(2, 0));
  EXPECT_EQ(order_of("half_disc.step"), Order(1, 1));
  EXPECT_EQ(order_of("l_shape.step"), Order(1, 1));
  EXPECT_EQ(order_of("geometry_1.step"), Order(1, 1));
  EXPECT_EQ(order_of("quarter_annulus.step"), Order(1, 1));
  EXPECT_EQ(order_of("eccentric_annulus.step"), Order(1, 1));
  EXPECT_EQ(order_of("plate_hole.step"), Order(1, 0));
  EXPECT_EQ(order_of("cylinder_channel.step"), Order(1, 0));
}

}  // namespace
}  // namespace quadrille::cad
