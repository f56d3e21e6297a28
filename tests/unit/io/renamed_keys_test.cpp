#include "io/renamed_keys.hpp"

#include <gtest/gtest.h>

#include "../samples.hpp"
#include "../support/test_data.hpp"
#include "base/error.hpp"
#include "io/json_archive.hpp"
#include "io/stage_files.hpp"
#include "scratch.hpp"

namespace quadrille::io {
namespace {

constexpr RenamedKey renamed[] = {
    {"size", "length"}, {"outer", "box"}, {"outer.size", "width"}, {"list.size", "extent"}};

/// What a description with present names reads from an object with former ones.
struct Content {
  int size = 0, outer_size = 0, outer_other = 0;
  std::vector<int> list;
  bool has_size = false, has_length = false;
};

Content read(const std::string& text) {
  Content content;
  JsonReader reader(text, "file");
  describe_with_former_names(reader.root(), renamed, [&](Archive& a) {
    content.has_size = a.has("size");
    content.has_length = a.has("length");
    a.field("size", content.size);
    a.object("outer", [&](Archive& b) {
      b.field("size", content.outer_size);
      b.field("other", content.outer_other);
    });
    a.field("list", content.list, [](Archive& b, int& value) { b.field("size", value); });
  });
  return content;
}

TEST(RenamedKeys, AreReadByTheirFormerNamesEachInItsPlace) {
  const Content content =
      read(R"({"length": 1, "size": 9, "box": {"width": 2, "other": 3, "size": 9}, "list": [{"extent": 4}]})");
  EXPECT_EQ(content.size, 1);
  EXPECT_EQ(content.outer_size, 2);
  EXPECT_EQ(content.outer_other, 3);
  EXPECT_EQ(content.list, std::vector<int>{4});
  EXPECT_TRUE(content.has_size) << "by its former name";
  EXPECT_TRUE(content.has_length) << "another member of that name, or none";
}

TEST(RenamedKeys, PresentNamesAreMissingAndTheMessageNamesTheFormerOne) {
  try {
    read(R"({"length": 1, "box": {"size": 2, "other": 3}, "list": []})");
    FAIL();
  } catch (const FormatError& e) {
    EXPECT_STREQ(e.what(), "file: 'box.width' is missing");
  }
}

class PreviousMajor : public Scratch {
 protected:
  /// Reading a stored file of the previous version and writing it gives the bytes of the present sample.
  template <typename Stage, typename Read>
  void expect_present(const std::string& stored, const Stage& sample, const Read& read) {
    write_stage(path("read"), read(read_input(test_data() + "/../formats/" + stored)));
    write_stage(path("sample"), sample);
    EXPECT_EQ(bytes_of("read"), bytes_of("sample"));
  }
};

TEST_F(PreviousMajor, SeparatrixGraph) {
  SeparatrixGraph sample = samples::separatrix_graph();
  sample.face.fit_distance = 0;  // a later key
  expect_present("separatrix_graph/passed/version-1.1.sep.json", sample, read_separatrix_graph);
}

TEST_F(PreviousMajor, CriticalPoints) {
  CriticalPoints points = samples::resolved_points();
  expect_present("critical_points/passed/version-1.2.crit.json", points, read_critical_points);
}

TEST_F(PreviousMajor, OffsetsOfCriticalPoints) {
  const std::string text =
      R"({"format": "critical-points", "version": [1, 2], "producer": "an editor", "provenance": [],
    "origin": [0, 0], "form": "phase", "critical_points": [], "corners": [], "twist_offsets": [1, -2],
    "index_sum": {"expected": 0}})";
  EXPECT_EQ(read_critical_points({{"file", ""}, text}).hole_winding_offsets, (std::vector<int>{1, -2}));
}

TEST_F(PreviousMajor, Field) {
  Field sample = samples::phase_field();
  sample.mesh.face.fit_distance = 0;  // a later key
  expect_present("field/passed/version-1.2.field.h5", sample, read_field);
}

}  // namespace
}  // namespace quadrille::io
