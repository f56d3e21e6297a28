#include <nlohmann/json.hpp>

#include "base/error.hpp"
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

std::string read_report(const std::string& path) {
  const InputFile file = read_input(path);
  require_shallow(file.bytes, file.name);
  const Json report = Json::parse(file.bytes, nullptr, false);
  if (!report.is_object()) throw FormatError(file.name + ": expected a report, a JSON object (formats/report.md)");
  return report.dump();
}

}  // namespace quadrille::io
