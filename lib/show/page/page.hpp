#pragma once
// A page (HTML) that shows stage files of one chain: it pans, zooms, and shows figures of what is under the pointer.
//
// The page is self-contained: geometry as compact numbers (page_data.hpp), and the script and style
// of this folder (view.css, *.js), which are compiled in. The script draws layers of four kinds: cells (elements),
// chains (lines, blocks), marks (nodes) and samples (the field).

#include <array>
#include <string>
#include <vector>

#include "model/stage_formats.hpp"

namespace quadrille::page {

/// What is known of the run that made the stages. A further tab shows its report, with histograms of the last mesh.
struct RunRecord {
  std::string shape;                  ///< name of the shape, the page's title and heading; empty: that of the face
  std::string report;                 ///< JSON object (formats/report.md); empty: unknown, and no tab
  std::vector<std::string> commands;  ///< of the stages, for a shell
  std::string workbench = {};         ///< JSON object (pipelines/quadbench.md); empty: the page does not edit
};

/// The page of the stages, a tab each, in this order. Equal stages give equal bytes. About 110 bytes for each quad.
/// With a workbench the page has its script too, which may send requests to where the page comes from.
std::string html_page(const std::vector<StageModel>& stages, const RunRecord& run = {});

/// The data of that page alone, a JSON object, for a page that is open already.
std::string page_data(const std::vector<StageModel>& stages, const RunRecord& run);

/// The page of two layouts or meshes, of one chain or not, tabs A and B: the lines of the other one are drawn over
/// each, and a table has the counts and qualities of both. `names`: of A and B, in title, heading and tabs.
std::string comparison_page(const StageModel& a, const StageModel& b, const std::array<std::string, 2>& names = {});

}  // namespace quadrille::page
