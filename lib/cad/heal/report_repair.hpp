#pragma once
// Repairs in the report.

#include "base/report.hpp"
#include "model/repair.hpp"

namespace quadrille::heal {

/// Sets the entries heal.repair.<number>.
void report_repair(const Repair& repair, size_t number, Report& report);

}  // namespace quadrille::heal
