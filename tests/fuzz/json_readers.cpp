// libFuzzer target: any bytes as a JSON stage file, or one of names or directions, are read and checked, or refused by
// FormatError.

#include <cstdint>

#include "base/error.hpp"
#include "check/check.hpp"
#include "io/alignment_io.hpp"
#include "io/name_rules_io.hpp"
#include "io/stage_files.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace quadrille::check;
  using namespace quadrille::io;
  using quadrille::FormatError;
  const InputFile file{{"fuzz", ""}, std::string(reinterpret_cast<const char*>(data), size)};
  const auto attempt = [](const auto& read_and_check) {
    try {
      read_and_check();
    } catch (const FormatError&) {
    }
  };
  attempt([&] { std::visit([](const auto& model) { check_stage(model, CheckDepth::full); }, read_any_stage(file)); });
  attempt([&] { read_boundary_names(file); });
  attempt([&] { read_block_names(file); });
  attempt([&] { read_alignment(file); });
  return 0;
}
