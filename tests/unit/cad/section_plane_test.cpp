#include <gtest/gtest.h>

#include "../support/texts.hpp"
#include "base/error.hpp"
#include "cad/load_face.hpp"

namespace quadrille::cad {
namespace {

void expect_plane(const std::string& text, Vec3 point, Vec3 normal) {
  const SectionPlane plane = section_plane(text);
  EXPECT_EQ(plane.point, point) << text;
  EXPECT_LT(distance(plane.normal, normal), 1e-15) << text;
}

TEST(SectionPlane, AnAxisAndAValueAreAPlaneAcrossIt) {
  expect_plane("x=-2", {-2, 0, 0}, {1, 0, 0});
  expect_plane("y=1e3", {0, 1000, 0}, {0, 1, 0});
  expect_plane("z=0.5", {0, 0, 0.5}, {0, 0, 1});
}

TEST(SectionPlane, ANormalHasAnyLength) { expect_plane("0,3,4@1,2,3", {1, 2, 3}, {0, 0.6, 0.8}); }

TEST(SectionPlane, NoTextIsNoPlane) { EXPECT_FALSE(section_plane("").is_given()); }

TEST(SectionPlane, AnythingElseIsRefused) {
  for (const std::string text : {"w=1", "z", "z=", "z=1,2", "z=nan", "zz=1", "0,0,0@1,2,3", "0,1@1,2,3", "0,0,1@1,2",
                                 "0,0,1@", "@0,0,0", "0,0,inf@0,0,0", "z=1@0,0,0", "1"})
    EXPECT_EQ(message_of<UsageError>([&] { section_plane(text); }),
              "--section " + text +
                  ": expected x=VALUE, y=VALUE, z=VALUE or NX,NY,NZ@X,Y,Z: a normal and a point of the plane");
}

}  // namespace
}  // namespace quadrille::cad
