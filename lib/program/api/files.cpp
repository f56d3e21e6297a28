#include "api/files.hpp"

#include "base/error.hpp"
#include "check/check.hpp"
#include "io/stage_files.hpp"

namespace quadrille::api {
namespace {

StageModel read_checked(const io::InputFile& file) {
  StageModel stage = io::read_any_stage(file);
  std::visit([&](const auto& model) { check::require_sound(model, file.name); }, stage);
  return stage;
}

}  // namespace

StageModel read_stage(const std::string& path) { return read_checked(io::read_input(path)); }

StageModel read_stage(const std::string& path, const std::string& format) {
  const io::InputFile file = io::read_input(path);
  const std::string found = io::stage_format(file);
  if (found != format) throw FormatError(file.name + ": expected a " + format + " file, found a " + found + " file");
  return read_checked(file);
}

void write(const std::string& path, const StageModel& model) {
  std::visit([&](const auto& stage) { io::write_stage(path, stage); }, model);
}

std::vector<BrokenRule> broken_rules(const StageModel& model) {
  std::vector<BrokenRule> rules;
  for (const check::Violation& violation :
       std::visit([](const auto& stage) { return check::check_stage(stage, check::CheckDepth::full); }, model))
    rules.push_back({violation.rule, violation.text});
  return rules;
}

}  // namespace quadrille::api
