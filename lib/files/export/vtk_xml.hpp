#pragma once
// VTK's XML of unstructured grids of one type of cells: arrays inline, base64, little endian. Private to vtu*.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "model/provenance.hpp"

namespace quadrille::exports {

/// An array: of cells one value each, of field data any number.
template <typename Value>
struct VtkArray {
  std::string name;
  std::vector<Value> values;
};

/// One unstructured grid of cells of one type.
struct VtkGrid {
  std::vector<std::array<double, 3>> points;
  std::uint8_t cell_type = 0;
  int nodes_per_cell = 0;
  std::vector<int> connectivity;  ///< nodes_per_cell for each cell
  std::vector<VtkArray<int>> cell_integers;
  std::vector<VtkArray<double>> cell_reals;
  std::vector<VtkArray<std::string>> texts;
  const char* version = "1.0";  ///< of the file
};

/// The whole file.
std::string vtk_xml(const VtkGrid& grid);

/// VTK's types of the cells of one kind of nodes.
struct VtkCellTypes {
  std::uint8_t curve, quad, hex;
};
inline constexpr VtkCellTypes lagrange_cells{68, 70, 72}, bezier_cells{75, 77, 79};

/// VTK's order of the local nodes of a quad: corners, the sides bottom, right, top, left all in the direction of rising
/// xi, then the inner ones, xi1 fastest.
std::vector<int> vtk_quad_order(int order);

/// One line for each stage: tool, version, options.
std::vector<std::string> provenance_lines(const Provenance& chain);

}  // namespace quadrille::exports
