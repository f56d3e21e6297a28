#include "draw/embedded.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../support/texts.hpp"
#include "draw/picture.hpp"
#include "small_picture.hpp"

namespace quadrille::draw {
namespace {

TEST(Embedded, APartIsPlacedAndItsIdentifiersAreItsOwn) {
  const std::string svg =
      "<?xml version=\"1.0\"?>\n<svg width=\"10\"><clipPath id=\"face\"/><g clip-path=\"url(#face)\" id=\"elem-0\"/>"
      "<use href=\"x\" fill=\"url(#ramp)\"/></svg>\n";
  EXPECT_EQ(embedded(svg, "left-", 12.5),
            "<svg x=\"12.5\" width=\"10\"><clipPath id=\"left-face\"/><g clip-path=\"url(#left-face)\" "
            "id=\"left-elem-0\"/><use href=\"x\" fill=\"url(#left-ramp)\"/></svg>\n");
}

TEST(Embedded, ThePartsFitTheWholeThatIsBegunForThem) {
  const std::string part = small_picture().str();
  EXPECT_GT(height_of(part), 20) << "that of the square, and the margins";
  const std::string whole = begin_parts("a < b", 300, height_of(part)) + embedded(part, "a-", 0) + "</svg>\n";
  EXPECT_EQ(height_of(whole), std::round(height_of(part)));
  expect_counts(whole, {{"<?xml ", 1}, {"<svg ", 2}, {"</svg>", 2}, {"<title>a &lt; b</title>", 1}});
}

}  // namespace
}  // namespace quadrille::draw
