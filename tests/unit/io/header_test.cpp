#include <gtest/gtest.h>

#include "../support/texts.hpp"
#include "base/error.hpp"
#include "io/describe.hpp"

namespace quadrille::io {
namespace {

constexpr StageFormat thing{"thing", 3, 1, Storage::json};

std::string refusal(const std::string& format, const std::vector<int>& version) {
  return message_of<FormatError>([&] { require_version("file", thing, format, version); });
}

TEST(Header, ThePresentMajorVersionIsReadWithAnyMinorAndNoOther) {
  EXPECT_EQ(refusal("thing", {3, 0}), "");
  EXPECT_EQ(refusal("thing", {3, 99}), "");
  EXPECT_NE(refusal("thing", {2, 7}), "");
  EXPECT_NE(refusal("thing", {4, 0}), "");
}

TEST(Header, OlderAndNewerVersionsGetSentencesOfTheirOwn) {
  EXPECT_EQ(refusal("thing", {2, 7}),
            "file: thing version 2.7 is from an older program and no longer read (this one reads version 3); "
            "create the file again");
  EXPECT_EQ(refusal("thing", {4, 0}),
            "file: thing version 4.0 is newer than this program, which reads version 3; update it");
}

TEST(Header, AnotherFormatAndAMistypedVersionAreNamed) {
  EXPECT_EQ(refusal("sonnet", {1, 0}), "file: expected a thing file, found a sonnet file");
  EXPECT_EQ(refusal("", {1, 0}), "file: expected a thing file, found a file without a format");
  for (const std::vector<int>& version : std::vector<std::vector<int>>{{}, {1}, {1, 0, 0}, {-1, 0}, {1, -1}})
    EXPECT_EQ(refusal("thing", version), "file: 'version' must be [major, minor]");
}

TEST(Header, ProvenanceSurvivesItsText) {
  const Provenance chain{{"cad2tri", "0.1.0", {{"step", "abc"}}, R"({"order":8})"}, {"fieldsolve", "0.2.0", {}, "{}"}};
  const std::string text = provenance_text(chain);
  EXPECT_EQ(text.find('\n'), std::string::npos);
  const Provenance read = parse_provenance(text, "file");
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].inputs[0].sha256, "abc");
  EXPECT_EQ(read[0].options, R"({"order":8})");
  EXPECT_EQ(producer_of(read), "fieldsolve 0.2.0");
  EXPECT_EQ(producer_of({}), "Quadrille");
}

TEST(Header, DamagedProvenanceIsRefusedWithItsPlace) {
  try {
    parse_provenance(R"({"provenance": [{"tool": 3}]})", "file");
    FAIL();
  } catch (const FormatError& e) {
    EXPECT_STREQ(e.what(), "file: attribute 'provenance': 'provenance[0].tool' must be a string");
  }
}

// stagecheck --history prints commands and names of files from these.
TEST(Header, ProvenanceWithWordsForAShellIsRefused) {
  const char* const hostile[] = {
      R"({"tool": "cad2tri; x", "version": "1", "inputs": [], "options": {}})",
      R"({"tool": "cad2tri", "version": "1\nx", "inputs": [], "options": {}})",
      R"({"tool": "cad2tri", "version": "1", "inputs": [{"format": "step\nx #", "sha256": "0"}], "options": {}})",
      R"({"tool": "cad2tri", "version": "1", "inputs": [{"format": "step", "sha256": "0\u001b"}], "options": {}})",
      R"({"tool": "cad2tri", "version": "1", "inputs": [], "options": {"size; x #": 1}})"};
  for (const char* step : hostile)
    EXPECT_THROW(parse_provenance(R"({"provenance": [)" + std::string(step) + "]}", "file"), FormatError) << step;
}

}  // namespace
}  // namespace quadrille::io
