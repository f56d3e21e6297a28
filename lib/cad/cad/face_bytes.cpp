#include "cad/face_bytes.hpp"

#include <cstdint>
#include <cstring>
#include <type_traits>

#include "base/error.hpp"

namespace quadrille::cad {
namespace {

class Writer {
 public:
  std::string bytes;

  template <class T>
  requires std::is_trivially_copyable_v<T>
  void operator()(const T& value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); }
  void operator()(const std::string& text) {
    (*this)(static_cast<std::uint64_t>(text.size()));
    bytes += text;
  }
  template <class T>
  void operator()(const std::vector<T>& values) {
    (*this)(static_cast<std::uint64_t>(values.size()));
    for (const T& value : values) (*this)(value);
  }
  // Member by member, because the padding after the last member is not data.
  void operator()(const Joint& j) {
    (*this)(j.position), (*this)(j.tangent_in), (*this)(j.tangent_out), (*this)(j.interior_angle), (*this)(j.is_corner);
  }
  void operator()(const Nurbs& c) { (*this)(c.degree), (*this)(c.knots), (*this)(c.poles), (*this)(c.weights); }
  void operator()(const ListedShape& s) { (*this)(s.name), (*this)(s.kind), (*this)(s.length), (*this)(s.place); }
  void operator()(const ListedFace& f) { (*this)(f.face), (*this)(f.part), (*this)(f.layer), (*this)(f.edges); }
};

class Reader {
 public:
  explicit Reader(const std::string& bytes) : bytes_(bytes) {}

  template <class T>
  requires std::is_trivially_copyable_v<T>
  void operator()(T& value) {
    if (bytes_.size() - at_ < sizeof value) throw Defect("from_bytes: too short");
    std::memcpy(static_cast<void*>(&value), bytes_.data() + at_, sizeof value);
    at_ += sizeof value;
  }
  void operator()(std::string& text) {
    const std::uint64_t size = count();
    text = bytes_.substr(at_, size);
    at_ += size;
  }
  template <class T>
  void operator()(std::vector<T>& values) {
    values.resize(count());
    for (T& value : values) (*this)(value);
  }
  void operator()(Joint& j) {
    (*this)(j.position), (*this)(j.tangent_in), (*this)(j.tangent_out), (*this)(j.interior_angle), (*this)(j.is_corner);
  }
  void operator()(Nurbs& c) { (*this)(c.degree), (*this)(c.knots), (*this)(c.poles), (*this)(c.weights); }
  void operator()(ListedShape& s) { (*this)(s.name), (*this)(s.kind), (*this)(s.length), (*this)(s.place); }
  void operator()(ListedFace& f) { (*this)(f.face), (*this)(f.part), (*this)(f.layer), (*this)(f.edges); }

  bool at_end() const { return at_ == bytes_.size(); }

 private:
  std::uint64_t count() {
    std::uint64_t n = 0;
    (*this)(n);
    if (n > bytes_.size() - at_) throw Defect("from_bytes: too short");
    return n;
  }
  const std::string& bytes_;
  size_t at_ = 0;
};

// One list of members serves both writing and reading.
template <class Archive, class Face>
void members(Archive& a, Face& f) {
  a(f.length_unit), a(f.metres_per_unit), a(f.plane_origin), a(f.plane_x), a(f.plane_y), a(f.origin), a(f.diameter);
  a(f.fit_distance);
  a(f.curves), a(f.curve_names), a(f.unnamed_curves), a(f.curve_cad_edges), a(f.loop_offsets), a(f.joints), a(f.name);
  a(f.region_loops), a(f.region_names), a(f.partners);
}

template <class Archive, class Request>
void request_members(Archive& a, Request& r) {
  a(r.task), a(r.name), a(r.bytes);
  a(r.options.corner_angle), a(r.options.heal_tolerance), a(r.options.face), a(r.options.blunt_width),
      a(r.options.fit_tolerance);
  members(a, r.face);
}

void write_value(Writer& w, const Report::Value& value) {
  w(static_cast<std::uint64_t>(value.index()));
  std::visit([&](const auto& v) { w(v); }, value);
}

template <class T>
Report::Value read_as(Reader& r) {
  T value{};
  r(value);
  return value;
}

Report::Value read_value(Reader& r) {
  std::uint64_t kind = 0;
  r(kind);
  switch (kind) {
    case 0:
      return read_as<long long>(r);
    case 1:
      return read_as<double>(r);
    case 2:
      return read_as<bool>(r);
    case 3:
      return read_as<std::string>(r);
    case 4:
      return read_as<std::vector<double>>(r);
    default:
      throw Defect("from_bytes: unknown kind of value");
  }
}

}  // namespace

std::string to_bytes(const CadRequest& request) {
  Writer w;
  request_members(w, request);
  return w.bytes;
}

CadRequest request_from_bytes(const std::string& bytes) {
  Reader r(bytes);
  CadRequest request;
  request_members(r, request);
  if (!r.at_end()) throw Defect("request_from_bytes: too long");
  return request;
}

std::string to_bytes(const FaceList& list) {
  Writer w;
  w(list.length_unit), w(list.faces), w(list.not_built);
  return w.bytes;
}

FaceList list_from_bytes(const std::string& bytes) {
  Reader r(bytes);
  FaceList list;
  r(list.length_unit), r(list.faces), r(list.not_built);
  if (!r.at_end()) throw Defect("list_from_bytes: too long");
  return list;
}

std::string to_bytes(const LoadedFace& loaded, const Report& report) {
  Writer w;
  members(w, loaded.face);
  w(loaded.repairs);
  w(static_cast<std::uint64_t>(report.entries().size()));
  for (const auto& [key, value] : report.entries()) w(key), write_value(w, value);
  w(static_cast<std::uint64_t>(report.warnings().size()));
  for (const auto& warning : report.warnings()) w(warning.code), w(warning.message);
  return w.bytes;
}

LoadedFace from_bytes(const std::string& bytes, Report& report) {
  Reader r(bytes);
  LoadedFace loaded;
  members(r, loaded.face);
  r(loaded.repairs);
  std::uint64_t entries = 0, warnings = 0;
  r(entries);
  for (std::uint64_t i = 0; i < entries; ++i) {
    std::string key;
    r(key);
    report.set(key, read_value(r));
  }
  r(warnings);
  for (std::uint64_t i = 0; i < warnings; ++i) {
    std::string code, message;
    r(code), r(message);
    report.warn(code, message);
  }
  if (!r.at_end()) throw Defect("from_bytes: too long");
  return loaded;
}

}  // namespace quadrille::cad
