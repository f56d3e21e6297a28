#include "cli/option_values.hpp"

#include <gtest/gtest.h>

#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille::cli {
namespace {

TEST(NumberWithin, ReadsAllOfTheTextAndChecksTheInterval) {
  EXPECT_EQ(number_within("--size", "+2.5e-1", 0, 1), 0.25);
  EXPECT_EQ(message_of<UsageError>([] { number_within("--size", "1x", 0, 1); }), "--size: '1x' is not a number");
  EXPECT_EQ(message_of<UsageError>([] { number_within("--size", "2", 0, 1); }),
            "--size: 2 is outside its interval (0 to 1)");
  for (const char* text : {"", "+", "+-1", " 1", "nan"}) EXPECT_THROW(number_within("--size", text, -9, 9), UsageError);
}

TEST(IntegerWithin, ReadsAllOfTheTextAndChecksTheInterval) {
  EXPECT_EQ(integer_within("--order", "+7", 1, 20), 7);
  EXPECT_EQ(message_of<UsageError>([] { integer_within("--order", "2.5", 1, 20); }),
            "--order: '2.5' is not an integer");
  EXPECT_EQ(message_of<UsageError>([] { integer_within("--order", "21", 1, 20); }),
            "--order: 21 is outside its interval (1 to 20)");
  EXPECT_THROW(integer_within("--order", "99999999999", 1, 20), UsageError);
}

TEST(ThreadsOf, AreANumberOrAutomatic) {
  EXPECT_EQ(threads_of("auto"), 0);
  EXPECT_EQ(threads_of("1"), 1);
  EXPECT_EQ(threads_of("1024"), 1024);
  for (const char* text : {"0", "1025", "two", "", "1.5"}) EXPECT_THROW(threads_of(text), UsageError) << text;
}

}  // namespace
}  // namespace quadrille::cli
