#include "netcdf/write_netcdf.hpp"

#include <netcdf.h>
#include <netcdf_mem.h>

#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

#include "base/error.hpp"

namespace quadrille::netcdf {

namespace {

void require(int status) {
  if (status == NC_ENOMEM) throw std::bad_alloc();
  if (status != NC_NOERR) throw OutputError(std::string("the netCDF library reports: ") + nc_strerror(status));
}

int put(int file, int variable, const std::string& values) { return nc_put_var_text(file, variable, values.data()); }
int put(int file, int variable, const std::vector<std::int32_t>& values) {
  return nc_put_var_int(file, variable, values.data());
}
int put(int file, int variable, const std::vector<float>& values) {
  return nc_put_var_float(file, variable, values.data());
}
int put(int file, int variable, const std::vector<double>& values) {
  return nc_put_var_double(file, variable, values.data());
}

nc_type type_of(const exports::NetcdfValues& values) {
  constexpr nc_type types[] = {NC_CHAR, NC_INT, NC_FLOAT, NC_DOUBLE};
  return types[values.index()];
}

/// The file in memory; given up at the end if it is not complete.
class NetcdfFile {
 public:
  NetcdfFile() { require(nc_create_mem("mesh", NC_64BIT_OFFSET, 0, &file_)); }
  NetcdfFile(const NetcdfFile&) = delete;
  NetcdfFile& operator=(const NetcdfFile&) = delete;
  ~NetcdfFile() {
    if (file_ >= 0) nc_abort(file_);
  }

  std::string written(const exports::NetcdfRequest& request) {
    int ignored = 0;
    for (const auto& [name, size] : request.dimensions)
      require(nc_def_dim(file_, name.c_str(), size == 0 ? NC_UNLIMITED : static_cast<std::size_t>(size), &ignored));
    define_attributes(NC_GLOBAL, request.attributes);
    for (const exports::NetcdfVariable& variable : request.variables) define(variable);
    require(nc_set_fill(file_, NC_NOFILL, &ignored));  // all values follow
    require(nc_enddef(file_));
    for (std::size_t v = 0; v < request.variables.size(); ++v)
      put_values(static_cast<int>(v), request.variables[v], request);
    return closed();
  }

 private:
  void define_attributes(int variable, const std::vector<exports::NetcdfAttribute>& attributes) {
    for (const exports::NetcdfAttribute& a : attributes)
      std::visit(
          [&](const auto& all) {
            require(nc_put_att(file_, variable, a.name.c_str(), type_of(a.values), all.size(), all.data()));
          },
          a.values);
  }

  void define(const exports::NetcdfVariable& variable) {
    int number = 0;
    require(nc_def_var(file_, variable.name.c_str(), type_of(variable.values),
                       static_cast<int>(variable.dimensions.size()), variable.dimensions.data(), &number));
    define_attributes(number, variable.attributes);
  }

  void put_values(int number, const exports::NetcdfVariable& variable, const exports::NetcdfRequest& request) {
    std::size_t size = 1;
    for (const int dimension : variable.dimensions) size *= request.dimensions.at(dimension).second;
    std::visit(
        [&](const auto& all) {
          if (all.size() != size) throw Defect("netcdf_file: the values of " + variable.name + " do not fill it");
          if (size > 0) require(put(file_, number, all));
        },
        variable.values);
  }

  std::string closed() {
    NC_memio memory{};
    const int file = file_;
    file_ = -1;
    require(nc_close_memio(file, &memory));
    const std::unique_ptr<void, decltype(&std::free)> owner(memory.memory, &std::free);
    return {static_cast<const char*>(memory.memory), memory.size};
  }

  int file_ = -1;
};

}  // namespace

std::string netcdf_file(const exports::NetcdfRequest& request) { return NetcdfFile().written(request); }

}  // namespace quadrille::netcdf
