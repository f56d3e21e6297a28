#pragma once
// What a user can choose about the files of other programs.

#include <vector>

#include "export/patch_types.hpp"
#include "model/length_scale.hpp"

namespace quadrille::exports {

struct ExportOptions {
  ScaleRequest length{};                 ///< unit and factor of the coordinates
  bool in_space = false;                 ///< coordinates of the CAD model rather than of the face's plane
  std::vector<PatchType> patch_types{};  ///< of formats whose boundaries have types
  bool block_groups = false;  ///< each block without a name of its own is a region of its own (export/groups)
};

}  // namespace quadrille::exports
