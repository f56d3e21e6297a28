#include "base/options.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille {

namespace option_samples {

struct Shape {
  double width = 1;
  int sides = 4;
};

void declare(Options& options, Shape& shape) {
  options.number("--width", shape.width, 0, 2, "length", "its width");
  options.integer("--sides", shape.sides, 3, 6, "number of its sides");
}

}  // namespace option_samples

namespace record_samples {

struct Shape {
  double width = 0.1;
  std::string name;
};

void declare(Options& options, Shape& shape) {
  options.number("--width", shape.width, 0, 2, "length", "its width");
  options.text("--name", shape.name, "NAME", "its name");
}

}  // namespace record_samples

namespace {

TEST(IntervalText, NamesTheBoundsThatThereAre) {
  EXPECT_EQ(interval_text(0.5, 20.0), "0.5 to 20");
  EXPECT_EQ(interval_text(0.0, 1e300), "at least 0");
  EXPECT_EQ(interval_text(-1e300, 3.0), "at most 3");
  EXPECT_EQ(interval_text(-1e300, 1e300), "any number");
  EXPECT_EQ(interval_text(1, 20), "1 to 20");
  EXPECT_EQ(interval_text(1, std::numeric_limits<int>::max()), "at least 1");
}

TEST(RequireInInterval, RefusesNumbersOutsideAndTextsThatAreNone) {
  EXPECT_NO_THROW(require_in_interval("--width", 0.0, "0", 0.0, 2.0));
  EXPECT_NO_THROW(require_in_interval("--width", 2.0, "2", 0.0, 2.0));
  EXPECT_EQ(message_of<UsageError>([] { require_in_interval("--width", 2.5, "2.50", 0.0, 2.0); }),
            "--width: 2.50 is outside its interval (0 to 2)");
  EXPECT_THROW(require_in_interval("--width", std::nan(""), "nan", 0.0, 2.0), UsageError);
  EXPECT_EQ(message_of<UsageError>([] { require_in_interval("--sides", 2, "2", 3, 6); }),
            "--sides: 2 is outside its interval (3 to 6)");
}

TEST(RequireIntervals, ChecksEachNumberOfAStruct) {
  EXPECT_NO_THROW(require_intervals(option_samples::Shape{}));
  EXPECT_EQ(message_of<UsageError>([] {
              require_intervals(option_samples::Shape{-0.5, 4});
            }),
            "--width: -0.5 is outside its interval (0 to 2)");
  EXPECT_EQ(message_of<UsageError>([] {
              require_intervals(option_samples::Shape{1, 7});
            }),
            "--sides: 7 is outside its interval (3 to 6)");
}

TEST(OptionRecord, WritesEachKindOfOptionBySortedNames) {
  double size = 0.5;
  int order = 4;
  bool is_loud = true;
  std::string name = "a \"b\"", mode = "fast";
  std::vector<std::string> parts{"2:1", "3:4"};
  OptionRecord record;
  record.number("--size", size, 0, 1, "length", "");
  record.integer("--order", order, 1, 9, "");
  record.flag("--loud", is_loud, "");
  record.text("-n,--name", name, "NAME", "", true);
  record.texts("--part", parts, "A:B", "", true);
  record.choice("--mode", mode, {"fast", "slow"}, "");
  EXPECT_EQ(record.json(), R"({"loud":true,"mode":"fast","name":"a \"b\"","order":4,"part":["2:1","3:4"],"size":0.5})");
  order = 7;
  mode = "slow";
  EXPECT_NE(record.json().find(R"("mode":"slow","name")"), std::string::npos) << "the present values";
  EXPECT_NE(record.json().find(R"("order":7)"), std::string::npos);
}

TEST(OptionRecord, ANumberThatIsNotGivenIsNullAndHasNoInterval) {
  std::optional<double> scale;
  OptionRecord record;
  record.optional_number("--scale", scale, 1, 2, "factor", "");
  EXPECT_EQ(record.json(), R"({"scale":null})");
  IntervalCheck check;
  check.optional_number("--scale", scale, 1, 2, "factor", "");
  scale = 2.5;
  EXPECT_EQ(record.json(), R"({"scale":2.5})");
  EXPECT_THROW(check.optional_number("--scale", scale, 1, 2, "factor", ""), UsageError);
}

TEST(OptionRecord, NumbersReadBackToTheSameBitsAndOthersAreNull) {
  double size = 0.1, small = 1e-16, whole = 2, limit = std::numeric_limits<double>::infinity();
  OptionRecord record;
  record.number("--size", size, 0, 1, "length", "");
  record.number("--small", small, 0, 1, "length", "");
  record.number("--whole", whole, 0, 1, "length", "");
  record.number("--limit", limit, 0, 1, "length", "");
  EXPECT_EQ(record.json(), R"({"limit":null,"size":0.1,"small":1e-16,"whole":2})") << "as stage files have them";
}

TEST(OptionRecord, LeavesOutWhatIsNotRecorded) {
  std::string input, output;
  std::vector<std::string> none, others;
  OptionRecord record;
  record.text("--threads", input, "N", "", false);
  record.output_file("--write", output, "");
  record.texts("--part", none, "A:B", "", false);
  EXPECT_EQ(record.json(), "{}");
  record.texts("--other", others, "A:B", "", true);
  EXPECT_EQ(record.json(), R"({"other":[]})");
}

TEST(RecordedOptions, AreThoseThatAStructDeclares) {
  EXPECT_EQ(recorded_options(record_samples::Shape{1.5, "hole"}), R"({"name":"hole","width":1.5})");
}

}  // namespace

}  // namespace quadrille
