#pragma once
// What quadexport asks of quadexport-cgns, which is linked with the CGNS library: a CGNS file as structs, with the
// words of the standard (SIDS), and these structs as bytes. Numbers count from 1, as in the file.

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

/// Of a structured zone a range of points: the numbers of the first one, then those of the last; of an unstructured one
/// the first and last of its elements: bars, or faces of hexahedra.
struct CgnsBoundary {
  std::string name, family;
  std::vector<std::int64_t> range;
};

/// Points of a zone that are those of the donor in the same order; ranges as above. `transform`: the direction of the
/// donor, 1 to 3 with its sign, of each own direction.
struct CgnsConnection {
  std::string name, donor;
  std::vector<std::int64_t> range, donor_range, transform;
};

struct CgnsZone {
  std::string name, family;            ///< family: empty for none
  std::vector<std::int64_t> size;      ///< points in each direction; of an unstructured zone points and cells
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
