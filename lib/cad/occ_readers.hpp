#pragma once
// The readers behind occ_load, one file each.

#include <string>

#include "cad/occ_model.hpp"

namespace quadrille::cad {

OccModel occ_load_step(const std::string& bytes, const std::string& name);
OccModel occ_load_iges(const std::string& bytes, const std::string& name);

}  // namespace quadrille::cad
