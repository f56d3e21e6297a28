#include "page/sheet.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/enum_names.hpp"
#include "base/message_text.hpp"
#include "draw/labels.hpp"

namespace quadrille::page {

namespace {

/// The name of each region, with the place of its label: [name, x, y, half of the width that is free there].
std::string regions_json(const CadFace& face, const PageFrame& frame) {
  std::vector<std::string> regions;
  for (int r = 0; r < face.num_regions(); ++r) {
    const std::vector<draw::RegionPlace> places = draw::region_places(face, r);
    if (places.empty()) continue;
    const auto& [at, clearance] = places.front();
    const Vec2 x = at - frame.centre;
    regions.push_back(json_list({script_string(face.region_names[r]), fmt::format("{:.9g}", x.x),
                                 fmt::format("{:.9g}", x.y), fmt::format("{:.9g}", clearance)}));
  }
  return json_list(regions);
}

}  // namespace

JsonObject boundary_layer(const CadFace& face, const PageFrame& frame) {
  Chains chains;
  for (const Nurbs& curve : face.curves) {
    chains.append_piece(frame, curve, curve.begin(), curve.end());
    chains.close_chain();
  }
  JsonObject layer;
  layer.text("type", "chains").text("key", "boundary").text("title", "boundary").text("noun", "curve");
  layer.text("style", "boundary").flag("shown", true).json("names", json_texts(face.curve_names));
  layer.data("offsets", packed(chains.offsets)).data("points", packed(chains.points));
  layer.data("runs", packed(std::vector<std::int32_t>(draw::name_runs(face))));
  if (!face.partners.empty()) layer.data("partners", packed(std::vector<std::int32_t>(face.partners)));
  if (face.num_regions() > 1) layer.json("regions", regions_json(face, frame));
  return layer;
}

Quantity bounds_of_jacobian(const std::vector<double>& bounds) {
  const double least = bounds.empty() ? 0 : *std::min_element(bounds.begin(), bounds.end());
  const double reach = least < 0 ? -least : 0;
  return {"proved bound of det J", "low", -reach, reach, bounds};
}

std::string quantities_json(const std::vector<Quantity>& quantities) {
  std::vector<std::string> list;
  for (const Quantity& quantity : quantities) {
    if (quantity.values.empty()) continue;
    JsonObject object;
    object.text("title", quantity.title).text("worst", quantity.worst).flag("log", quantity.is_logarithmic);
    object.number("low", quantity.low).number("high", quantity.high).data("values", packed_floats(quantity.values));
    list.push_back(object.str());
  }
  return json_list(list);
}

void Marks::add(const PageFrame& frame, Vec2 x, int valence, const std::string& kind, const std::string& text) {
  frame.append(positions, x);
  valences.push_back(valence);
  kinds.push_back(kind);
  texts.push_back(text);
}

JsonObject Marks::layer(const std::string& key, const std::string& title, bool is_shown) const {
  JsonObject layer;
  layer.text("type", "marks").text("key", key).text("title", title).text("noun", "node").flag("shown", is_shown);
  layer.data("points", packed(positions)).data("valences", packed(valences));
  layer.json("kinds", json_texts(kinds)).json("names", json_texts(texts));
  return layer;
}

Marks marks_of(const ArcGraph& graph, const PageFrame& frame, bool with_crossings) {
  Marks marks;
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    const GraphNode& node = graph.nodes[n];
    const bool is_boundary_node = node.kind == NodeKind::boundary && node.valence != 2;
    const bool is_irregular_on_interface = node.curve >= 0 && node.is_inner() && node.valence != 4;
    const std::string kind = node.kind == NodeKind::irregular ? "node"
                             : node.kind == NodeKind::corner  ? "corner"
                             : is_boundary_node               ? "boundary"
                             : is_irregular_on_interface      ? "node"
                                                              : "dot";
    if (kind == "dot" && !with_crossings) continue;
    marks.add(frame, node.position, node.valence, kind,
              fmt::format("node {}: {}, valence {}", n, enum_name(node.kind), node.valence));
  }
  return marks;
}

}  // namespace quadrille::page
