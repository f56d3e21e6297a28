#include "io/chain_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "io/json_archive.hpp"
#include "io/whole_file.hpp"

namespace quadrille::io {

namespace {

using Json = nlohmann::ordered_json;

/// The value of a dotted key; inner objects are made where they are missing.
Json& member_of(Json& root, const std::string& key) {
  Json* member = &root;
  std::size_t begin = 0;
  for (std::size_t dot; (dot = key.find('.', begin)) != std::string::npos; begin = dot + 1) {
    member = &(*member)[key.substr(begin, dot - begin)];
    if (!member->is_object()) *member = Json::object();
  }
  return (*member)[key.substr(begin)];
}

}  // namespace

std::string report_text(const std::string& tool, const std::string& version, const Report& report) {
  Json root;
  root["tool"] = tool;
  root["version"] = version;
  for (const auto& [key, value] : report.entries())
    std::visit([&, member = &member_of(root, key)](const auto& v) { *member = v; }, value);
  root["warnings"] = Json::array();
  for (const auto& [code, message] : report.warnings())
    root["warnings"].push_back({{"code", code}, {"message", message}});
  return json_text(root);
}

void write_report(const std::string& path, const std::string& tool, const std::string& version, const Report& report) {
  write_output(path, report_text(tool, version, report), false);
}

std::string read_object(const std::string& path, const std::string& what, const std::string& page) {
  const InputFile file = read_input(path);
  require_shallow(file.bytes, file.name);
  const Json object = Json::parse(file.bytes, nullptr, false);
  if (!object.is_object()) throw FormatError(fmt::format("{}: expected {}, a JSON object ({})", file.name, what, page));
  return object.dump();
}

namespace {

using Json = nlohmann::ordered_json;

Json parsed(const std::string& text) {
  Json json = is_shallow(text) ? Json::parse(text, nullptr, false) : Json();
  return json.is_object() ? json : Json::object();
}

/// The value of a dotted key, or null.
Json at(const Json& root, const std::string& key) {
  const Json* value = &root;
  for (std::size_t begin = 0; begin <= key.size();) {
    const std::size_t end = std::min(key.find('.', begin), key.size());
    const auto found = value->is_object() ? value->find(key.substr(begin, end - begin)) : value->end();
    if (!value->is_object() || found == value->end()) return nullptr;
    value = &*found;
    begin = end + 1;
  }
  return *value;
}

double number_at(const Json& root, const std::string& key) {
  const Json value = at(root, key);
  return value.is_number() ? value.get<double>() : 0;
}

std::string text_at(const Json& root, const std::string& key) {
  const Json value = at(root, key);
  return value.is_string() ? value.get<std::string>() : std::string();
}

/// The entries of "warnings" that are objects. External programs may write anything there.
Json warnings_in(const Json& report) {
  Json warnings = Json::array();
  for (const Json& warning : at(report, "warnings"))
    if (warning.is_object()) warnings.push_back(warning);
  return warnings;
}

/// A run of a stage.
struct StageRun {
  std::string stage;
  Json report;
  bool is_used = true;  ///< not one of trial_*
};

std::vector<StageRun> runs_of(const std::vector<StageReport>& stages) {
  std::vector<StageRun> runs;
  for (const StageReport& stage : stages) {
    Json report = parsed(stage.json);
    if (!text_at(report, "tool").empty())
      runs.push_back({stage.stage, std::move(report), !stage.stage.starts_with("trial_")});
  }
  return runs;
}

/// The report of the last run of a tool whose result is used; null if the tool has no such run.
Json report_of(const std::vector<StageRun>& runs, const std::string& tool) {
  Json found;
  for (const StageRun& run : runs)
    if (run.is_used && run.report["tool"] == tool) found = run.report;
  return found;
}

/// "TOOL: MESSAGE" of the first used run that failed, if the last one did not.
Json given_up(const std::vector<StageRun>& runs) {
  Json message;
  int last_code = 0;
  for (const StageRun& run : runs) {
    if (!run.is_used) continue;
    last_code = static_cast<int>(number_at(run.report, "exit_code"));
    if (last_code != 0 && message.is_null())
      message = fmt::format("{}: {}", text_at(run.report, "tool"), text_at(run.report, "error"));
  }
  return last_code == 0 ? message : Json();
}

/// Times of each stage, those of equal names added.
Json times_of(const std::vector<StageRun>& runs) {
  Json times = Json::object();
  for (const StageRun& run : runs) {
    if (!run.report.contains("timings")) continue;
    Json& sum = times[run.stage];
    if (sum.is_null()) sum = Json::object();
    const Json total = at(run.report, "timings.total");
    for (const auto& [key, value] : total.items())
      if (value.is_number()) sum[key] = value.get<double>() + (sum.contains(key) ? sum[key].get<double>() : 0.0);
  }
  return times;
}

/// Each once: a stage that runs again with other options gives the same ones.
Json warnings_of(const std::vector<StageRun>& runs) {
  Json all = Json::array();
  for (const StageRun& run : runs) {
    const Json warnings = warnings_in(run.report);
    if (!run.is_used && (warnings.empty() || text_at(warnings[0], "tool") != "quadmesh")) continue;
    for (const Json& warning : warnings) {
      Json one{{"tool", run.report["tool"]}};
      one.update(warning);
      if (std::ranges::find(all, one) == all.end()) all.push_back(std::move(one));
    }
  }
  return all;
}

/// Whole numbers without a point.
void write_whole_numbers(Json& value) {
  if (value.is_structured())
    for (Json& part : value) write_whole_numbers(part);
  else if (value.is_number_float() && std::abs(value.get<double>()) < 1e15 &&
           value.get<double>() == std::floor(value.get<double>()))
    value = static_cast<long long>(value.get<double>());
}

Json optional_text(const std::optional<std::string>& text) { return text ? Json(*text) : Json(); }

/// Keys that quadrefine reports of the mesh.
constexpr const char* mesh_keys[] = {"least_jacobian_bound",
                                     "valid",
                                     "least_scaled_jacobian",
                                     "greatest_edge_ratio",
                                     "greatest_area_jump",
                                     "least_node_distance",
                                     "resolution",
                                     "walls",
                                     "growth",
                                     "counts",
                                     "gradings",
                                     "boundary",
                                     "boundaries",
                                     "surface"};

Json trials_of(const ChainFacts& facts) {
  Json trials = Json::array();
  for (const LayoutTrial& trial : facts.trials)
    trials.push_back({{"options", trial.options.empty() ? Json() : Json(trial.options)},
                      {"valid", trial.is_valid},
                      {"greatest_edge_ratio", trial.edge_ratio},
                      {"least_scaled_jacobian", trial.scaled_jacobian},
                      {"resolution", trial.resolution},
                      {"blocks", trial.blocks}});
  return trials;
}

/// "; tried: critpoints --place energy (resolution ratio 16 in place of 14)" for each choice of nodes; empty: none was.
std::string tried_text(const ChainFacts& facts) {
  std::string text;
  for (const LayoutTrial& trial : facts.trials) {
    if (trial.options.empty()) continue;
    text += fmt::format("{}{} (resolution ratio {:.3g} in place of {:.3g}{})", text.empty() ? "; tried: " : ", ",
                        trial.options, trial.resolution, facts.trials.front().resolution,
                        trial.options == facts.remedy ? ": taken" : "");
  }
  return text;
}

/// That of quadrefine, and what was tried if the mesh is not good.
Json verdict_of(const Json& refine, const ChainFacts& facts) {
  Json verdict = at(refine, "verdict");
  if (verdict.is_object() && text_at(verdict, "grade") != "good")
    verdict["text"] = text_at(verdict, "text") + tried_text(facts);
  return verdict;
}

/// Of the hexahedra; null if there are none.
Json sweep_of(const Json& report) {
  if (at(report, "hexahedra").is_null()) return nullptr;
  Json sweep;
  for (const char* key :
       {"hexahedra", "layers", "valid", "least_jacobian_bound", "least_scaled_jacobian", "motion_error"})
    sweep[key] = at(report, key);
  return sweep;
}

Json composed(const std::vector<StageReport>& stages, const ChainFacts& facts) {
  const std::vector<StageRun> runs = runs_of(stages);
  const Json refine = report_of(runs, "quadrefine"), exported = report_of(runs, "quadexport");
  Json root;
  root["tool"] = "quadmesh";
  root["version"] = facts.version;
  root["form"] = optional_text(facts.form);
  root["critical_points"] = facts.num_nodes;
  root["irregular_nodes"] = at(refine, "irregular_nodes");
  root["blocks"] = at(refine, "blocks");
  root["certificate"] = at(report_of(runs, "separatrix"), "certificate");
  root["given_up"] = given_up(runs);
  root["remedy"] = facts.remedy.empty() ? Json() : Json(facts.remedy);
  root["trials"] = trials_of(facts);
  root["estimated_quads"] = at(refine, "estimated_quads");
  root["sweep"] = sweep_of(report_of(runs, "hexsweep"));
  root["quads"] = at(refine, "quads").is_null() ? at(exported, "quads") : at(refine, "quads");
  root["verdict"] = verdict_of(refine, facts);
  for (const char* key : mesh_keys) root[key] = at(refine, key);
  root["unit"] = at(exported, "unit");
  root["scale"] = at(exported, "scale");
  double cpu = 0;
  for (const StageRun& run : runs) cpu += number_at(run.report, "timings.total.cpu_seconds");
  root["cpu_seconds"] = cpu;
  root["wall_seconds"] = facts.wall_seconds;
  root["stages"] = times_of(runs);
  root["warnings"] = warnings_of(runs);
  root["exit_code"] = facts.exit_code;
  root["stage"] = optional_text(facts.failed_stage);
  root["error"] = optional_text(facts.error);
  write_whole_numbers(root);
  return root;
}

/// A number rounded to `digits` decimals, without trailing zeros.
std::string rounded(double value, int digits) {
  const double power = std::pow(10, digits);
  return fmt::format("{}", std::round(value * power) / power);
}

std::string counted_at(const Json& report, const std::string& key, const char* noun) {
  return counted(static_cast<long long>(number_at(report, key)), noun);
}

}  // namespace

std::vector<ReportedWarning> warnings_of(const StageReport& report) {
  const Json root = parsed(report.json);
  std::vector<ReportedWarning> warnings;
  for (const Json& warning : warnings_in(root))
    warnings.push_back({text_at(warning.contains("tool") ? warning : root, "tool"), text_at(warning, "code"),
                        text_at(warning, "message")});
  return warnings;
}

std::optional<std::string> value_of(const StageReport& report, const std::string& key) {
  const Json value = at(parsed(report.json), key);
  if (value.is_null()) return std::nullopt;
  return value.is_string() ? value.get<std::string>() : value.dump();
}

LayoutTrial layout_trial(const StageReport& report, const std::string& options) {
  const Json root = parsed(report.json);
  return {options,
          at(root, "valid") == true,
          number_at(root, "greatest_edge_ratio.value"),
          number_at(root, "least_scaled_jacobian"),
          number_at(root, "resolution.ratio"),
          static_cast<int>(number_at(root, "blocks"))};
}

ChainReport::ChainReport(const std::vector<StageReport>& stages, const ChainFacts& facts)
    : text_(json_text(composed(stages, facts))) {}

std::string ChainReport::text_with_command(const std::string& command) const {
  Json root{{"command", command}};
  root.update(parsed(text_));
  return json_text(root);
}

std::string ChainReport::times() const {
  const Json root = parsed(text_);
  const double all = number_at(root, "cpu_seconds");
  std::string lines;
  for (const auto& [stage, times] : root["stages"].items()) {
    const double cpu = number_at(times, "cpu_seconds");
    lines +=
        fmt::format("{:<16.16} {} s CPU, {} %\n", stage, rounded(cpu, 3), all > 0 ? std::round(cpu / all * 100) : 0);
  }
  return lines +
         fmt::format("all stages       {} s CPU, {} s\n", rounded(all, 3), rounded(number_at(root, "wall_seconds"), 3));
}

std::string ChainReport::summary() const {
  const Json root = parsed(text_);
  if (root["blocks"].is_null()) return counted_at(root, "quads", "quad");
  std::string line = fmt::format(
      "{}, {}, {}, worst scaled Jacobian {}, greatest edge ratio {}", counted_at(root, "blocks", "block"),
      counted_at(root, "irregular_nodes", "irregular node"), counted_at(root, "quads", "quad"),
      rounded(number_at(root, "least_scaled_jacobian"), 2), rounded(number_at(root, "greatest_edge_ratio.value"), 1));
  if (!root["sweep"].is_null())
    line += fmt::format("; {} hexahedra, worst scaled Jacobian {}", number_at(root, "sweep.hexahedra"),
                        rounded(number_at(root, "sweep.least_scaled_jacobian"), 2));
  if (at(root, "certificate.method") == "midpoint") line += ", by midpoint division of triangles";
  if (const Json& scale = root["scale"]; !scale.is_null() && scale != 1) {
    const std::string unit = root["unit"].is_string() ? root["unit"].get<std::string>() : "unknown";
    line += fmt::format(", coordinates in {}, {} times those of the CAD file",
                        unit == "unknown" ? "an unknown unit" : unit, scale.get<double>());
  }
  const std::string verdict = text_at(root, "verdict.text");
  return verdict.empty() ? line : line + "; " + verdict;
}

}  // namespace quadrille::io
