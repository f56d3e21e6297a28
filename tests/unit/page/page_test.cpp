#include "page/page.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../chart_samples.hpp"
#include "../region_samples.hpp"
#include "curve/nurbs.hpp"
#include "draw/palette.hpp"
#include "page/page_data.hpp"

namespace quadrille::page {
namespace {

std::vector<StageModel> all_stages() {
  return {samples::tri_mesh(),         samples::field(),        samples::critical_points(),
          samples::separatrix_graph(), samples::block_layout(), samples::quad_mesh()};
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(Page, EveryStageIsATabWithLayers) {
  const std::string page = html_page(all_stages());
  for (const char* title : {"Triangle mesh", "Guiding field", "Critical points", "Separatrices", "Blocks", "Quad mesh"})
    EXPECT_EQ(count(page, std::string("{\"title\":\"") + title + "\",\"name\":"), 1u) << title;
  for (const char* key : {"field", "corners", "lines", "blocks", "arcs"})
    EXPECT_EQ(count(page, std::string("\"key\":\"") + key + '"'), 1u) << key;
  EXPECT_EQ(count(page, "\"key\":\"mesh\""), 3u);
  EXPECT_EQ(count(page, "\"key\":\"boundary\""), 5u) << "of every stage but the critical points";
}

TEST(Page, AWorkbenchHasItsScriptItsStateAndItsServer) {
  const std::string usual = html_page(all_stages());
  RunRecord run;
  run.workbench = "{\"shape\":\"</script>\"}";
  const std::string page = html_page(all_stages(), run);
  EXPECT_EQ(count(page, "\"workbench\":{\"shape\":\"\\u003c/script\\u003e\"}"), 1u);
  EXPECT_EQ(count(page, "connect-src 'self'"), 1u);
  EXPECT_EQ(count(page, "function startWorkbench()"), 1u);
  for (const char* part : {"workbench\":", "connect-src", "startWorkbench"}) EXPECT_EQ(count(usual, part), 0u) << part;
  const std::string data = page_data(all_stages(), run);
  EXPECT_EQ(data.front(), '{');
  EXPECT_EQ(count(page, ">" + data + "<"), 1u);
}

TEST(Page, TheChartOfACurvedFaceIsATab) {
  const std::string page = html_page({samples::charted_face()});
  EXPECT_EQ(count(page, "{\"title\":\"Chart\",\"name\":\"\",\"caption\":\"2 triangles of order 2 on 1 surface\""), 1u);
  EXPECT_EQ(count(page, "\"key\":\"mesh\""), 1u);
}

TEST(Page, MeshesOfCurvedFacesHaveTheirShapeInSpace) {
  QuadMesh mesh = samples::quad_mesh();
  mesh.face = samples::sphere_face(1, 2);
  for (Vec2& x : mesh.nodes) x = x / 2;
  for (const Vec2 x : mesh.nodes) mesh.space_nodes.push_back(samples::on_sphere(x));
  const std::string page = html_page({mesh});
  EXPECT_EQ(count(page, "\"space\":{\"points\":\""), 1u);
  EXPECT_EQ(count(page, "\"samples\":4,\"extent\":"), 1u);
  EXPECT_EQ(count(page, "\"elems\":\"" + packed(std::vector<std::int32_t>{0, -1, 1, -1}) + '"'), 1u);
  EXPECT_EQ(count(html_page({samples::quad_mesh()}), "\"space\":{"), 0u);
}

TEST(Page, HexahedraHaveEveryFaceOnceWithTheElementsThatItBounds) {
  const std::string page = html_page({samples::hex_mesh()});
  const std::string elems = page.substr(page.find("\"elems\":\"") + 9, 200);
  EXPECT_EQ(elems.find('"'), (11 * 8 + 2) / 3 * 4u) << "bytes of eleven pairs in base64: two hexahedra share one face";
  EXPECT_EQ(count(page, "\"unit\":\"m\""), 1u);
  EXPECT_EQ(count(page, "\"type\":\"solids\""), 1u);
  EXPECT_EQ(count(page, "\"type\":\"cells\""), 0u);
  EXPECT_EQ(count(html_page({samples::quad_mesh(), samples::hex_mesh()}), "\"type\":\"solids\""), 1u);
}

TEST(Page, ItReadsNothingFromElsewhereAndIsTheSameTwice) {
  const std::string page = html_page(all_stages());
  EXPECT_EQ(page, html_page(all_stages()));
  for (const char* reference : {"http:", "https:", " src=", "@import", "url(", "import(", "fetch("})
    EXPECT_EQ(count(page, reference), 0u) << reference;
  EXPECT_TRUE(page.starts_with("<!doctype html>"));
  EXPECT_TRUE(page.ends_with("</html>\n"));
}

TEST(Page, RegionsHaveNamesAndInterfacesPartners) {
  const std::string page = html_page({samples::two_regions_mesh(), samples::two_regions_field()});
  EXPECT_EQ(count(page, R"("regions":[["fluid",-0.5,0,0.5],["solid",0.5,0,0.5]])"), 2u);
  EXPECT_EQ(count(page, "\"partners\":\""), 2u);
  EXPECT_EQ(count(page, ", 2 regions"), 2u);
  const std::string one = html_page({samples::tri_mesh()});
  EXPECT_EQ(count(one, "\"partners\":"), 0u);
  EXPECT_EQ(count(one, "\"regions\":"), 0u);
  EXPECT_EQ(count(html_page({samples::slit_mesh()}), "\"partners\":\""), 1u);
  EXPECT_EQ(count(html_page({samples::two_regions_phase_field()}), "prescribed node of valence 3"), 1u);
}

TEST(Page, NamesAreEscaped) {
  QuadMesh mesh = samples::quad_mesh();
  mesh.face.name = "<b>&\"name\"";
  mesh.face.curve_names[0] = "</script><script>alert(1)</script>";
  const std::string page = html_page({mesh});
  EXPECT_EQ(count(page, "alert(1)"), 1u);
  EXPECT_EQ(count(page, "</script><script>alert"), 0u);
  EXPECT_EQ(count(page, "<title>&lt;b&gt;&amp;&quot;name&quot;</title>"), 1u);
  EXPECT_EQ(count(page, "<script"), 2u) << "the data and the script";
}

TEST(Page, TheShapeAndTheComparedFilesAreNamed) {
  QuadMesh mesh = samples::quad_mesh();
  mesh.face.name = "fluid";
  EXPECT_EQ(count(html_page({mesh}), "<title>fluid</title>"), 1u);
  EXPECT_EQ(count(html_page({mesh}, {"naca4412", "", {}}), "<title>naca4412</title>"), 1u);
  const std::string page = comparison_page(mesh, mesh, {"a.quad.h5", "b.quad.h5"});
  EXPECT_EQ(count(page, "<title>a.quad.h5 and b.quad.h5</title>"), 1u);
  for (const char* name : {"a.quad.h5", "b.quad.h5"})
    EXPECT_EQ(count(page, std::string("\"name\":\"") + name + '"'), 1u);
}

TEST(Page, TheReportOfARunIsEscaped) {
  const std::string page =
      html_page({samples::quad_mesh()}, {"", R"({"error":"</script><b>&","blocks":4})", {"a <b.h5"}});
  EXPECT_EQ(count(page, R"("report":{"error":"\u003c/script\u003e\u003cb\u003e\u0026","blocks":4})"), 1u);
  EXPECT_EQ(count(page, R"("commands":["a \u003cb.h5"])"), 1u);
  EXPECT_EQ(count(html_page({samples::quad_mesh()}), "\"commands\":["), 0u) << "no report is known";
}

TEST(Page, ColoursAreThoseOfPictures) {
  const std::string page = html_page({samples::quad_mesh()});
  for (const draw::Paper paper : {draw::Paper::light, draw::Paper::dark})
    EXPECT_GE(count(page, "\"few\":\"" + draw::palette(paper).few + '"'), 1u);
  const std::string script = page.substr(page.rfind("<script>"));
  for (const std::string& colour : draw::palette(draw::Paper::light).lines) EXPECT_EQ(count(script, colour), 0u);
}

TEST(Page, CriticalPointsAloneHaveAPage) {
  const std::string page = html_page({samples::critical_points()});
  EXPECT_EQ(count(page, "\"key\":\"boundary\""), 0u);
  EXPECT_EQ(count(page, "\"type\":\"marks\""), 2u);
}

TEST(Page, ComparedFacesLieWhereTheirOriginsPutThem) {
  QuadMesh moved = samples::quad_mesh();
  moved.face.origin = {3, 0};
  const std::string page = comparison_page(samples::quad_mesh(), moved);
  EXPECT_EQ(count(page, "\"comparison\":true"), 1u);
  EXPECT_EQ(count(page, "\"x\":2,\"y\":0.5,\"width\":4,\"height\":1"), 1u) << "two unit squares, 2 apart";
  EXPECT_EQ(count(html_page({moved}), "\"x\":3.5,\"y\":0.5,\"width\":1,"), 1u);
}

TEST(Page, TheFirstViewFitsTheBodyInAFarField) {
  QuadMesh mesh = samples::quad_mesh();
  mesh.face.curve_names.assign(mesh.face.curves.size(), "farfield");
  mesh.face.unnamed_curves.clear();
  EXPECT_EQ(count(html_page({mesh}), "\"body\":["), 0u) << "there is no body";
  mesh.face.curves.push_back(curve::segment({0.25, 0.5}, {0.375, 0.5}));
  mesh.face.curve_names.push_back("wall");
  mesh.face.loop_offsets.push_back(mesh.face.num_curves());
  EXPECT_EQ(count(html_page({mesh}), "\"body\":[-0.25,0,-0.125,0]"), 1u) << "relative to the middle";
  mesh.face.curves.back() = curve::segment({0.25, 0.5}, {0.75, 0.5});
  EXPECT_EQ(count(html_page({mesh}), "\"body\":["), 0u) << "large enough to be seen";
  mesh.face.curve_names.assign(mesh.face.curves.size(), "wall");
  EXPECT_EQ(count(html_page({mesh}), "\"body\":["), 0u) << "no far field";
}

TEST(Page, FilesWithoutMeasuresOfLengthsHaveFewerQuantities) {
  QuadMesh mesh = samples::quad_mesh();
  const std::string all = html_page({mesh});
  mesh.elem_edge_ratio.clear();
  mesh.elem_area_jump.clear();
  const std::string few = html_page({mesh});
  EXPECT_EQ(count(all, "\"title\":\"area jump\""), 1u);
  EXPECT_EQ(count(few, "\"title\":\"area jump\""), 0u);
  EXPECT_EQ(count(few, "\"title\":\"skewness\""), 1u);
}

}  // namespace
}  // namespace quadrille::page
