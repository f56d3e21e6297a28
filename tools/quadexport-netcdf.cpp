// Private helper of quadexport: makes a NetCDF file. A separate program, to keep the netCDF library, and what that
// loads, out of all other processes of a chain.

#include "base/child_process.hpp"
#include "export/netcdf_request.hpp"
#include "netcdf/write_netcdf.hpp"

using namespace quadrille;

int main() {
  answer_parent([](const std::string& request) { return netcdf::netcdf_file(exports::netcdf_request(request)); });
}
