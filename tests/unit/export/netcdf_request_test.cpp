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

TEST(NetcdfRequest, EveryMemberIsWritten) {
  NetcdfRequest request;
  request.add_dimension("x", 2);
  request.attributes = {{"title", "a mesh"}};
  request.variables = {{"coordinate", {0}, std::vector<float>{1.5F, 2}, {{"units", std::vector<double>{0.25}}}}};
  const NetcdfRequest read = netcdf_request(to_bytes(request));
  EXPECT_EQ(read.dimensions, request.dimensions);
  EXPECT_EQ(read.attributes.at(0).name, "title");
  EXPECT_EQ(std::get<std::string>(read.attributes.at(0).values), "a mesh");
  const NetcdfVariable& variable = read.variables.at(0);
  EXPECT_EQ(variable.name, "coordinate");
  EXPECT_EQ(variable.dimensions, std::vector<std::int32_t>{0});
  EXPECT_EQ(std::get<std::vector<float>>(variable.values), (std::vector<float>{1.5F, 2}));
  EXPECT_EQ(variable.attributes.at(0).name, "units");
  EXPECT_EQ(std::get<std::vector<double>>(variable.attributes.at(0).values), std::vector<double>{0.25});
}

}  // namespace
}  // namespace quadrille::exports
