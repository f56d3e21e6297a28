#include "base/option_record.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace quadrille {

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

TEST(OptionRecord, NumbersReadBackToTheSameBitsAndOthersAreNull) {
  double size = 0.1, limit = std::numeric_limits<double>::infinity();
  OptionRecord record;
  record.number("--size", size, 0, 1, "length", "");
  record.number("--limit", limit, 0, 1, "length", "");
  EXPECT_EQ(record.json(), R"({"limit":null,"size":0.10000000000000001})");
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
