#pragma once
// What quadexport asks of quadexport-cgns, which is linked with the CGNS library: a CGNS file as structs, with the
// words of the standard (SIDS), and these structs as bytes. Numbers count from 1, as in the file.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace quadrille::exports {

struct CgnsFamily {
  std::string name;
  std::string boundary;  ///< word of BCType_t; empty: not a boundary
};

/// Elements of one type, numbered from `first` on.
struct CgnsSection {
  std::string name;
  std::string type;  ///< word of ElementType_t
  std::int64_t first = 1, count = 0;
  std::vector<std::int64_t> nodes;
};

/// Of a structured zone a range of points (i, j) to (i, j); of an unstructured one a range of elements, in the first
/// and third number: bars, or faces of hexahedra.
struct CgnsBoundary {
  std::string name, family;
  std::array<std::int64_t, 4> range{};
};

/// Points of a zone, from (i, j) to (i, j), that are those of the donor in the same order. `transform`: the direction
/// of the donor, 1 or 2 with its sign, of each own direction.
struct CgnsConnection {
  std::string name, donor;
  std::array<std::int64_t, 4> range{}, donor_range{};
  std::array<std::int64_t, 2> transform{1, 2};
};

struct CgnsZone {
  std::string name, family;            ///< family: empty for none
  std::vector<std::int64_t> size;      ///< points in i and j; of an unstructured zone points and cells
  std::vector<std::vector<double>> x;  ///< by coordinate
  std::vector<CgnsSection> sections;   ///< of an unstructured zone
  std::vector<CgnsBoundary> boundaries;
  std::vector<CgnsConnection> connections;  ///< of a structured zone
};

struct CgnsRequest {
  bool is_structured = false;
  std::int32_t cell_dimension = 2;
  std::vector<CgnsFamily> families;
  std::vector<CgnsZone> zones;
};

std::string to_bytes(const CgnsRequest& request);

/// Throws Defect if the bytes are not those of a request.
CgnsRequest cgns_request(const std::string& bytes);

}  // namespace quadrille::exports
