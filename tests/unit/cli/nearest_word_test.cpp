#include "cli/nearest_word.hpp"

#include <gtest/gtest.h>

namespace quadrille::cli {
namespace {

const std::vector<std::string> words{"--verbose", "--version", "--size", "--size-near", "--order"};

TEST(NearestWord, HasTheFewestErrors) {
  EXPECT_EQ(nearest_word("--verbos", words), "--verbose");
  EXPECT_EQ(nearest_word("--vresion", words), "--version");
  EXPECT_EQ(nearest_word("--sise", words), "--size");
  EXPECT_EQ(nearest_word("--orders", words), "--order");
}

TEST(NearestWord, ABeginningIsNear) {
  EXPECT_EQ(nearest_word("--vers", words), "--version");
  EXPECT_EQ(nearest_word("--size-n", words), "--size-near");
}

TEST(NearestWord, NothingIsNearToAnotherWord) {
  EXPECT_EQ(nearest_word("--no-such-option", words), "");
  EXPECT_EQ(nearest_word("-x", words), "");
  EXPECT_EQ(nearest_word("--size", {}), "");
}

}  // namespace
}  // namespace quadrille::cli
