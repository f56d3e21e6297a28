#pragma once
// A file in NetCDF's classic format with 64-bit offsets (CDF-2): dimensions, attributes and variables, big-endian, as
// the NetCDF User's Guide, appendix "File Format Specifications", lists them. It needs no library: the header is a few
// lists, the data follow in the order of the variables.

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace quadrille::exports {

/// Text, 32-bit integers, float or double: NC_CHAR, NC_INT, NC_FLOAT, NC_DOUBLE.
using NetcdfValues = std::variant<std::string, std::vector<std::int32_t>, std::vector<float>, std::vector<double>>;

struct NetcdfAttribute {
  std::string name;
  NetcdfValues values;
};

class NetcdfFile {
 public:
  /// The number of the dimension. `size` 0: the record dimension, of which the file has no record; one at most.
  int dimension(const std::string& name, std::size_t size);
  void attribute(const std::string& name, NetcdfValues values);
  /// The number of values must be the product of the dimensions (Defect otherwise), none for the record dimension.
  void variable(const std::string& name, const std::vector<int>& dimensions, NetcdfValues values,
                std::vector<NetcdfAttribute> attributes = {});
  std::string bytes() const;

 private:
  struct Variable {
    std::string name;
    std::vector<int> dimensions;
    NetcdfValues values;
    std::vector<NetcdfAttribute> attributes;
  };
  bool has_records(const std::vector<int>& dimensions) const;
  std::string header(const std::vector<std::uint64_t>& begins) const;

  std::vector<std::pair<std::string, std::size_t>> dimensions_;
  std::vector<NetcdfAttribute> attributes_;
  std::vector<Variable> variables_;
};

}  // namespace quadrille::exports
