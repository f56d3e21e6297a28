#include "stage/stagecheck.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/enum_names.hpp"
#include "base/warning_codes.hpp"
#include "check/check.hpp"
#include "mesh/element_sizes.hpp"
#include "mesh/verdict.hpp"

namespace quadrille::stage {

namespace {

std::string json_rows(const char* name, const std::vector<std::string>& rows) {
  return fmt::format("\"{}\": [\n  {}\n]", name, fmt::join(rows, ",\n  "));
}

void report_mesh(const QuadMesh& mesh, const std::string& file, Run& run) {
  if (!mesh.is_valid)
    run.report().warn(warning::mesh_not_valid, fmt::format("{}: {}", file, check::validity_warning(mesh)));
  const double ratio = mesh::resolution(mesh).ratio;
  const mesh::Verdict verdict = mesh::verdict_of(mesh);
  run.report().set("resolution.ratio", ratio);
  run.report().set("verdict.grade", enum_name(verdict.grade()));
  run.report().set("verdict.text", mesh::describe(verdict, mesh.face));
  run.info(fmt::format("{}: resolution ratio {:.3g}; {}", file, ratio, mesh::describe(verdict, mesh.face)));
}

}  // namespace

void declare(Options& o, StagecheckOptions& stagecheck) {
  o.flag("--history", stagecheck.is_history,
         "print the commands by which each FILE was made, with all options, from its provenance, each command once; "
         "inputs that no command makes are described by their SHA-256. Give x.crit.json with the files made from it: "
         "only it knows the options of critpoints");
  o.flag("--list-formats", stagecheck.is_list,
         "print the formats with their versions, and the tools that write them, as JSON for scripts; no FILE is read");
}

std::vector<std::string> stagecheck(const StageModel& stage, const std::string& file, Run& run) {
  std::vector<std::string> lines;
  for (const check::Violation& violation :
       std::visit([](const auto& model) { return check::check_stage(model, check::CheckDepth::full); }, stage))
    lines.push_back(fmt::format("{}: {}: {}", file, violation.rule, violation.text));
  const QuadMesh* mesh = std::get_if<QuadMesh>(&stage);
  if (lines.empty() && mesh) report_mesh(*mesh, file, run);
  const HexMesh* hexes = std::get_if<HexMesh>(&stage);
  if (lines.empty() && hexes && !hexes->is_valid)
    run.report().warn(warning::mesh_not_valid, fmt::format("{}: {}", file, check::validity_warning(*hexes)));
  return lines;
}

std::vector<std::string> history_lines(std::vector<io::MadeFile> files) {
  io::History history;
  std::vector<std::string> lines;
  for (const io::MadeFile& file : io::oldest_first(std::move(files))) {
    for (std::string& line : history.lines_of(file.chain, file.sha256, io::history_stem(file.path)))
      lines.push_back(std::move(line));
    if (!file.chain.empty() && file.chain.back().tool == "critpoints")
      lines.push_back(
          fmt::format("# {}: SHA-256 {}; if the command makes another file, it was edited since: use the edited one",
                      history.name_of(file.sha256), file.sha256));
  }
  return lines;
}

std::string format_list() {
  std::vector<std::string> formats, tools, inputs;
  for (const StageFormat& format : stage_formats)
    formats.push_back(fmt::format(R"({{"name": "{}", "version": [{}, {}], "storage": "{}"}})", format.name,
                                  format.major, format.minor, format.storage == Storage::hdf5 ? "HDF5" : "JSON"));
  for (const StageTool& tool : stage_tools)
    tools.push_back(fmt::format(R"({{"name": "{}", "after": "{}", "writes": "{}", "ending": "{}"}})", tool.name,
                                tool.after, tool.writes, tool.ending));
  for (const OptionalInput& input : optional_inputs)
    inputs.push_back(
        fmt::format(R"({{"tool": "{}", "option": "{}", "format": "{}"}})", input.tool, input.option, input.format));
  return fmt::format("{{{},\n{},\n{}}}\n", json_rows("formats", formats), json_rows("tools", tools),
                     json_rows("optional_inputs", inputs));
}

}  // namespace quadrille::stage
