#pragma once
// The stage critpoints: irregular nodes and corner valences, chosen from a guiding field in each region.

#include <string>
#include <vector>

#include "base/options.hpp"
#include "base/run.hpp"
#include "choice/choose_nodes.hpp"
#include "model/critical_points.hpp"
#include "model/field.hpp"
#include "stage/stage_input.hpp"

namespace quadrille::stage {

struct CritpointsOptions {
  choice::NodeOptions choose;                ///< overrides, feature size, walls and symmetry are those of the texts
  std::vector<std::string> corner_valences;  ///< A:B=V
  std::string feature_size = "auto";         ///< or a length
  std::vector<std::string> clearances;       ///< NAME=L
  std::vector<std::string> symmetry;         ///< names or patterns (stage/symmetry_option.hpp)

  void validate() const;  ///< throws UsageError for texts that mean nothing
};
void declare(Options& options, CritpointsOptions& critpoints);

/// The nodes and corners (choice/choose_nodes.hpp). Throws FormatError if the field breaks a rule of its format or is
/// of the phase form, UsageError for options that are wrong or do not fit the face, ComputeError if the index sum does
/// not hold.
CriticalPoints critpoints(const Input<Field>& field, const CritpointsOptions& options, Run& run);

/// Throws UsageError for options that do not fit the face, before there is a field.
void require_critpoints_of(const CadFace& face, const CritpointsOptions& options);

}  // namespace quadrille::stage
