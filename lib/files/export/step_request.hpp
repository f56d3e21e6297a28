#pragma once
// What quadexport asks of quadexport-step, which is linked with the CAD kernel (base/child_process.hpp), and its
// answer.

#include <cstddef>
#include <string>

#include "model/length_scale.hpp"

namespace quadrille::exports {

struct StepRequest {
  std::string name;           ///< of the file, for messages
  std::string bytes;          ///< of a block layout
  ScaleRequest length{};      ///< unit and factor of the coordinates
  bool block_groups = false;  ///< name the faces of blocks without a name by their numbers
};

struct StepModel {
  std::string bytes;  ///< of the STEP file
  std::size_t num_blocks = 0;
  LengthScale length{};  ///< of the coordinates, without metres_per_unit
};

std::string to_bytes(const StepRequest& request);
StepRequest step_request(const std::string& bytes);

std::string to_bytes(const StepModel& model);
StepModel step_model(const std::string& bytes);

}  // namespace quadrille::exports
