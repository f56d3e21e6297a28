#pragma once
// An Exodus II file as its parts, of quadrilaterals and of hexahedra alike. Private to exodus*.

#include <cstdint>
#include <string>
#include <vector>

#include "export/netcdf_request.hpp"

namespace quadrille::exports {

/// Names in the file have at most this many characters.
inline constexpr std::size_t longest_exodus_name = 32;

/// Elements of one type; nodes count from 1.
struct ExodusBlock {
  std::string name, type;
  int nodes_per_elem = 0;
  std::vector<std::int32_t> nodes;
};

/// Sides of elements, which count block by block from 1, as sides do.
struct ExodusSideSet {
  std::string name;
  std::vector<std::int32_t> elems, sides;
};

struct ExodusModel {
  std::string title;
  std::vector<std::vector<double>> x;  ///< by coordinate: two or three
  std::vector<ExodusBlock> blocks;     ///< none of them empty
  std::vector<ExodusSideSet> side_sets;
};

/// The file as quadexport-netcdf makes it.
NetcdfRequest exodus_request(ExodusModel model);

}  // namespace quadrille::exports
