#include "io/step_origin.hpp"

#include <gtest/gtest.h>

#include "io/describe.hpp"
#include "io/history.hpp"

namespace quadrille::io {
namespace {

const ProvenanceStep made{
    "points2step", "1.0.0", {{"dat", "aa"}}, R"({"farfield":"cgrid:20","name":"a \"b\"","wake":"it's"})"};

/// A header whose description is the mark and `text`, in strings of at most 40 characters.
std::string step_file(const std::string& text, const std::string& mark = "Quadrille provenance") {
  std::string list = '\'' + mark + '\'';
  for (std::size_t i = 0; i < text.size(); i += 40) {
    list += ",\n'";
    for (const char c : text.substr(i, 40)) list += std::string(c == '\'' || c == '\\' ? 2 : 1, c);
    list += '\'';
  }
  return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((" + list + "),'2;1');\nENDSEC;\n";
}

TEST(StepOrigin, IsTheProvenanceOfTheHeader) {
  const Provenance origin = step_origin(step_file(provenance_text({made})));
  ASSERT_EQ(origin.size(), 1u);
  EXPECT_EQ(origin[0].tool, "points2step");
  EXPECT_EQ(origin[0].inputs[0].sha256, "aa");
  EXPECT_EQ(origin[0].options, made.options);
}

TEST(StepOrigin, IsEmptyForOtherFiles) {
  ProvenanceStep other = made;
  other.tool = "rm";
  for (const std::string& bytes :
       {std::string(), std::string("FILE_DESCRIPTION(("), std::string("FILE_DESCRIPTION(('Quadrille provenance','"),
        step_file(""), step_file("{"), step_file(provenance_text({made}), "Another program"),
        step_file(provenance_text({other})), step_file(provenance_text({made, made}))})
    EXPECT_TRUE(step_origin(bytes).empty()) << bytes;
}

TEST(StepOrigin, IsTheFirstCommandOfAHistory) {
  const ProvenanceStep read{"cad2tri", "1.0.0", {{"step", "ab"}}, "{}"};
  EXPECT_EQ(
      History().lines_of({made, read}, "ac", "d"),
      (std::vector<std::string>{"# d.dat: dat, SHA-256 aa",
                                "points2step --farfield=cgrid:20 --name='a \"b\"' --wake='it'\\''s' d.dat -o d.step",
                                "cad2tri d.step -o d.tri.h5"}));
}

}  // namespace
}  // namespace quadrille::io
