#include "prescribe/flat_plate.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/warning_codes.hpp"

namespace quadrille::prescribe {
namespace {

constexpr double least_reynolds = 5e5, greatest_reynolds = 1e9;  ///< of the formula
constexpr double refused_reynolds = 1000;

}  // namespace

double PlateFlow::skin_friction() const { return std::pow(2 * std::log10(reynolds_number()) - 0.65, -2.3); }

double PlateFlow::height(double yplus) const { return yplus * viscosity / (velocity * std::sqrt(skin_friction() / 2)); }

void PlateFlow::validate(bool is_used) const {
  std::vector<std::string> given, missing;
  (velocity > 0 ? given : missing).emplace_back("--velocity");
  (viscosity > 0 ? given : missing).emplace_back("--viscosity");
  (length > 0 ? given : missing).emplace_back("--length");
  if (!is_used && !given.empty())
    throw UsageError(
        fmt::format("{}: used with --yplus or --wall NAME:yplus=Y only, which are not given", fmt::join(given, ", ")));
  if (!is_used) return;
  if (!missing.empty()) throw UsageError(fmt::format("y+ needs the flow as well: give {}", fmt::join(missing, ", ")));
  if (!(reynolds_number() >= refused_reynolds))
    throw UsageError(
        fmt::format("--velocity, --length and --viscosity: their Reynolds number is {:.3g}, for which y+ of "
                    "a turbulent boundary layer means nothing: give first=H in place of yplus",
                    reynolds_number()));
}

void report_flow(const PlateFlow& flow, Report& report) {
  const double reynolds = flow.reynolds_number();
  report.set("flow.reynolds_number", reynolds);
  report.set("flow.skin_friction", flow.skin_friction());
  report.set("flow.friction_velocity", flow.velocity * std::sqrt(flow.skin_friction() / 2));
  if (reynolds < least_reynolds || reynolds > greatest_reynolds)
    report.warn(
        warning::reynolds_number_outside,
        fmt::format("the Reynolds number {:.3g} lies outside {:g} to {:g}, where the skin friction of the first "
                    "height is known: the achieved y+ may differ from the prescribed one",
                    reynolds, least_reynolds, greatest_reynolds));
}

}  // namespace quadrille::prescribe
