// libFuzzer target: any bytes as an HDF5 stage file are read and checked, or refused by FormatError. Without our
// checksum the reader works in a child process first: libhdf5's own crashes are not what is looked for here.

#include <cstdint>

#include "base/error.hpp"
#include "check/check.hpp"
#include "io/stage_files.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace quadrille::check;
  using namespace quadrille::io;
  using quadrille::FormatError;
  const InputFile file{{"fuzz", ""}, std::string(reinterpret_cast<const char*>(data), size)};
  try {
    const std::string format = stage_format(file);
    if (format == "tri-mesh") check_tri_mesh(read_tri_mesh(file), CheckDepth::full);
    if (format == "field") check_field(read_field(file), CheckDepth::full);
    if (format == "block-layout") check_block_layout(read_block_layout(file), CheckDepth::full);
    if (format == "quad-mesh") check_quad_mesh(read_quad_mesh(file), CheckDepth::full);
  } catch (const FormatError&) {
  }
  return 0;
}
