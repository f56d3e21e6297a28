#include "draw/marks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "small_picture.hpp"

namespace quadrille::draw {
namespace {

std::string path_of(const Nurbs& curve, double t0, double t1) {
  PathData path;
  append_nurbs(path, small_picture(), curve, t0, t1);
  return path.str();
}

TEST(Marks, EachPieceOfASplineEndsWithItsOwnTangent) {
  // Two parabolas that meet at a right angle; each is one cubic exactly, but not with a tangent of the other.
  const Nurbs angle{2, {0, 0, 0, 1, 1, 2, 2, 2}, {{-1, -1}, {1, -1}, {1, 0}, {-1, 0}, {-1, 1}}, {1, 1, 1, 1, 1}};
  for (const auto& [from, to] : {std::pair{0.0, 2.0}, {2.0, 0.0}}) {
    const std::string path = path_of(angle, from, to);
    EXPECT_EQ(std::count(path.begin(), path.end(), 'C'), 2) << path;
  }
}

}  // namespace
}  // namespace quadrille::draw
