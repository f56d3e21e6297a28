#pragma once
// Counts and qualities of layouts and meshes, as label and value: for the tables of pages, and for the picture of two
// of them side by side at one scale, above a table of the figures of both.

#include <array>
#include <string>
#include <vector>

#include "draw/draw.hpp"
#include "model/block_layout.hpp"
#include "model/quad_mesh.hpp"
#include "model/separatrix_graph.hpp"

namespace quadrille::draw {

struct Figure {
  std::string label, value;
};

std::vector<Figure> figures_of(const SeparatrixGraph& graph);
std::vector<Figure> figures_of(const BlockLayout& layout);
std::vector<Figure> figures_of(const QuadMesh& mesh);
std::vector<Figure> figures_of(const HexMesh& mesh);

/// That have elements.
int num_blocks(const QuadMesh& mesh);

/// Of the measures of shape that a comparison adds: least or greatest, and median.
std::vector<Figure> quality_figures_of(const SeparatrixGraph& graph);
std::vector<Figure> quality_figures_of(const BlockLayout& layout);
std::vector<Figure> quality_figures_of(const QuadMesh& mesh);

/// "0.0123": four significant digits.
std::string figure_text(double value);

/// Whether it is a layout or a mesh, of which two can be compared.
bool is_comparable(const StageModel& stage);

/// Two stages of one format, comparable, which need not be of one chain; both show the same part of the plane,
/// `options.window` or what both faces cover. `files` are the names that are written above the drawings. UsageError:
/// nothing of one of them is in the window.
std::string draw_comparison(const StageModel& a, const StageModel& b, const std::array<std::string, 2>& files,
                            const DrawOptions& options);

}  // namespace quadrille::draw
