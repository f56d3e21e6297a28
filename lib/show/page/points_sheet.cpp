// Critical points, corners and boundary nodes as marks; below them how they came about: cells and discs of the search
// for zeros, clusters with their members, error bars, arrows of changes, the directions in which separatrices start at
// zeros. At first the nodes alone are shown.

#include <fmt/format.h>

#include <algorithm>

#include "base/angle.hpp"
#include "base/enum_names.hpp"
#include "base/message_text.hpp"
#include "page/sheet.hpp"
#include "trace/launch_directions.hpp"

namespace quadrille::page {

namespace {

/// Circles of a radius in the plane, at least `least_pixels`; smaller ones are omitted if `is_to_scale`.
class Discs {
 public:
  explicit Discs(const PageFrame& frame) : frame_(frame) {}
  void add(Vec2 centre, double radius, const std::string& text) {
    frame_.append(centres_, centre);
    radii_.push_back(radius);
    texts_.push_back(text);
  }
  void append_to(std::vector<JsonObject>& layers, const std::string& key, const std::string& title, double least_pixels,
                 bool is_to_scale) const {
    if (radii_.empty()) return;
    JsonObject layer;
    layer.text("type", "discs").text("key", key).text("title", title).text("noun", "").flag("shown", false);
    layer.number("leastPixels", least_pixels).flag("toScale", is_to_scale).json("names", json_texts(texts_));
    layer.data("points", packed(centres_)).data("radii", packed_floats(radii_));
    layers.push_back(layer);
  }

 private:
  const PageFrame& frame_;
  std::vector<std::int32_t> centres_;
  std::vector<double> radii_;
  std::vector<std::string> texts_;
};

/// Arrows from point to point.
class Arrows {
 public:
  explicit Arrows(const PageFrame& frame) : frame_(frame) {}
  void add(Vec2 from, Vec2 to, const std::string& text) {
    frame_.append(ends_, from);
    frame_.append(ends_, to);
    texts_.push_back(text);
  }
  /// `pixels`: the length of all of them, or 0: to their second points.
  void append_to(std::vector<JsonObject>& layers, const std::string& key, const std::string& title,
                 double pixels) const {
    if (texts_.empty()) return;
    JsonObject layer;
    layer.text("type", "arrows").text("key", key).text("title", title).text("noun", "").flag("shown", false);
    layer.number("pixels", pixels).json("names", json_texts(texts_)).data("points", packed(ends_));
    layers.push_back(layer);
  }

 private:
  const PageFrame& frame_;
  std::vector<std::int32_t> ends_;
  std::vector<std::string> texts_;
};

/// Triangles as closed chains of straight pieces.
void append_cells(std::vector<JsonObject>& layers, const Certificate& certificate, const PageFrame& frame) {
  if (certificate.cells.empty()) return;
  std::vector<std::int32_t> offsets{0}, points;
  std::vector<std::string> texts;
  for (const CertificateCell& cell : certificate.cells) {
    const auto vertex = [&](int k) { return Vec2{cell.vertices[2 * (k % 3)], cell.vertices[2 * (k % 3) + 1]}; };
    frame.append(points, vertex(0));
    for (int k = 0; k < 3; ++k)
      for (int third = 1; third <= 3; ++third)
        frame.append(points, vertex(k) + third / 3.0 * (vertex(k + 1) - vertex(k)));
    offsets.push_back(static_cast<std::int32_t>(points.size() / 2));
    const bool is_open = cell.verdict == CellVerdict::open;
    texts.push_back(fmt::format("cell of the search in triangle {}: {}", cell.elem,
                                is_open ? "could not be decided" : "holds exactly one zero"));
  }
  JsonObject layer;
  layer.text("type", "chains").text("key", "cells").text("title", "cells of the search").text("noun", "");
  layer.text("style", "search").flag("shown", false).json("names", json_texts(texts));
  layers.push_back(layer.data("offsets", packed(offsets)).data("points", packed(points)));
}

void append_discs(std::vector<JsonObject>& layers, const CriticalPoints& points, const PageFrame& frame) {
  const Certificate& certificate = points.certificate;
  Discs left_out(frame), clusters(frame), members(frame), errors(frame);
  for (std::size_t i = 0; i < std::min(certificate.disc_centres.size(), certificate.disc_radii.size()); ++i)
    left_out.add(certificate.disc_centres[i], certificate.disc_radii[i], "left to the corner by the search");
  for (const Cluster& cluster : points.clusters) {
    const int count = static_cast<int>(cluster.members.size());
    clusters.add(cluster.centre, cluster.radius,
                 fmt::format("cluster of index {:+}, {}, radius {:.3g}", cluster.index, counted(count, "member"),
                             cluster.radius));
    for (const Vec2 member : cluster.members) members.add(member, 0, "zero of a cluster");
  }
  for (const CriticalPoint& p : points.critical_points)
    if (p.error > 0) errors.add(p.position, p.error, fmt::format("error bar of the position: {:.3g}", p.error));
  left_out.append_to(layers, "left", "left to corners by the search", 0, false);
  clusters.append_to(layers, "clusters", "clusters", 16, false);
  members.append_to(layers, "members", "zeros of clusters", 2, false);
  errors.append_to(layers, "errors", "error bars", 0, true);
}

const NodeMark& nearest(const std::vector<NodeMark>& marks, Vec2 x) {
  return *std::min_element(marks.begin(), marks.end(), [&](const NodeMark& a, const NodeMark& b) {
    return distance(a.position, x) < distance(b.position, x);
  });
}

/// From each mark before to the nearest one after, and to those after that no mark reached.
void append_changes(std::vector<JsonObject>& layers, const CriticalPoints& points, const PageFrame& frame) {
  Arrows arrows(frame);
  for (const NodeChange& change : points.changes) {
    if (change.before.empty() || change.after.empty()) continue;
    const std::string text = enum_name(change.kind) + ": " + change.reason;
    std::vector<Vec2> reached;
    for (const NodeMark& mark : change.before) {
      reached.push_back(nearest(change.after, mark.position).position);
      arrows.add(mark.position, reached.back(), text);
    }
    for (const NodeMark& mark : change.after)
      if (std::find(reached.begin(), reached.end(), mark.position) == reached.end())
        arrows.add(nearest(change.before, mark.position).position, mark.position, text);
  }
  arrows.append_to(layers, "arrows", "arrows of changes", 0);
}

/// Nodes that are no zeros have no Jacobian, from which the directions follow.
void append_directions(std::vector<JsonObject>& layers, const CriticalPoints& points, const PageFrame& frame) {
  Arrows arrows(frame);
  for (const CriticalPoint& p : points.critical_points) {
    const Mat2 jacobian{p.jacobian[0], p.jacobian[1], p.jacobian[2], p.jacobian[3]};
    if (p.source != NodeSource::zero || det(jacobian) == 0) continue;
    for (const double angle : trace::launch_directions(jacobian))
      arrows.add(p.position, p.position + 0.01 * frame.extent * unit(angle),
                 fmt::format("a separatrix starts at {:.2f}°", degrees(angle)));
  }
  arrows.append_to(layers, "directions", "directions of separatrices", 30);
}

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

Sheet stage_sheet(const CriticalPoints& points, const PageFrame& frame) {
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
  append_cells(sheet.layers, points.certificate, frame);
  append_discs(sheet.layers, points, frame);
  append_changes(sheet.layers, points, frame);
  append_directions(sheet.layers, points, frame);
  if (!points.zeros.empty())
    sheet.layers.push_back(zeros_of(points, frame).layer("zeros", "zeros of the field", false));
  if (!points.changes.empty())
    sheet.layers.push_back(changes_of(points, frame).layer("changes", "nodes before changes", false));
  sheet.layers.push_back(corners_of(points, frame).layer("corners", "corners", false));
  sheet.layers.push_back(nodes_of(points, frame).layer("nodes", "nodes"));
  return sheet;
}

}  // namespace quadrille::page
