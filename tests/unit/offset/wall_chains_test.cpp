#include "offset/wall_chains.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "faces.hpp"

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

using namespace testing_faces;

std::vector<WallChain> chains_of(const CadFace& face, const std::vector<std::string>& options) {
  return wall_chains(face, offset_requests(options), std::vector<bool>(face.curves.size(), false));
}

TEST(WallChains, ConsecutiveWallsAreOneChain) {
  const std::vector<WallChain> chains = chains_of(plate(), {"side_3,side_0=0.1", "side_2=0.2"});
  ASSERT_EQ(chains.size(), 1U);
  EXPECT_EQ(chains[0].curves, (std::vector<int>{2, 3, 0}));
  EXPECT_EQ(chains[0].distances, (std::vector<double>{0.2, 0.1, 0.1}));
  EXPECT_FALSE(chains[0].is_closed);
}

TEST(WallChains, AHoleIsAClosedChain) {
  const std::vector<WallChain> chains = chains_of(plate_with_hole(), {"side_4=0.1"});
  ASSERT_EQ(chains.size(), 1U);
  EXPECT_EQ(chains[0].curves, std::vector<int>{4});
  EXPECT_TRUE(chains[0].is_closed);
}

TEST(WallChains, GoOnAlongNeighboursThatMeetTheWallAtAnObtuseAngle) {
  const std::vector<WallChain> chains = chains_of(l_shape(), {"side_2=0.1"});
  ASSERT_EQ(chains.size(), 1U);
  EXPECT_EQ(chains[0].curves, (std::vector<int>{2, 3})) << "270 degrees";
}

TEST(WallChains, DifferentDistancesAlongOneWallAreRefused) {
  CadFace face = hand_made::face({polygon({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {0, 1}})}, 3);
  EXPECT_THROW(chains_of(face, {"side_0=0.1", "side_1=0.2"}), UsageError) << "they continue each other";
  EXPECT_THROW(chains_of(face, {"side_0=0.1", "side_2=0.2"}), UsageError) << "both go on along side 1";
  EXPECT_EQ(chains_of(face, {"side_0=0.1", "side_2=0.1"}).size(), 1U);
}

TEST(WallChains, UnknownAndRepeatedNamesAreRefused) {
  EXPECT_THROW(chains_of(plate(), {"hole=0.1"}), UsageError);
  EXPECT_THROW(chains_of(plate(), {"side_0=0.1", "side_0=0.1"}), UsageError);
}

}  // namespace

}  // namespace quadrille::offset
