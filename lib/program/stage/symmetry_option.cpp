#include "stage/symmetry_option.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "base/error.hpp"
#include "base/warning_codes.hpp"
#include "curve/named_places.hpp"
#include "curve/symmetry_lines.hpp"
#include "model/name_rules.hpp"

namespace quadrille::stage {

void declare_symmetry(Options& options, std::vector<std::string>& names) {
  options.texts(
      "--symmetry", names, "NAME",
      "boundary curves of this name, or of names that fit a pattern (with * and ?), on one line, at which the "
      "face is one half of a symmetric whole, or on two lines at right angles, a quarter of one: its grid is "
      "that of the whole, with the holes, the far field (--topology), the default sizes and the offset curves of the "
      "whole; "
      "none: no curves; may be given several times (default: symmetry*)",
      false);
}

std::vector<std::string> symmetry_names(const CadFace& face, const std::vector<std::string>& given) {
  if (given == std::vector<std::string>{"none"}) return {};
  std::set<std::string> names;
  const std::vector<std::string> patterns = given.empty() ? std::vector<std::string>{symmetry_pattern} : given;
  for (const std::string& pattern : patterns) {
    std::vector<int> curves = curve::curves_that_fit(face, {pattern});
    if (curves.empty() && !given.empty()) curves = curve::named_curves(face, pattern, "--symmetry");
    for (const int c : curves) names.insert(face.curve_names[c]);
  }
  return {names.begin(), names.end()};
}

std::vector<std::string> checked_symmetry(const CadFace& face, const std::vector<std::string>& given, Report& report) {
  std::vector<std::string> names = symmetry_names(face, given);
  const auto [lines, fault] = curve::symmetry_lines(face, curve::curves_that_fit(face, names));
  if (names.empty() || curve::is_part_of_whole(lines)) return names;
  constexpr const char* rule = "a half has the curves of its symmetry on one line, a quarter on two at right angles";
  if (!given.empty())
    throw UsageError(fmt::format("--symmetry {}: {}: {}", fmt::join(given, ", "),
                                 fault.empty() ? fmt::format("the curves lie on {} lines", lines.size()) : fault,
                                 rule));
  if (!fault.empty())
    report.warn(warning::half_for_itself,
                fmt::format("{}, so that the face is no half of a symmetric whole: {}; give the curve another name "
                            "(--name), or --symmetry none",
                            fault, rule));
  return {};
}

}  // namespace quadrille::stage
