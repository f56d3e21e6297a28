#pragma once
// What quadexport asks of quadexport-netcdf, which is linked with the netCDF library: a file as its dimensions,
// attributes and variables, the data model of NetCDF's classic format, and these structs as bytes.

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace quadrille::exports {

/// NC_CHAR, NC_INT, NC_FLOAT, NC_DOUBLE.
using NetcdfValues = std::variant<std::string, std::vector<std::int32_t>, std::vector<float>, std::vector<double>>;

struct NetcdfAttribute {
  std::string name;
  NetcdfValues values;
};

struct NetcdfVariable {
  std::string name;
  std::vector<std::int32_t> dimensions;  ///< their numbers; the last one varies fastest
  NetcdfValues values;                   ///< as many as the product of the dimensions
  std::vector<NetcdfAttribute> attributes = {};
};

struct NetcdfRequest {
  /// Names and sizes. Size 0: the record dimension, of which the file has no record; one at most.
  std::vector<std::pair<std::string, std::int64_t>> dimensions;
  std::vector<NetcdfAttribute> attributes;
  std::vector<NetcdfVariable> variables;

  /// Adds a dimension and returns its number.
  std::int32_t add_dimension(std::string name, std::size_t size) {
    dimensions.emplace_back(std::move(name), static_cast<std::int64_t>(size));
    return static_cast<std::int32_t>(dimensions.size()) - 1;
  }
};

std::string to_bytes(const NetcdfRequest& request);

/// Throws Defect if the bytes are not those of a request.
NetcdfRequest netcdf_request(const std::string& bytes);

}  // namespace quadrille::exports
