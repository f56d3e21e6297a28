#pragma once
// One unstructured grid of cells of one type as VTK's XML (.vtu): arrays inline, base64, little endian. Private to vtu.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace quadrille::exports {

struct VtkIntegers {
  std::string name;
  std::vector<int> values;  ///< one for each cell
};

struct VtkReals {
  std::string name;
  std::vector<double> values;  ///< one for each cell
};

struct VtkTexts {
  std::string name;
  std::vector<std::string> values;  ///< any number: field data
};

struct VtkGrid {
  std::vector<std::array<double, 3>> points;
  std::uint8_t cell_type = 0;
  int nodes_per_cell = 0;
  std::vector<int> connectivity;  ///< nodes_per_cell for each cell
  std::vector<VtkIntegers> cell_integers;
  std::vector<VtkReals> cell_reals;
  std::vector<VtkTexts> texts;
};

std::string vtk_xml(const VtkGrid& grid);

}  // namespace quadrille::exports
