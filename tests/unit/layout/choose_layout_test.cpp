#include "layout/choose_layout.hpp"

#include <gtest/gtest.h>

#include <variant>

#include "../hand_made.hpp"

namespace quadrille::layout {
namespace {

/// Computations with known results, and how often they were called.
struct Computations {
  LayoutAttempt traced, quantized, crowded = {};
  int num_traced = 0, num_quantized = 0, num_crowded = 0, num_midpoint = 0;
  Report report = {};

  ChosenLayout choose(int num_separatrices = 10) {
    const LayoutComputations compute{[this](Report&) {
                                       ++num_traced;
                                       return traced;
                                     },
                                     [this](Report& r) {
                                       ++num_quantized;
                                       r.set("quantize.faces", 7);
                                       return quantized;
                                     },
                                     [this](Report&) {
                                       ++num_crowded;
                                       return crowded;
                                     },
                                     [this](Report&) {
                                       ++num_midpoint;
                                       return graph::candidate_layout(hand_made::cut_annulus(5));
                                     }};
    return choose_layout(num_separatrices, compute, report);
  }
  bool has(const std::string& key) const {
    for (const auto& [name, value] : report.entries())
      if (name == key) return true;
    return false;
  }
};

LayoutAttempt none(const std::string& reason) { return {std::nullopt, reason}; }

// Blocks between two circles. With as many lines as blocks there are few.
LayoutAttempt annulus(int num_blocks, int num_lines) {
  SeparatrixGraph graph = hand_made::cut_annulus(num_blocks);
  graph.lines.resize(num_lines);
  return {graph::candidate_layout(std::move(graph)), ""};
}

TEST(ChooseLayout, ATracedLayoutOfFewBlocksIsTakenAtOnce) {
  Computations c{annulus(6, 6), annulus(4, 4)};
  const ChosenLayout chosen = c.choose();
  EXPECT_EQ(chosen.method, LayoutMethod::traced);
  EXPECT_EQ(chosen.warning, "");
  EXPECT_EQ(chosen.layout.certificate.reason, "");
  EXPECT_EQ(c.num_quantized, 0);
  EXPECT_FALSE(c.has("layout.reason"));
}

TEST(ChooseLayout, AQuantizedLayoutOfFewerBlocksIsPreferredToManyTracedOnes) {
  Computations c{annulus(6, 4), annulus(4, 4)};
  const ChosenLayout chosen = c.choose();
  EXPECT_EQ(chosen.method, LayoutMethod::quantized);
  EXPECT_EQ(chosen.warning, "");
  EXPECT_EQ(chosen.layout.certificate.reason,
            "4 separatrices that are followed to their ends make 6 blocks, 4 will do");
  EXPECT_TRUE(c.has("quantize.faces"));
  EXPECT_TRUE(c.has("layout.reason"));
}

TEST(ChooseLayout, ATracedLayoutOfManyBlocksStaysWhereTheOtherHasNoFewer) {
  for (const LayoutAttempt& quantized : {annulus(6, 4), annulus(7, 4), none("no lengths")}) {
    Computations c{annulus(6, 4), quantized};
    EXPECT_EQ(c.choose().method, LayoutMethod::traced);
    EXPECT_EQ(c.num_quantized, 1);
    EXPECT_FALSE(c.has("quantize.faces"));  // of a layout that was not taken
  }
}

TEST(ChooseLayout, WithoutATracedLayoutTheQuantizedOneIsTakenWithAWarning) {
  Computations c{none("a spiral"), annulus(4, 4)};
  const ChosenLayout chosen = c.choose();
  EXPECT_EQ(chosen.method, LayoutMethod::quantized);
  EXPECT_EQ(chosen.layout.certificate.reason, "a spiral");
  EXPECT_EQ(chosen.warning.find("a spiral: "), 0u);
  EXPECT_EQ(c.num_midpoint, 0);
}

TEST(ChooseLayout, TooManySeparatricesAreNotTraced) {
  Computations c{annulus(6, 6), annulus(4, 4)};
  const ChosenLayout chosen = c.choose(501);
  EXPECT_EQ(c.num_traced, 0);
  EXPECT_EQ(chosen.layout.certificate.reason, "501 separatrices are too many to be followed to their ends");
  Computations fewer{annulus(6, 6), annulus(4, 4)};
  fewer.choose(500);
  EXPECT_EQ(fewer.num_traced, 1);
}

TEST(ChooseLayout, WithoutAnyLayoutTrianglesAreDividedAndBothReasonsAreNamed) {
  for (const int num_separatrices : {10, 501}) {
    Computations c{none("a spiral"), none("no lengths")};
    const ChosenLayout chosen = c.choose(num_separatrices);
    EXPECT_EQ(chosen.method, LayoutMethod::midpoint);
    EXPECT_EQ(chosen.layout.subdivision.num_faces(), 5);
    const std::string& reason = chosen.layout.certificate.reason;
    EXPECT_NE(reason.find(num_separatrices == 10 ? "a spiral" : "501 separatrices"), std::string::npos) << reason;
    EXPECT_NE(reason.find("no lengths"), std::string::npos) << reason;
    EXPECT_EQ(chosen.warning.find(reason + ": "), 0u) << chosen.warning;
  }
}

TEST(ChooseLayout, CrowdedLinesAreFollowedAllTheSameWhereNothingElseExists) {
  for (const int num_separatrices : {10, 501}) {
    Computations c{{std::nullopt, "2001 arcs", true}, none("no lengths"), annulus(6, 4)};
    const ChosenLayout chosen = c.choose(num_separatrices);
    EXPECT_EQ(chosen.method, LayoutMethod::traced);
    EXPECT_EQ(chosen.layout.subdivision.num_faces(), 6);
    EXPECT_NE(chosen.layout.certificate.reason.find("; stopped where they meet: no lengths"), std::string::npos);
    EXPECT_EQ(chosen.warning.find(chosen.layout.certificate.reason + ": "), 0u);
    EXPECT_EQ(c.num_midpoint, 0);
  }
  Computations with_quantized{{std::nullopt, "2001 arcs", true}, annulus(4, 4), annulus(6, 4)};
  EXPECT_EQ(with_quantized.choose().method, LayoutMethod::quantized);
  EXPECT_EQ(with_quantized.num_crowded, 0);
  Computations spiral{none("a spiral"), none("no lengths"), annulus(6, 4)};
  EXPECT_EQ(spiral.choose().method, LayoutMethod::midpoint);
  EXPECT_EQ(spiral.num_crowded, 0);
}

TEST(ChooseLayout, AReasonThatIsTheSameForBothIsNamedOnce) {
  Computations c{none("a corner of valence 0"), none("a corner of valence 0")};
  EXPECT_EQ(c.choose().layout.certificate.reason, "a corner of valence 0");
}

TEST(ChooseLayout, ManyBlocksAreMoreThanAFifthAboveTheLeast) {
  EXPECT_FALSE(has_many_blocks(12, 9, 1));
  EXPECT_TRUE(has_many_blocks(13, 9, 1));
}

TEST(ChooseLayout, AWorseOrInvalidLayoutIsNotPreferable) {
  const LayoutQuality traced{10, true, 0.8};
  EXPECT_TRUE(is_preferable({9, true, 0.8}, traced));
  EXPECT_TRUE(is_preferable({9, true, 0.8 - 0.9e-6}, traced));
  EXPECT_FALSE(is_preferable({9, true, 0.8 - 1.1e-6}, traced));
  EXPECT_FALSE(is_preferable({9, false, 0.9}, traced));
  EXPECT_FALSE(is_preferable({10, true, 0.9}, traced));
}

TEST(ChooseLayout, CrowdedLinesReplaceAPoorLayoutOnlyIfTheirBlocksAreBetter) {
  const LayoutQuality quantized{10, true, 0.06};
  EXPECT_TRUE(is_better_shaped({100, true, 0.5}, quantized));
  EXPECT_FALSE(is_better_shaped({100, true, 0.05}, quantized));
  EXPECT_FALSE(is_better_shaped({100, false, 0.5}, quantized));
  EXPECT_TRUE(is_better_shaped({100, true, 0.01}, {10, false, 0.06}));
}

}  // namespace
}  // namespace quadrille::layout
