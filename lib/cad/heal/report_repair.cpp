#include "heal/report_repair.hpp"

#include <fmt/format.h>

#include <vector>

namespace quadrille::heal {

void report_repair(const Repair& repair, size_t number, Report& report) {
  const std::string key = fmt::format("heal.repair.{}.", number);
  report.set(key + "kind", enum_name(repair.kind));
  report.set(key + "edge", repair.cad_edge);
  report.set(key + "position", Report::Value(std::vector<double>{repair.position.x, repair.position.y}));
  report.set(key + "distance", repair.distance);
}

}  // namespace quadrille::heal
