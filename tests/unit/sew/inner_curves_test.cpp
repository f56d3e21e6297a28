#include "sew/inner_curves.hpp"

#include <gtest/gtest.h>

#include "../support/texts.hpp"
#include "base/error.hpp"
#include "base/warning_codes.hpp"
#include "regions.hpp"

namespace quadrille::sew {

namespace {

using namespace testing_regions;

heal::HealScale scale() {
  heal::HealScale s;
  s.file = "x.step", s.diameter = 1, s.tolerance = 1e-5, s.most_off_plane = 1e-3;
  return s;
}

heal::RawEdge edge(const Nurbs& curve, double height = 0) {
  heal::RawEdge result{curve, curve.poles.front(), curve.poles.back(), 3};
  result.height = height;
  return result;
}

heal::RawEdge line(Vec2 a, Vec2 b, double height = 0) { return edge(curve::segment(a, b), height); }

const std::vector<Region> plate = regions_of({{rectangle({0, 0}, {2, 1}), hole({0.5, 0.5}, 0.2)}});

size_t num_embedded(const heal::RawEdge& e, size_t num_warnings) {
  Report report;
  const size_t count = embedded_edges(plate, {e}, scale(), report).size();
  EXPECT_EQ(report.warnings().size(), num_warnings);
  for (const auto& warning : report.warnings()) {
    EXPECT_EQ(warning.code, warning::curves_ignored);
    EXPECT_EQ(warning.message, "x.step: ignored 1 curve beside the face");
  }
  return count;
}

TEST(InnerCurves, FreeEdgesInsideAreEmbeddedAndOthersAreIgnored) {
  EXPECT_EQ(num_embedded(line({1, 0.2}, {1.5, 0.8}), 0), 1U);
  EXPECT_EQ(num_embedded(line({0.7, 0.5}, {2, 0.5}), 0), 1U) << "from the hole to the outline";
  EXPECT_EQ(num_embedded(line({1, 0.5}, {2.5, 0.5}), 1), 0U) << "it leaves the face";
  EXPECT_EQ(num_embedded(line({0.1, 0.5}, {1, 0.5}), 1), 0U) << "across the hole";
  EXPECT_EQ(num_embedded(line({3, 0}, {3, 1}), 1), 0U);
  EXPECT_EQ(num_embedded(line({0.5, 0}, {1.5, 0}), 1), 0U) << "along the boundary";
  EXPECT_EQ(num_embedded(line({1, 0.2}, {1.5, 0.8}, 0.1), 1), 0U) << "in another plane";
}

TEST(InnerCurves, AreSplitAtTangentJumps) {
  const Nurbs bent{1, {0, 0, 1, 2, 2}, {{1, 0.2}, {1.5, 0.2}, {1.5, 0.8}}, {1, 1, 1}};
  EXPECT_EQ(num_embedded(edge(bent), 0), 2U);
}

TEST(InnerCurves, OfAFaceMustBeInsideIt) {
  EXPECT_EQ(inner_curves(plate[0], {line({1, 0.2}, {1.5, 0.8})}, scale()).size(), 1U);
  const std::string text = message_of<FormatError>([&] {
    inner_curves(plate[0], {line({1, 0.5}, {3, 0.5})}, scale());
  });
  EXPECT_EQ(
      text.rfind("x.step: face 0 'part0': edge 3, which bounds nothing, is not inside the face at (2.0625, 0.5)", 0),
      0U)
      << text;
}

std::string dangling(const Nurbs& curve, double most_slip = 1e-3) {
  return message_of<FormatError>([&] { refuse_dangling_ends(plate, {{curve, 3, ""}}, scale(), most_slip); });
}

TEST(InnerCurves, EndsJustBeforeACurveAreRefused) {
  const std::string text = dangling(curve::segment({1, 2e-4}, {1, 0.5}));
  EXPECT_EQ(text,
            "x.step: the curve of edge 3 ends at (1, 0.0002), 0.0002 before edge 0 (0.0002 diameters; the tolerance "
            "is 1e-05): give --heal-tolerance 0.00021");
  refuse_dangling_ends(plate, {{curve::segment({1, 2e-4}, {1, 0.5}), 3, ""}}, scale(), 1e-4);
  refuse_dangling_ends(plate, {{curve::segment({1, 5e-6}, {1, 0.5}), 3, ""}}, scale(), 1e-3);
  refuse_dangling_ends(plate, {{curve::segment({1, 0.1}, {1, 0.5}), 3, ""}}, scale(), 1e-3);
}

heal::RawFace face_with(const std::vector<heal::RawEdge>& wire) {
  heal::RawFace raw;
  raw.file = "x.step";
  raw.wires.emplace_back();
  for (const heal::LoopCurve& c : rectangle({0, 0}, {2, 1})) raw.wires[0].push_back(edge(c.curve));
  raw.wires.push_back(wire);
  return raw;
}

TEST(InnerCurves, AnOpenInnerWireBoundsNothing) {
  heal::RawFace raw = face_with({line({0.5, 0.5}, {1, 0.5}), line({1, 0.5}, {1, 0.8})});
  Report report;
  move_open_wires(raw, scale(), report);
  EXPECT_EQ(raw.wires.size(), 1U);
  EXPECT_EQ(raw.inner_edges.size(), 2U);
  ASSERT_EQ(report.warnings().size(), 1U);
  EXPECT_EQ(report.warnings()[0].code, warning::open_wire_embedded);
}

TEST(InnerCurves, AWireWithAGapIsNotOpen) {
  for (const double gap : {0.0, 2e-5, 0.05}) {
    heal::RawFace raw =
        face_with({line({0.5, 0.5}, {1, 0.5}), line({1, 0.5}, {1, 0.8}), line({1, 0.8}, {0.5, 0.5 + gap})});
    Report report;
    move_open_wires(raw, scale(), report);
    EXPECT_EQ(raw.wires.size(), 2U) << gap;
    EXPECT_TRUE(report.warnings().empty());
  }
}

}  // namespace

}  // namespace quadrille::sew
