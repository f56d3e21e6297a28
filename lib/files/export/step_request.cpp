#include "export/step_request.hpp"

#include <fmt/format.h>

#include <vector>

#include "base/error.hpp"

namespace quadrille::exports {

namespace {

// Neither names of files nor STEP files contain a zero byte; the text behind the last one may contain any.
constexpr char separator = '\0';

std::vector<std::string> fields_of(const std::string& bytes, std::size_t count) {
  std::vector<std::string> fields;
  std::size_t begin = 0;
  while (fields.size() + 1 < count) {
    const std::size_t end = bytes.find(separator, begin);
    if (end == std::string::npos) throw Defect("fields_of: too few fields");
    fields.push_back(bytes.substr(begin, end - begin));
    begin = end + 1;
  }
  fields.push_back(bytes.substr(begin));
  return fields;
}

}  // namespace

std::string to_bytes(const StepRequest& request) {
  return fmt::format("{1}{0}{2:.17g}{0}{3:d}{0}{4}{0}{5}", separator, request.length.unit,
                     request.length.scale.value_or(1), request.block_groups, request.name, request.bytes);
}

StepRequest step_request(const std::string& bytes) {
  std::vector<std::string> fields = fields_of(bytes, 5);
  StepRequest request;
  request.length = {fields[0], std::stod(fields[1]), true};
  request.block_groups = fields[2] == "1";
  request.name = fields[3];
  request.bytes = std::move(fields[4]);
  return request;
}

std::string to_bytes(const StepModel& model) {
  return fmt::format("{1}{0}{2:.17g}{0}{3}{0}{4}", separator, model.num_blocks, model.length.factor, model.bytes,
                     model.length.unit);
}

StepModel step_model(const std::string& bytes) {
  std::vector<std::string> fields = fields_of(bytes, 4);
  return {std::move(fields[2]), std::stoul(fields[0]), {std::stod(fields[1]), fields[3], 0}};
}

}  // namespace quadrille::exports
