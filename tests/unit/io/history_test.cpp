#include "io/history.hpp"

#include <gtest/gtest.h>

namespace quadrille::io {
namespace {

const ProvenanceStep read_cad{
    "cad2tri", "1.0.0", {{"step", "aa"}, {"boundary-names", "ab"}}, R"({"order":8,"list":false})"};
const ProvenanceStep solve{"fieldsolve", "1.0.0", {{"tri-mesh", "ac"}}, R"({"method":"cg"})"};
const ProvenanceStep adapt{"padapt", "1.0.0", {{"field", "ad"}}, "{}"};
const ProvenanceStep find{"critpoints", "1.0.0", {{"field", "ae"}}, R"({"corner-valence":["0:1=2","a b:c=1"]})"};

TEST(HistoryStem, IsTheNameUpToTheFirstDot) {
  EXPECT_EQ(history_stem("stages.d/half_disc.crit.json"), "half_disc");
  EXPECT_EQ(history_stem("disc"), "disc");
  EXPECT_EQ(history_stem("-"), "x");
}

TEST(History, HasACommandForEachStepAndACommentForEachOtherFile) {
  EXPECT_EQ(
      History().lines_of({read_cad, solve, adapt, find}, "af", "d"),
      (std::vector<std::string>{"# d.step: step, SHA-256 aa", "# d.boundary-names: boundary-names, SHA-256 ab",
                                "cad2tri --order=8 d.step --boundary-names d.boundary-names -o d.tri.h5",
                                "fieldsolve --method=cg d.tri.h5 -o d.solve.h5", "padapt d.solve.h5 -o d.field.h5",
                                "critpoints --corner-valence=0:1=2 --corner-valence='a b:c=1' d.field.h5 -o "
                                "d.crit.json"}));
}

TEST(History, KnowsTheFilesOfEarlierCallsByTheirDigests) {
  History history;
  history.lines_of({read_cad, solve, adapt, find}, "af", "d");
  const ProvenanceStep solve_phase{
      "fieldsolve", "1.0.0", {{"tri-mesh", "ac"}, {"field", "ae"}, {"critical-points", "af"}}, "{}"};
  const ProvenanceStep adapt_phase{"padapt", "1.0.0", {{"field", "ba"}}, "{}"};
  const ProvenanceStep trace{"separatrix", "1.0.0", {{"field", "bb"}, {"critical-points", "af"}}, R"({"step":null})"};
  EXPECT_EQ(history.lines_of({read_cad, solve_phase, adapt_phase, trace}, "bc", "d"),
            (std::vector<std::string>{"fieldsolve d.tri.h5 --orders d.field.h5 --nodes d.crit.json -o d.phase.solve.h5",
                                      "padapt d.phase.solve.h5 -o d.phase.h5",
                                      "separatrix d.phase.h5 d.crit.json -o d.sep.json"}));
}

TEST(History, StepsOfEarlierCallsAreNotRepeatedUnderAnotherStem) {
  History history;
  history.lines_of({read_cad, solve}, "ad", "d");
  EXPECT_EQ(history.lines_of({read_cad, solve, adapt}, "ae", "e"),
            (std::vector<std::string>{"padapt d.solve.h5 -o e.field.h5"}));
}

TEST(History, NoTwoFilesGetOneName) {
  History history;
  history.lines_of({read_cad, solve}, "ad", "d");
  const ProvenanceStep with_map{"fieldsolve", "1.0.0", {{"tri-mesh", "ac"}, {"order-map", "ca"}}, "{}"};
  const ProvenanceStep with_other{"fieldsolve", "1.0.0", {{"tri-mesh", "ac"}, {"order-map", "cb"}}, "{}"};
  EXPECT_EQ(history.lines_of({read_cad, with_map}, "cc", "d"),
            (std::vector<std::string>{"# d.orders.json: order-map, SHA-256 ca",
                                      "fieldsolve d.tri.h5 --orders d.orders.json -o d.2.solve.h5"}));
  EXPECT_EQ(history.lines_of({read_cad, with_other}, "cd", "d"),
            (std::vector<std::string>{"# d.2.orders.json: order-map, SHA-256 cb",
                                      "fieldsolve d.tri.h5 --orders d.2.orders.json -o d.3.solve.h5"}));
}

TEST(History, AFieldComesBeforeWhatHasItsOrders) {
  const ProvenanceStep with_field{"fieldsolve", "1.0.0", {{"tri-mesh", "ac"}, {"field", "ae"}}, "{}"};
  const std::vector<MadeFile> files = oldest_first(
      {{"e", "cc", {read_cad, with_field}}, {"d", "ae", {read_cad, solve, adapt}}, {"c", "af", {read_cad}}});
  EXPECT_EQ(files[0].path + files[1].path + files[2].path, "dec");
}

}  // namespace
}  // namespace quadrille::io
