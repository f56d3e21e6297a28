#pragma once
// A NetCDF file of a request, by the netCDF library.

#include <string>

#include "export/netcdf_request.hpp"

namespace quadrille::netcdf {

/// The bytes of the file, in the classic format with 64-bit offsets (CDF-2), which has no times and no padding of its
/// own choice. Throws OutputError with the library's message, such as for a variable of 4 GiB, and Defect for a
/// variable that has not as many values as its dimensions say.
std::string netcdf_file(const exports::NetcdfRequest& request);

}  // namespace quadrille::netcdf
