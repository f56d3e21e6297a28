// Private helper of quadexport: writes blocks as STEP. A separate program, because every process that links the CAD
// kernel pays for its start-up.

#include "base/child_process.hpp"
#include "check/check.hpp"
#include "export/groups.hpp"
#include "export/step_request.hpp"
#include "io/stage_files.hpp"
#include "occ/write_cad.hpp"

using namespace quadrille;

namespace {

exports::StepModel step_model_of(exports::StepRequest request) {
  io::InputFile file;
  file.name = request.name;
  file.bytes = std::move(request.bytes);
  BlockLayout layout = io::read_stage<BlockLayout>(file);
  check::require_sound(layout, file.name);
  if (request.length.unit == "file" && !occ::has_step_unit(layout.face)) request.length.unit = "mm";
  const LengthScale length = length_scale(layout.face, request.length);
  scale_lengths(layout, length);
  if (request.block_groups) exports::separate_blocks(layout);
  layout.block_names = exports::region_of_blocks(layout);
  return {occ::step_of_blocks(layout), static_cast<std::size_t>(layout.num_blocks()), length};
}

}  // namespace

int main() {
  answer_parent(
      [](const std::string& request) { return exports::to_bytes(step_model_of(exports::step_request(request))); });
}
