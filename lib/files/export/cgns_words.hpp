#pragma once
// What quads and hexahedra have in common in a CGNS file: names of families and their types, elements of the standard
// (SIDS).

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "export/cgns_request.hpp"
#include "export/exported.hpp"
#include "export/groups.hpp"

namespace quadrille::exports {

/// Types of elements by their order.
inline constexpr std::array<const char*, 5> bar_types{"", "BAR_2", "BAR_3", "BAR_4", "BAR_5"};
inline constexpr std::array<const char*, 5> cgns_quad_types{"", "QUAD_4", "QUAD_9", "QUAD_16", "QUAD_25"};
inline constexpr std::array<const char*, 5> cgns_hex_types{"", "HEXA_8", "HEXA_27", "HEXA_64", "HEXA_125"};

/// Words for boundaries, then for regions: all different, because families of both stand side by side.
PlainNames family_names(const Groups& groups, Exported& exported);

/// The first `num_boundaries` boundaries, with types by their names, and the regions.
std::vector<CgnsFamily> families(const Groups& groups, const PlainNames& words, int num_boundaries);

/// The nodes of a quad: corners, then sides counter-clockwise, then the rings inside in the same way, corner first.
std::vector<int> cgns_quad_order(int order);

/// Sections of an unstructured zone, one after another.
class CgnsSections {
 public:
  /// An empty section for the elements that follow.
  CgnsSection begin(const std::string& name, const char* type) const { return {name, type, next_, 0, {}}; }
  /// Adds the section to the zone, unless it is empty. `is_boundary`: the zone gets a boundary of its name too.
  void add(CgnsSection section, bool is_boundary, CgnsZone& zone);

 private:
  std::int64_t next_ = 1;  ///< number of the next element
};

}  // namespace quadrille::exports
