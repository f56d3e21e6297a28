// Critical points, corners and boundary nodes as marks.

#include <fmt/format.h>

#include "base/enum_names.hpp"
#include "page/instantiate_sheet.hpp"
#include "page/node_layers.hpp"

namespace quadrille::page {

namespace {

std::string valence_text(const std::string& noun, int valence, NodeSource source) {
  return fmt::format("{} of valence {}, source: {}", noun, valence, enum_name(source));
}

Marks nodes_of(const CriticalPoints& points, const PageFrame& frame) {
  Marks marks;
  for (const CriticalPoint& p : points.critical_points) {
    const std::string noun = p.source == NodeSource::zero ? "critical point" : "irregular node";
    const std::string error = p.error > 0 ? fmt::format(", position ± {:.2g}", p.error) : "";
    marks.add(frame, p.position, p.valence, "node", valence_text(noun, p.valence, p.source) + error);
  }
  for (const IrregularBoundaryPoint& b : points.boundary_nodes)
    marks.add(frame, b.position, b.valence, "boundary", valence_text("boundary node", b.valence, b.source));
  return marks;
}

Marks corners_of(const CriticalPoints& points, const PageFrame& frame) {
  Marks marks;
  for (const Corner& c : points.corners)
    marks.add(frame, c.position, c.valence, "corner",
              valence_text(fmt::format("corner of {:.4g} degrees,", c.angle_degrees), c.valence, c.source));
  return marks;
}

Marks zeros_of(const CriticalPoints& points, const PageFrame& frame) {
  Marks marks;
  for (const CriticalPoint& p : points.zeros)
    marks.add(frame, p.position, p.valence, "hollow", fmt::format("zero of the field, index {}", p.index));
  return marks;
}

Marks changes_of(const CriticalPoints& points, const PageFrame& frame) {
  Marks marks;
  for (const NodeChange& change : points.changes)
    for (const NodeMark& mark : change.before)
      marks.add(frame, mark.position, mark.valence, "hollow",
                fmt::format("before the change '{}': {}", enum_name(change.kind), change.reason));
  return marks;
}

}  // namespace

Sheet sheet_of(const CriticalPoints& points, const PageFrame& frame) {
  Sheet sheet;
  const std::string noun = points.form == NodeForm::phase ? "nodes" : "critical points";
  sheet.title = points.form == NodeForm::phase ? "Irregular nodes" : "Critical points";
  sheet.caption = fmt::format("{} {}, {} corners, index sum {}", points.critical_points.size(), noun,
                              points.corners.size(), points.index_sum);
  sheet.facts = {{noun, std::to_string(points.critical_points.size())},
                 {"corners", std::to_string(points.corners.size())},
                 {"boundary nodes", std::to_string(points.boundary_nodes.size())},
                 {"changes", std::to_string(points.changes.size())},
                 {"index sum", std::to_string(points.index_sum)},
                 {"expected", std::to_string(points.index_sum_expected)}};
  const Certificate& certificate = points.certificate;
  if (!points.clusters.empty()) sheet.facts.push_back({"clusters", std::to_string(points.clusters.size())});
  if (certificate.cells_examined > 0) {
    sheet.facts.push_back({"cells searched", draw::figure_text(certificate.cells_examined)});
    sheet.facts.push_back({"without a zero", draw::figure_text(certificate.cells_excluded)});
    sheet.facts.push_back({"with at most one", draw::figure_text(certificate.cells_isolated)});
    sheet.facts.push_back({"greatest depth", std::to_string(certificate.greatest_depth)});
  }
  for (const JsonObject& layer : node_layers(points, frame)) sheet.layers.push_back(layer);
  if (!points.zeros.empty())
    sheet.layers.push_back(zeros_of(points, frame).layer("zeros", "zeros of the field", false));
  if (!points.changes.empty())
    sheet.layers.push_back(changes_of(points, frame).layer("changes", "nodes before changes"));
  sheet.layers.push_back(corners_of(points, frame).layer("corners", "corners"));
  sheet.layers.push_back(nodes_of(points, frame).layer("nodes", "nodes"));
  return sheet;
}

template Sheet stage_sheet(const CriticalPoints&, const PageFrame&);

}  // namespace quadrille::page
