#include "export/cgns_request.hpp"

#include <cstring>

#include "base/error.hpp"

namespace quadrille::exports {

namespace {

// Both directions visit the members of each struct in the same order: visit(archive, struct).

class ByteWriter {
 public:
  template <typename Number>
  requires std::is_arithmetic_v<Number>
  void operator()(const Number& number) { bytes_.append(reinterpret_cast<const char*>(&number), sizeof number); }
  void operator()(const std::string& text) {
    (*this)(static_cast<std::int64_t>(text.size()));
    bytes_ += text;
  }
  template <typename Number>
  requires std::is_arithmetic_v<Number>
  void operator()(const std::vector<Number>& numbers) {
    (*this)(static_cast<std::int64_t>(numbers.size()));
    bytes_.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number));
  }
  template <typename Member>
  void operator()(const std::vector<Member>& members) {
    (*this)(static_cast<std::int64_t>(members.size()));
    for (const Member& member : members) visit(*this, member);
  }
  template <typename Number, std::size_t n>
  void operator()(const std::array<Number, n>& numbers) {
    for (const Number& number : numbers) (*this)(number);
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class ByteReader {
 public:
  explicit ByteReader(const std::string& bytes) : bytes_(bytes) {}

  template <typename Number>
  requires std::is_arithmetic_v<Number>
  void operator()(Number& number) { std::memcpy(&number, take(sizeof number), sizeof number); }
  void operator()(std::string& text) {
    const std::size_t size = count(1);
    text.assign(take(size), size);
  }
  template <typename Number>
  requires std::is_arithmetic_v<Number>
  void operator()(std::vector<Number>& numbers) {
    numbers.resize(count(sizeof(Number)));
    const std::size_t size = numbers.size() * sizeof(Number);
    if (size > 0) std::memcpy(numbers.data(), take(size), size);
  }
  template <typename Member>
  void operator()(std::vector<Member>& members) {
    members.resize(count(1));
    for (Member& member : members) visit(*this, member);
  }
  template <typename Number, std::size_t n>
  void operator()(std::array<Number, n>& numbers) {
    for (Number& number : numbers) (*this)(number);
  }
  bool is_at_end() const { return at_ == bytes_.size(); }

 private:
  std::size_t count(std::size_t size) {
    std::int64_t number = 0;
    (*this)(number);
    if (number < 0 || static_cast<std::size_t>(number) > (bytes_.size() - at_) / size)
      throw Defect("cgns_request: a wrong count");
    return static_cast<std::size_t>(number);
  }
  const char* take(std::size_t size) {
    if (size > bytes_.size() - at_) throw Defect("cgns_request: too few bytes");
    at_ += size;
    return bytes_.data() + at_ - size;
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
};

template <typename Archive, typename... Members>
void visit_all(Archive& archive, Members&... members) {
  (archive(members), ...);
}

template <typename Archive>
void visit(Archive& archive, std::vector<double>& numbers) {
  archive(numbers);
}
template <typename Archive>
void visit(Archive& archive, const std::vector<double>& numbers) {
  archive(numbers);
}

template <typename Struct, typename Of>
concept Same = std::is_same_v<std::remove_const_t<Struct>, Of>;

template <typename Archive>
void visit(Archive& archive, Same<CgnsFamily> auto& f) {
  visit_all(archive, f.name, f.boundary);
}
template <typename Archive>
void visit(Archive& archive, Same<CgnsSection> auto& s) {
  visit_all(archive, s.name, s.type, s.first, s.count, s.nodes);
}
template <typename Archive>
void visit(Archive& archive, Same<CgnsBoundary> auto& b) {
  visit_all(archive, b.name, b.family, b.range);
}
template <typename Archive>
void visit(Archive& archive, Same<CgnsConnection> auto& c) {
  visit_all(archive, c.name, c.donor, c.range, c.donor_range, c.transform);
}
template <typename Archive>
void visit(Archive& archive, Same<CgnsZone> auto& z) {
  visit_all(archive, z.name, z.family, z.size, z.x, z.sections, z.boundaries, z.connections);
}
template <typename Archive>
void visit(Archive& archive, Same<CgnsRequest> auto& r) {
  visit_all(archive, r.is_structured, r.cell_dimension, r.families, r.zones);
}

}  // namespace

std::string to_bytes(const CgnsRequest& request) {
  ByteWriter writer;
  visit(writer, request);
  return writer.take();
}

CgnsRequest cgns_request(const std::string& bytes) {
  ByteReader reader(bytes);
  CgnsRequest request;
  visit(reader, request);
  if (!reader.is_at_end()) throw Defect("cgns_request: something follows");
  return request;
}

}  // namespace quadrille::exports
