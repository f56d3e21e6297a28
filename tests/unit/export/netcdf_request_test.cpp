#include "export/netcdf_request.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "export/writers.hpp"
#include "two_hexes.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

TEST(NetcdfRequest, ReadsBackWhatWasWritten) {
  for (const std::string& bytes : {exodus(two_quads(), upright_frame()).bytes, exodus(two_hexes({.order = 2})).bytes}) {
    const NetcdfRequest request = netcdf_request(bytes);
    EXPECT_FALSE(request.dimensions.empty() || request.attributes.empty() || request.variables.empty());
    EXPECT_EQ(to_bytes(request), bytes);
    EXPECT_THROW(netcdf_request(bytes.substr(0, bytes.size() - 1)), Defect);
    EXPECT_THROW(netcdf_request(bytes + "x"), Defect);
  }
}

}  // namespace
}  // namespace quadrille::exports
