#pragma once
// Counts and qualities of layouts and meshes, as label and value: for the tables of pages and comparisons.

#include <string>
#include <vector>

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

/// Of the measures of shape that a comparison adds: least or greatest, and median.
std::vector<Figure> quality_figures_of(const SeparatrixGraph& graph);
std::vector<Figure> quality_figures_of(const BlockLayout& layout);
std::vector<Figure> quality_figures_of(const QuadMesh& mesh);

/// "0.0123": four significant digits.
std::string figure_text(double value);

}  // namespace quadrille::draw
