#include "export/netcdf_request.hpp"

#include "base/byte_archive.hpp"

namespace quadrille::exports {

namespace {

struct Members {
  static void of(auto& archive, Is<NetcdfAttribute> auto& a) { archive(a.name, a.values); }
  static void of(auto& archive, Is<NetcdfVariable> auto& v) { archive(v.name, v.dimensions, v.values, v.attributes); }
  static void of(auto& archive, Is<NetcdfRequest> auto& r) { archive(r.dimensions, r.attributes, r.variables); }
};

}  // namespace

std::string to_bytes(const NetcdfRequest& request) { return to_bytes_by<Members>(request); }

NetcdfRequest netcdf_request(const std::string& bytes) {
  NetcdfRequest request;
  from_bytes_by<Members>(bytes, request);
  return request;
}

}  // namespace quadrille::exports
