#include <gtest/gtest.h>

#include <string>

#include "../support/texts.hpp"
#include "base/error.hpp"
#include "io/hdf5_archive.hpp"

namespace quadrille::io {
namespace {

/// A record with a member of each kind, records inside it too.
struct Branch {
  int leaves = 0;
  std::vector<double> lengths;
};
struct Tree {
  int number = 0;
  Vec2 place;
  bool is_tall = false;
  std::string name;
  std::vector<int> rings;
  std::vector<Vec2> shadow;
  std::vector<std::string> birds;
  std::vector<Branch> branches;
};

void describe(Archive& archive, Branch& branch) {
  archive.field("leaves", branch.leaves);
  archive.field("lengths", branch.lengths);
}
void describe(Archive& archive, Tree& tree) {
  archive.field("number", tree.number);
  archive.field("place", tree.place, {"length", "position"});
  archive.field("is_tall", tree.is_tall);
  archive.field("name", tree.name);
  archive.field("rings", tree.rings);
  archive.field("shadow", tree.shadow);
  archive.field("birds", tree.birds);
  archive.field("branches", tree.branches, [](Archive& a, Branch& b) { describe(a, b); });
}

std::string image_of(std::vector<Tree> trees) {
  Hdf5Writer writer;
  Tree empty;
  write_columns(writer.root(), "trees", trees.size(),
                [&](Archive& archive, std::size_t i) { describe(archive, i == Archive::declared ? empty : trees[i]); });
  return writer.image();
}

std::vector<Tree> read(const std::string& image) {
  const Hdf5Reader reader(image, "sample.h5");
  std::vector<Tree> trees;
  read_columns(
      reader.root(), "trees", [&](std::size_t count) { trees.resize(count); },
      [&](Archive& archive, std::size_t i) { describe(archive, trees[i]); });
  return trees;
}

std::vector<Tree> two_trees() {
  return {{7, {1, 2}, true, "oak", {1, 2, 3}, {{0, 1}}, {}, {{4, {0.5}}, {0, {}}}},
          {-1, {3, 4}, false, "", {}, {{5, 6}, {7, 8}}, {"owl", "jay"}, {}}};
}

TEST(Hdf5Columns, RecordsReadBackAsTheyWereWritten) {
  const std::vector<Tree> trees = read(image_of(two_trees()));
  ASSERT_EQ(trees.size(), 2u);
  const std::vector<Tree> expected = two_trees();
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(trees[i].number, expected[i].number);
    EXPECT_EQ(trees[i].place, expected[i].place);
    EXPECT_EQ(trees[i].is_tall, expected[i].is_tall);
    EXPECT_EQ(trees[i].name, expected[i].name);
    EXPECT_EQ(trees[i].rings, expected[i].rings);
    EXPECT_EQ(trees[i].shadow, expected[i].shadow);
    EXPECT_EQ(trees[i].birds, expected[i].birds);
    ASSERT_EQ(trees[i].branches.size(), expected[i].branches.size());
  }
  EXPECT_EQ(trees[0].branches[0].leaves, 4);
  EXPECT_EQ(trees[0].branches[0].lengths, std::vector<double>{0.5});
  EXPECT_TRUE(trees[0].branches[1].lengths.empty());
}

TEST(Hdf5Columns, EveryMemberIsADatasetOfAllRecords) {
  const std::string image = image_of(two_trees());
  const Hdf5Reader reader(image, "sample.h5");
  const Hdf5GroupReader group = reader.root().group("trees");
  EXPECT_EQ(group.integer_attribute("count"), std::vector<int>{2});
  EXPECT_EQ(group.integers("number", 1), (std::vector<int>{7, -1}));
  EXPECT_EQ(group.reals("place", 2), (std::vector<double>{1, 2, 3, 4}));
  EXPECT_EQ(group.integers("is_tall", 1), (std::vector<int>{1, 0}));
  EXPECT_EQ(group.integers("rings", 1), (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(group.integers("rings_offsets", 1), (std::vector<int>{0, 3, 3}));
  EXPECT_EQ(group.integers("shadow_offsets", 1), (std::vector<int>{0, 1, 3})) << "in rows, not in numbers";
  EXPECT_EQ(group.integers("branches_offsets", 1), (std::vector<int>{0, 2, 2}));
  EXPECT_EQ(group.group("branches").integers("leaves", 1), (std::vector<int>{4, 0}));
  EXPECT_EQ(group.group("branches").integers("lengths_offsets", 1), (std::vector<int>{0, 1, 1}));
}

TEST(Hdf5Columns, NoRecordsAreColumnsWithoutRows) {
  const std::string image = image_of({});
  EXPECT_TRUE(read(image).empty());
  const Hdf5Reader reader(image, "sample.h5");
  const Hdf5GroupReader group = reader.root().group("trees");
  for (const char* name : {"number", "place", "is_tall", "name", "rings", "shadow", "birds", "branches"})
    EXPECT_TRUE(group.has(name)) << name;
  EXPECT_EQ(group.integers("rings_offsets", 1), std::vector<int>{0});
  EXPECT_TRUE(group.group("branches").has("leaves"));
}

TEST(Hdf5Columns, TheSameRecordsAreTheSameBytes) { EXPECT_EQ(image_of(two_trees()), image_of(two_trees())); }

// ---- Damaged groups

/// A group of two records of a number and a ragged list, each part as given.
std::string damaged(int count, const std::vector<int>& numbers, const std::vector<int>& offsets,
                    const std::vector<int>& values) {
  Hdf5Writer writer;
  {
    const Hdf5GroupWriter group = writer.root().group("trees");
    group.integer_attribute("count", {count});
    group.integers("number", numbers.data(), {numbers.size()}, "", "");
    group.integers("rings_offsets", offsets.data(), {offsets.size()}, "", "");
    group.integers("rings", values.data(), {values.size()}, "", "");
  }
  return writer.image();
}

std::string refusal(const std::string& image) {
  const Hdf5Reader reader(image, "sample.h5");
  std::vector<Tree> trees;
  return message_of<FormatError>([&] {
    read_columns(
        reader.root(), "trees", [&](std::size_t count) { trees.resize(count); },
        [&](Archive& archive, std::size_t i) {
          archive.field("number", trees[i].number);
          archive.field("rings", trees[i].rings);
        });
  });
}

TEST(Hdf5Columns, RowsThatDoNotFitTheCountAreRefusedByName) {
  EXPECT_EQ(refusal(damaged(2, {1, 2}, {0, 1, 2}, {5, 6})), "");
  const std::string message = refusal(damaged(3, {1, 2}, {0, 1, 2, 2}, {5, 6}));
  EXPECT_NE(message.find("number"), std::string::npos) << message;
  EXPECT_NE(message.find("has 2 rows where the group's count is 3"), std::string::npos) << message;
  EXPECT_NE(message.find("sample.h5"), std::string::npos) << message;
}

TEST(Hdf5Columns, ACountThatIsNoCountIsRefused) {
  EXPECT_NE(refusal(damaged(-1, {}, {0}, {})).find("not negative"), std::string::npos);
}

TEST(Hdf5Columns, AGreatCountAllocatesNothingBeforeItsRowsWereSeen) {
  EXPECT_NE(refusal(damaged(2000000000, {1, 2}, {0, 1, 2}, {5, 6})).find("has 2 rows"), std::string::npos);
}

TEST(Hdf5Columns, OffsetsMustRiseFromZeroToTheNumberOfValues) {
  for (const std::vector<int>& offsets :
       {std::vector<int>{0, 2}, {0, 1, 2, 2}, {1, 1, 2}, {0, 2, 1}, {0, 1, 3}, {0, 1, 1}, {0, -1, 2}}) {
    const std::string message = refusal(damaged(2, {1, 2}, offsets, {5, 6}));
    EXPECT_NE(message.find("rings_offsets"), std::string::npos) << message;
    EXPECT_NE(message.find("must increase from 0 to 2 in 3 entries"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace quadrille::io
