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
    std::visit([](const auto& model) { check_stage(model, CheckDepth::full); }, read_any_stage(file));
  } catch (const FormatError&) {
  }
  return 0;
}
