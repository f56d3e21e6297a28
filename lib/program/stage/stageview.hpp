#pragma once
// The command stageview: a picture of one stage or of two compared, or a page of several.

#include <string>
#include <vector>

#include "base/options.hpp"
#include "base/run.hpp"
#include "model/provenance.hpp"
#include "model/stage_formats.hpp"

namespace quadrille::stage {

struct StageviewOptions {
  std::string field_file;       ///< path of the field under critical points, which the caller reads
  bool is_comparison = false;   ///< of two layouts or meshes, of one chain or not
  std::string run_report_file;  ///< path of the report of a run, which the caller reads
  std::string workbench_file;   ///< path of the state of a workbench, which the caller reads
  std::string show = "psi";     ///< of a field: "u", "v", "psi" or "order"
  bool labels_all = false, labels_none = false;
  bool is_bare = false;  ///< without title, labels and legend
  std::string window;    ///< "X0,Y0,X1,Y1", in the coordinates of the file; empty: everything
  std::string view;      ///< "X,Y,Z" or "iso": of a mesh in space; empty: isometric, beside the chart
  int width = 1000;      ///< pixels
};
void declare(Options& options, StageviewOptions& stageview);

/// What is shown, filled by add_to.
struct View {
  struct Stage {
    StageModel model;
    FileIdentity file;
  };
  std::vector<Stage> stages;   ///< in their order; with `has_field` the field comes first
  bool is_page = false;        ///< HTML; else SVG
  bool is_comparison = false;  ///< of two layouts or meshes, of one chain or not
  bool has_field = false;      ///< under critical points
  bool is_data = false;        ///< of a page, JSON, without the page
  std::string run_report;      ///< for a page: JSON of the run that made the stages; empty: none
  std::string workbench;       ///< for a page that edits: JSON of its state; empty: none
};

/// The view without stages, before a file is read. `ending`: of the output, such as "html". Throws UsageError for
/// options that exclude each other or do not fit a page, a picture or `num_files` files.
View begun_view(const StageviewOptions& options, const std::string& ending, std::size_t num_files);

/// Adds a stage. A mesh that is not valid is reported. Throws FormatError if it breaks a rule, or was not made from one
/// of those before nor one of them from it; UsageError for what cannot be compared.
void add_to(View& view, StageModel model, FileIdentity file, Run& run);

/// The SVG, HTML or JSON. `stem`: the shape's name, and how files are called in the commands of the run. UsageError:
/// nothing is in the window.
std::string stageview(View view, const std::string& stem, const StageviewOptions& options);

}  // namespace quadrille::stage
