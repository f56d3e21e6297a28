#include "cgns/write_cgns.hpp"

#include <cgns_io.h>
#include <cgnslib.h>
#include <sys/time.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <vector>

#include "base/error.hpp"

/// HDF5 asks for the time with this function, and writes it into each object, which the CGNS library cannot switch off:
/// the programs that are linked with this folder have the time 0, so that the same request gives the same bytes.
extern "C" int gettimeofday(timeval* time, void* /*zone*/) noexcept {
  *time = {};
  return 0;
}

namespace quadrille::cgns {

namespace {

constexpr std::array<const char*, 3> coordinate_names{"CoordinateX", "CoordinateY", "CoordinateZ"};

void require(int status) {
  if (status != CG_OK) throw OutputError(std::string("the CGNS library reports: ") + cg_get_error());
}

/// The number of a word in one of the library's tables of names.
template <typename Enum>
Enum value_of(const std::string& word, const char* const* names, int count) {
  for (int k = 0; k < count; ++k)
    if (word == names[k]) return static_cast<Enum>(k);
  throw Defect("write_cgns: unknown word " + word);
}

std::vector<double> children(int file, double node) {
  int count = 0, found = 0;
  cgio_number_children(file, node, &count);
  std::vector<double> nodes(count);
  if (count > 0) cgio_children_ids(file, node, 1, count, &found, nodes.data());
  return nodes;
}

/// Labels fill 33 characters in the file, and the library leaves in some what was in memory behind their end: these
/// characters become zeros, in all nodes below this one.
void clear_behind_labels(int file, double node) {
  std::array<char, CGIO_MAX_LABEL_LENGTH + 1> label{}, clean{};
  if (cgio_get_label(file, node, label.data()) != CGIO_ERR_NONE) throw OutputError("the CGNS file has no label");
  std::copy(label.begin(), std::find(label.begin(), label.end(), '\0'), clean.begin());
  cgio_set_label(file, node, clean.data());
  for (const double child : children(file, node)) clear_behind_labels(file, child);
}

void clear_behind_labels(const std::string& path) {
  int file = 0;
  double root = 0;
  if (cgio_open_file(path.c_str(), CGIO_MODE_MODIFY, CGIO_FILE_HDF5, &file) != CGIO_ERR_NONE)
    throw OutputError(path + ": the CGNS file cannot be read back");
  cgio_get_root_id(file, &root);
  for (const double child : children(file, root)) clear_behind_labels(file, child);
  cgio_close_file(file);
}

/// The file, closed and removed at the end.
class CgnsFile {
 public:
  explicit CgnsFile(std::string path) : path_(std::move(path)) {
    require(cg_set_file_type(CG_FILE_HDF5));
    require(cg_open(path_.c_str(), CG_MODE_WRITE, &file_));
  }
  CgnsFile(const CgnsFile&) = delete;
  CgnsFile& operator=(const CgnsFile&) = delete;
  ~CgnsFile() {
    if (file_ > 0) cg_close(file_);
    std::remove(path_.c_str());
  }

  std::string written(const exports::CgnsRequest& request) {
    const int dimension = static_cast<int>(request.zones.front().x.size());
    require(cg_base_write(file_, "base", request.cell_dimension, dimension, &base_));
    side_location_ = request.cell_dimension == 3 ? CGNS_ENUMV(FaceCenter) : CGNS_ENUMV(EdgeCenter);
    for (const exports::CgnsFamily& family : request.families) write_family(family);
    for (const exports::CgnsZone& zone : request.zones) write_zone(zone, request.is_structured);
    require(cg_close(file_));
    file_ = 0;
    clear_behind_labels(path_);
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

 private:
  void write_family(const exports::CgnsFamily& family) {
    int number = 0, condition = 0;
    require(cg_family_write(file_, base_, family.name.c_str(), &number));
    if (family.boundary.empty()) return;
    const auto type = value_of<CGNS_ENUMT(BCType_t)>(family.boundary, BCTypeName, NofValidBCTypes);
    require(cg_fambc_write(file_, base_, number, "FamBC", type, &condition));
  }

  void write_zone(const exports::CgnsZone& zone, bool is_structured) {
    int number = 0, ignored = 0;
    // Structured: points, cells, 0 of each direction. Unstructured: points, cells, 0.
    std::vector<cgsize_t> size(zone.size.begin(), zone.size.end());
    if (is_structured)
      for (const std::int64_t points : zone.size) size.push_back(static_cast<cgsize_t>(points - 1));
    size.resize(size.size() + (is_structured ? zone.size.size() : 1), 0);
    require(cg_zone_write(file_, base_, zone.name.c_str(), size.data(),
                          is_structured ? CGNS_ENUMV(Structured) : CGNS_ENUMV(Unstructured), &number));
    if (!zone.family.empty()) {
      require(cg_goto(file_, base_, "Zone_t", number, "end"));
      require(cg_famname_write(zone.family.c_str()));
    }
    for (std::size_t c = 0; c < zone.x.size(); ++c)
      require(cg_coord_write(file_, base_, number, CGNS_ENUMV(RealDouble), coordinate_names[c], zone.x[c].data(),
                             &ignored));
    for (const exports::CgnsSection& section : zone.sections) write_section(number, section);
    for (const exports::CgnsBoundary& boundary : zone.boundaries) write_boundary(number, boundary, is_structured);
    for (const exports::CgnsConnection& c : zone.connections) write_connection(number, c);
  }

  void write_section(int zone, const exports::CgnsSection& section) {
    int ignored = 0;
    const std::vector<cgsize_t> nodes(section.nodes.begin(), section.nodes.end());
    const auto type = value_of<CGNS_ENUMT(ElementType_t)>(section.type, ElementTypeName, NofValidElementTypes);
    require(cg_section_write(file_, base_, zone, section.name.c_str(), type, static_cast<cgsize_t>(section.first),
                             static_cast<cgsize_t>(section.first + section.count - 1), 0, nodes.data(), &ignored));
  }

  void write_boundary(int zone, const exports::CgnsBoundary& boundary, bool is_structured) {
    int number = 0;
    const std::vector<cgsize_t> range(boundary.range.begin(), boundary.range.end());
    require(cg_boco_write(file_, base_, zone, boundary.name.c_str(), CGNS_ENUMV(FamilySpecified),
                          CGNS_ENUMV(PointRange), 2, range.data(), &number));
    if (!is_structured) require(cg_boco_gridlocation_write(file_, base_, zone, number, side_location_));
    require(cg_goto(file_, base_, "Zone_t", zone, "ZoneBC_t", 1, "BC_t", number, "end"));
    require(cg_famname_write(boundary.family.c_str()));
  }

  void write_connection(int zone, const exports::CgnsConnection& c) {
    int ignored = 0;
    const std::vector<cgsize_t> range(c.range.begin(), c.range.end()),
        donor(c.donor_range.begin(), c.donor_range.end());
    const std::vector<int> transform(c.transform.begin(), c.transform.end());
    require(cg_1to1_write(file_, base_, zone, c.name.c_str(), c.donor.c_str(), range.data(), donor.data(),
                          transform.data(), &ignored));
  }

  std::string path_;
  int file_ = 0, base_ = 0;
  CGNS_ENUMT(GridLocation_t) side_location_ = CGNS_ENUMV(EdgeCenter);
};

}  // namespace

std::string cgns_file(const exports::CgnsRequest& request, const std::string& path) {
  return CgnsFile(path).written(request);
}

}  // namespace quadrille::cgns
