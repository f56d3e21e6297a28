#include "export/cgns_request.hpp"

#include "base/byte_archive.hpp"

namespace quadrille::exports {

namespace {

struct Members {
  static void of(auto& archive, Is<CgnsFamily> auto& f) { archive(f.name, f.boundary); }
  static void of(auto& archive, Is<CgnsSection> auto& s) { archive(s.name, s.type, s.first, s.count, s.nodes); }
  static void of(auto& archive, Is<CgnsBoundary> auto& b) { archive(b.name, b.family, b.range); }
  static void of(auto& archive, Is<CgnsConnection> auto& c) {
    archive(c.name, c.donor, c.range, c.donor_range, c.transform);
  }
  static void of(auto& archive, Is<CgnsZone> auto& z) {
    archive(z.name, z.family, z.size, z.x, z.sections, z.boundaries, z.connections);
  }
  static void of(auto& archive, Is<CgnsRequest> auto& r) {
    archive(r.is_structured, r.cell_dimension, r.families, r.zones);
  }
};

}  // namespace

std::string to_bytes(const CgnsRequest& request) { return to_bytes_by<Members>(request); }

CgnsRequest cgns_request(const std::string& bytes) {
  CgnsRequest request;
  from_bytes_by<Members>(bytes, request);
  return request;
}

}  // namespace quadrille::exports
