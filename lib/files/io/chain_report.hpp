#pragma once
// The report of a run of several stages, made of theirs (formats/report.md, "quadmesh").

#include <optional>
#include <string>
#include <vector>

namespace quadrille::io {

/// The report of one run of a stage, as its command writes it.
struct StageReport {
  std::string stage;  ///< in the report of the whole: the tool with a prefix, such as trial_separatrix
  std::string json;   ///< text of a JSON object; anything else counts as empty
};

struct ReportedWarning {
  std::string tool, code, message;
};
std::vector<ReportedWarning> warnings_of(const StageReport& report);

/// The number, text or flag of a dotted key as text ("certificate.method"); nothing if it is missing or null.
std::optional<std::string> value_of(const StageReport& report, const std::string& key);

/// A mesh that was made to compare layouts.
struct LayoutTrial {
  std::string options;  ///< of critpoints that were added; empty: none
  bool is_valid = false;
  double edge_ratio = 0, scaled_jacobian = 0, resolution = 0;  ///< greatest, least, resolution ratio
  int blocks = 0;
};

/// That of a report of quadrefine.
LayoutTrial layout_trial(const StageReport& report, const std::string& options);

/// What no stage reports.
struct ChainFacts {
  std::optional<std::string> form;  ///< of the nodes; none: there are no nodes
  std::size_t num_nodes = 0;
  std::string remedy;  ///< options of critpoints that were added; empty: none
  std::vector<LayoutTrial> trials;
  std::string version;
  double wall_seconds = 0;
  int exit_code = 0;
  std::optional<std::string> failed_stage, error;  ///< after a failure
};

/// Runs of stages trial_* count with their times alone, and with the warning that one of them was stopped.
class ChainReport {
 public:
  ChainReport(const std::vector<StageReport>& stages, const ChainFacts& facts);

  const std::string& text() const { return text_; }  ///< JSON
  /// The same with the command in front.
  std::string text_with_command(const std::string& command) const;
  /// A line for each stage with its time and its share, and one for all.
  std::string times() const;
  /// One line about the mesh, with the verdict at its end, or about the blocks that were exported.
  std::string summary() const;

 private:
  std::string text_;
};

}  // namespace quadrille::io
