#include "io/format_list.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "model/stage_formats.hpp"

namespace quadrille::io {

namespace {

std::string list(const char* name, const std::vector<std::string>& rows) {
  return fmt::format("\"{}\": [\n  {}\n]", name, fmt::join(rows, ",\n  "));
}

}  // namespace

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
  return fmt::format("{{{},\n{},\n{}}}\n", list("formats", formats), list("tools", tools),
                     list("optional_inputs", inputs));
}

}  // namespace quadrille::io
