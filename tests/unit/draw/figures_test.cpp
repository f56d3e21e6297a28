#include "draw/figures.hpp"

#include <gtest/gtest.h>

#include <set>

#include "../samples.hpp"
#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille::draw {

namespace {

std::string compared(const QuadMesh& a, const QuadMesh& b, const DrawOptions& options = {}) {
  return draw_comparison(a, b, {"a.quad.h5", "b.quad.h5"}, options);
}

/// The values of an attribute, in their order.
std::vector<std::string> attributes(const std::string& svg, const std::string& name) {
  std::vector<std::string> values;
  const std::string mark = ' ' + name + "=\"";
  for (std::size_t at = svg.find(mark); at != std::string::npos; at = svg.find(mark, at + 1)) {
    const std::size_t from = at + mark.size();
    values.push_back(svg.substr(from, svg.find('"', from) - from));
  }
  return values;
}

TEST(Comparison, BothDrawingsHaveNamesAndIdentifiersOfTheirOwn) {
  const std::string svg = compared(samples::quad_mesh(), samples::quad_mesh());
  EXPECT_EQ(count(svg, "A: Quad mesh</text>"), 1);
  EXPECT_EQ(count(svg, "B: Quad mesh</text>"), 1);
  EXPECT_EQ(count(svg, ">a.quad.h5<"), 1);
  const std::vector<std::string> ids = attributes(svg, "id");
  EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), ids.size());
  for (const std::string prefix : {"a-", "b-"}) {
    EXPECT_EQ(count(svg, "url(#" + prefix + "ramp0)"), 1);
    EXPECT_EQ(count(svg, "id=\"" + prefix + "elem-"), samples::quad_mesh().num_elems());
  }
}

TEST(Comparison, FacesOfDifferentSizesAreDrawnAtOneScale) {
  QuadMesh large = samples::quad_mesh();
  for (Nurbs& curve : large.face.curves)
    for (Vec2& point : curve.poles) point = 3.0 * point;
  for (Vec2& node : large.nodes) node = 3.0 * node;
  const std::vector<std::string> bars = [&] {
    std::vector<std::string> found;
    const std::string svg = compared(samples::quad_mesh(), large);
    for (std::size_t at = svg.find("class=\"scale\""); at != std::string::npos;
         at = svg.find("class=\"scale\"", at + 1))
      found.push_back(svg.substr(at, svg.find("/>", at) - at));
    return found;
  }();
  ASSERT_EQ(bars.size(), 2u);
  EXPECT_EQ(bars[0].substr(bars[0].rfind('h')), bars[1].substr(bars[1].rfind('h')));
}

TEST(Comparison, TheTableHasTheFiguresOfBothAndADashForWhatOneLacks) {
  QuadMesh b = samples::quad_mesh();
  b.elem_area_jump.clear();
  const std::string svg = compared(samples::quad_mesh(), b);
  const std::string table = svg.substr(svg.find("id=\"table\""));
  for (const Figure& figure : figures_of(samples::quad_mesh())) EXPECT_EQ(count(table, '>' + figure.label + '<'), 1);
  EXPECT_EQ(count(table, ">greatest area jump<"), 1);
  EXPECT_EQ(count(table, ">–<"), 2) << "the greatest and the median";
}

TEST(Comparison, LayoutsAndGraphsAreComparedToo) {
  const BlockLayout layout = samples::block_layout();
  const SeparatrixGraph graph = samples::separatrix_graph();
  EXPECT_EQ(count(draw_comparison(layout, layout, {}, {}), ">chords<"), 1);
  EXPECT_EQ(count(draw_comparison(graph, graph, {}, {}), ">T-junctions<"), 1);
}

TEST(Comparison, AWindowIsThatOfBoth) {
  DrawOptions options;
  options.window = Window{{5, 5}, {6, 6}};
  EXPECT_THROW(compared(samples::quad_mesh(), samples::quad_mesh(), options), UsageError);
  options.window = Window{{0, 0}, {0.5, 0.5}};
  EXPECT_EQ(count(compared(samples::quad_mesh(), samples::quad_mesh(), options), "class=\"frame\""), 2);
}

}  // namespace

}  // namespace quadrille::draw
