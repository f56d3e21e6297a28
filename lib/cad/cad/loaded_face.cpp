#include "cad/loaded_face.hpp"

#include <concepts>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include "base/error.hpp"

namespace quadrille::cad {

namespace {

template <class T, class Struct>
concept Is = std::same_as<std::remove_const_t<T>, Struct>;

// One list of members serves both writing and reading. Those of a joint are named because the padding after the last
// one is not data.
void members(auto& a, Is<Joint> auto& j) { a(j.position, j.tangent_in, j.tangent_out, j.interior_angle, j.is_corner); }
void members(auto& a, Is<Nurbs> auto& c) { a(c.degree, c.knots, c.poles, c.weights); }
void members(auto& a, Is<ListedShape> auto& s) { a(s.name, s.kind, s.length, s.place); }
void members(auto& a, Is<ListedFace> auto& f) { a(f.face, f.part, f.layer, f.edges, f.size, f.is_closed); }
void members(auto& a, Is<FaceList> auto& l) { a(l.length_unit, l.faces, l.not_built); }
void members(auto& a, Is<CadFace> auto& f) {
  a(f.length_unit, f.metres_per_unit, f.plane_origin, f.plane_x, f.plane_y, f.origin, f.diameter, f.fit_distance);
  a(f.curves, f.curve_names, f.unnamed_curves, f.curve_cad_edges, f.loop_offsets, f.joints, f.name);
  a(f.region_loops, f.region_names, f.partners);
}
void members(auto& a, Is<SpaceCurve> auto& c) { a(c.degree, c.knots, c.poles, c.weights); }
void members(auto& a, Is<NurbsSurface> auto& s) {
  a(s.degree_u, s.degree_v, s.knots_u, s.knots_v, s.poles, s.weights, s.is_closed_u, s.is_closed_v);
}
void members(auto& a, Is<FineBoundaryEdge> auto& e) { a(e.vertices, e.curve, e.t0, e.t1); }
void members(auto& a, Is<SpaceFace> auto& f) {
  a(f.face, f.curves, f.surface, f.is_reversed, f.vertices, f.triangles, f.triangle_uv, f.boundary_edges);
}
void members(auto& a, Is<LoadedFace> auto& l) { a(l.face, l.repairs); }
void members(auto& a, Is<LoadOptions> auto& o) {
  a(o.corner_angle, o.heal_tolerance, o.face, o.blunt_width, o.fit_tolerance, o.section);
}
void members(auto& a, Is<CadRequest> auto& r) { a(r.task, r.name, r.bytes, r.options, r.face); }
void members(auto& a, Is<Report::Warning> auto& w) { a(w.code, w.message); }
void members(auto& a, Is<std::pair<std::string, Report::Value>> auto& entry) { a(entry.first, entry.second); }

class Writer {
 public:
  template <class... Values>
  void operator()(const Values&... values) {
    (write(values), ...);
  }
  std::string bytes;

 private:
  void write(const auto& value) {
    if constexpr (requires { members(*this, value); })
      members(*this, value);
    else
      bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void write(const std::string& text) {
    write(static_cast<std::uint64_t>(text.size()));
    bytes += text;
  }
  template <class T>
  void write(const std::vector<T>& values) {
    write(static_cast<std::uint64_t>(values.size()));
    for (const T& value : values) write(value);
  }
  void write(const Report::Value& value) {
    write(static_cast<std::uint64_t>(value.index()));
    std::visit([&](const auto& v) { write(v); }, value);
  }
};

class Reader {
 public:
  explicit Reader(const std::string& bytes) : bytes_(bytes) {}

  template <class... Values>
  void operator()(Values&... values) {
    (read(values), ...);
  }
  void end() const {
    if (at_ != bytes_.size()) throw Defect("from_bytes: too long");
  }

 private:
  void read(auto& value) {
    if constexpr (requires { members(*this, value); }) {
      members(*this, value);
    } else {
      require(sizeof value);
      std::memcpy(static_cast<void*>(&value), bytes_.data() + at_, sizeof value);
      at_ += sizeof value;
    }
  }
  void read(std::string& text) {
    const std::uint64_t size = count();
    text = bytes_.substr(at_, size);
    at_ += size;
  }
  template <class T>
  void read(std::vector<T>& values) {
    values.resize(count());
    for (T& value : values) read(value);
  }
  void read(Report::Value& value) {
    std::uint64_t kind = 0;
    read(kind);
    const auto read_if = [&]<std::size_t I>() {
      if (kind == I) read(value.emplace<I>());
    };
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      if (kind >= sizeof...(I)) throw Defect("from_bytes: unknown kind of value");
      (read_if.template operator()<I>(), ...);
    }
    (std::make_index_sequence<std::variant_size_v<Report::Value>>());
  }
  void require(std::uint64_t size) const {
    if (size > bytes_.size() - at_) throw Defect("from_bytes: too short");
  }
  std::uint64_t count() {
    std::uint64_t n = 0;
    read(n);
    require(n);
    return n;
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
};

template <class... Values>
std::string bytes_of(const Values&... values) {
  Writer write;
  write(values...);
  return std::move(write.bytes);
}

template <class... Values>
void read_all(const std::string& bytes, Values&... values) {
  Reader read(bytes);
  read(values...);
  read.end();
}

template <class Face>
Face face_and_report(const std::string& bytes, Report& report) {
  Face face;
  std::vector<std::pair<std::string, Report::Value>> entries;
  std::vector<Report::Warning> warnings;
  read_all(bytes, face, entries, warnings);
  for (const auto& [key, value] : entries) report.set(key, value);
  for (const Report::Warning& warning : warnings) report.warn(warning.code, warning.message);
  return face;
}

}  // namespace

std::string to_bytes(const CadRequest& request) { return bytes_of(request); }

CadRequest request_from_bytes(const std::string& bytes) {
  CadRequest request;
  read_all(bytes, request);
  return request;
}

std::string to_bytes(const FaceList& list) { return bytes_of(list); }

FaceList list_from_bytes(const std::string& bytes) {
  FaceList list;
  read_all(bytes, list);
  return list;
}

std::string to_bytes(const LoadedFace& loaded, const Report& report) {
  return bytes_of(loaded, report.entries(), report.warnings());
}

LoadedFace from_bytes(const std::string& bytes, Report& report) { return face_and_report<LoadedFace>(bytes, report); }

std::string to_bytes(const SpaceFace& face, const Report& report) {
  return bytes_of(face, report.entries(), report.warnings());
}

SpaceFace space_face_from_bytes(const std::string& bytes, Report& report) {
  return face_and_report<SpaceFace>(bytes, report);
}

std::string to_bytes(const AnyFace& face, const Report& report) {
  const std::string kind = std::holds_alternative<SpaceFace>(face) ? "s" : "p";
  return kind + std::visit([&](const auto& f) { return to_bytes(f, report); }, face);
}

AnyFace any_face_from_bytes(const std::string& bytes, Report& report) {
  if (bytes.starts_with('s')) return space_face_from_bytes(bytes.substr(1), report);
  return from_bytes(bytes.substr(1), report);
}

}  // namespace quadrille::cad
