#include "offset/offset_request.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace quadrille::offset {
namespace {

TEST(OffsetRequest, HasNamesAndADistance) {
  const std::vector<OffsetRequest> requests = offset_requests({"hole,a=b=0.5", "outer=1e-3"});
  ASSERT_EQ(requests.size(), 2U);
  EXPECT_EQ(requests[0].names, (std::vector<std::string>{"hole", "a=b"}));
  EXPECT_EQ(requests[0].distance, 0.5);
  EXPECT_EQ(requests[1].where, "--offset outer=1e-3");
}

TEST(OffsetRequest, MistakesAreUsageErrorsThatQuoteTheText) {
  for (const std::string text : {"hole", "=1", "hole=", "hole=x", "hole=0", "hole=-1", "hole=1x", "hole=inf", "a,,b=1"})
    try {
      offset_requests({text});
      ADD_FAILURE() << text << " was taken";
    } catch (const UsageError& error) {
      EXPECT_NE(std::string(error.what()).find("--offset " + text), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace quadrille::offset
