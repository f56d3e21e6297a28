// Separatrices and blocks: chains of curves, with the nodes of their graph.

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/enum_names.hpp"
#include "draw/marks.hpp"
#include "model/interfaces.hpp"
#include "page/sheet.hpp"

namespace quadrille::page {

namespace {

struct NamedChains {
  Chains chains;
  std::vector<std::string> names;
  std::vector<std::int32_t> colours;  ///< number of a series of colours; -1: the colour of thin lines
};

JsonObject chains_layer(const NamedChains& named, const std::string& key, const std::string& title,
                        const std::string& noun, const std::string& style) {
  JsonObject layer;
  layer.text("type", "chains").text("key", key).text("title", title).text("noun", noun).text("style", style);
  layer.flag("shown", true).json("names", json_texts(named.names)).data("colours", packed(named.colours));
  layer.data("offsets", packed(named.chains.offsets)).data("points", packed(named.chains.points));
  return layer;
}

void append_arc(Chains& chains, const ArcGraph& graph, int arc, const PageFrame& frame) {
  chains.append(frame, graph.arcs[arc].pieces, [&](int id) -> const Nurbs& { return graph.curve(id); });
}

NamedChains blocks_of(const BlockLayout& layout, const PageFrame& frame) {
  NamedChains blocks;
  for (int b = 0; b < layout.num_blocks(); ++b) {
    for (const HalfEdge side : layout.block2arcs[b])
      for (const ArcPiece& piece : draw::side_pieces(layout, side))
        blocks.chains.append_piece(frame, layout.curve(piece.curve), piece.t0, piece.t1);
    blocks.chains.close_chain();
    blocks.names.push_back(b < static_cast<int>(layout.block_names.size()) ? layout.block_names[b] : "");
    blocks.colours.push_back(layout.block_region.empty() ? b : layout.block_region[b]);
  }
  return blocks;
}

NamedChains arcs_of(const BlockLayout& layout, const PageFrame& frame) {
  NamedChains arcs;
  for (int a = 0; a < static_cast<int>(layout.arcs.size()); ++a) {
    append_arc(arcs.chains, layout, a, frame);
    arcs.names.push_back(layout.arc_chord.empty() ? "" : fmt::format("chord {}", layout.arc_chord[a]));
    arcs.colours.push_back(-1);
  }
  return arcs;
}

NamedChains lines_of(const SeparatrixGraph& graph, const PageFrame& frame) {
  NamedChains lines;
  std::set<int> drawn;
  const auto add = [&](int arc, int colour, const std::string& name) {
    append_arc(lines.chains, graph, arc, frame);
    lines.names.push_back(name);
    lines.colours.push_back(colour);
    drawn.insert(arc);
  };
  for (std::size_t i = 0; i < graph.lines.size(); ++i) {
    const SeparatrixLine& line = graph.lines[i];
    for (const int arc : line.arcs)
      add(arc, line.origin,
          fmt::format("separatrix {} from node {} to node {}, {}", i, line.origin, line.end, enum_name(line.kind)));
  }
  for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a)
    if (!is_on_cad_curve(graph, graph.arcs[a]) && !drawn.contains(a)) add(a, -1, fmt::format("arc {}", a));
  return lines;
}

}  // namespace

Sheet stage_sheet(const SeparatrixGraph& graph, const PageFrame& frame) {
  Sheet sheet;
  sheet.title = "Separatrices";
  sheet.caption = fmt::format("{} separatrices, {} nodes", graph.lines.size(), graph.nodes.size());
  sheet.facts = draw::figures_of(graph);
  sheet.layers.push_back(chains_layer(lines_of(graph, frame), "lines", "separatrices", "", "line"));
  sheet.layers.push_back(marks_of(graph, frame, true).layer("nodes", "nodes"));
  return sheet;
}

Sheet stage_sheet(const BlockLayout& layout, const PageFrame& frame) {
  Sheet sheet;
  const std::set<int> chords(layout.arc_chord.begin(), layout.arc_chord.end());
  sheet.title = "Blocks";
  sheet.caption = fmt::format("{} blocks, {} chords", layout.num_blocks(), chords.size());
  sheet.facts = draw::figures_of(layout);
  const std::vector<double>& quality = layout.block_scaled_jacobian;
  if (!quality.empty())
    sheet.facts.push_back(
        {"worst scaled Jacobian", draw::figure_text(*std::min_element(quality.begin(), quality.end()))});
  JsonObject blocks = chains_layer(blocks_of(layout, frame), "blocks", "blocks", "block", "block");
  blocks.json("quantities", quantities_json({{"scaled Jacobian", "low", 0, 1, quality}}));
  sheet.layers.push_back(blocks);
  sheet.layers.push_back(chains_layer(arcs_of(layout, frame), "arcs", "arcs", "arc", "arc"));
  sheet.layers.push_back(marks_of(layout, frame, false).layer("nodes", "irregular nodes"));
  return sheet;
}

}  // namespace quadrille::page
