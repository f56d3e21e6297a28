#pragma once
// Structs as bytes, for a program and a helper that it runs: exact, of one machine, and not a file format.
//
// `Members` lists the members of each struct once, for both directions, by functions
//     static void of(auto& archive, Is<Struct> auto& s) { archive(s.first, s.second); }
// Numbers, enums, text, vectors, pairs, variants and arrays need none; of a struct without such a function, which must
// have no padding, the bytes are copied.

#include <array>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "base/error.hpp"

namespace quadrille {

template <class T, class Struct>
concept Is = std::same_as<std::remove_const_t<T>, Struct>;

template <class Members>
class ByteWriter {
 public:
  template <class... Values>
  void operator()(const Values&... values) {
    (write(values), ...);
  }
  std::string take() { return std::move(bytes_); }

 private:
  void write(const auto& value) {
    if constexpr (requires { Members::of(*this, value); }) {
      Members::of(*this, value);
    } else {
      static_assert(std::is_trivially_copyable_v<std::remove_cvref_t<decltype(value)>>);
      bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
  }
  void write(const std::string& text) {
    write(static_cast<std::uint64_t>(text.size()));
    bytes_ += text;
  }
  template <class T>
  void write(const std::vector<T>& values) {
    write(static_cast<std::uint64_t>(values.size()));
    if constexpr (std::is_arithmetic_v<T> && !std::same_as<T, bool>)
      bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    else
      for (const T& value : values) write(value);
  }
  template <class A, class B>
  void write(const std::pair<A, B>& value) {
    write(value.first);
    write(value.second);
  }
  template <class... Kinds>
  void write(const std::variant<Kinds...>& value) {
    write(static_cast<std::uint64_t>(value.index()));
    std::visit([&](const auto& v) { write(v); }, value);
  }

  std::string bytes_;
};

/// Throws Defect for bytes that the writer of the same structs did not write.
template <class Members>
class ByteReader {
 public:
  explicit ByteReader(const std::string& bytes) : bytes_(bytes) {}

  template <class... Values>
  void operator()(Values&... values) {
    (read(values), ...);
  }
  void end() const {
    if (at_ != bytes_.size()) throw Defect("ByteReader: too long");
  }

 private:
  void read(auto& value) {
    if constexpr (requires { Members::of(*this, value); })
      Members::of(*this, value);
    else
      copy(&value, sizeof value);
  }
  void read(std::string& text) {
    const std::uint64_t size = count(1);  // moves at_
    text.assign(bytes_, at_, size);
    at_ += size;
  }
  template <class T>
  void read(std::vector<T>& values) {
    constexpr bool is_copied = std::is_arithmetic_v<T> && !std::same_as<T, bool>;
    values.resize(count(is_copied ? sizeof(T) : 1));
    if constexpr (is_copied)
      copy(values.data(), values.size() * sizeof(T));
    else
      for (T& value : values) read(value);
  }
  template <class A, class B>
  void read(std::pair<A, B>& value) {
    read(value.first);
    read(value.second);
  }
  template <class... Kinds>
  void read(std::variant<Kinds...>& value) {
    std::uint64_t kind = 0;
    read(kind);
    if (kind >= sizeof...(Kinds)) throw Defect("ByteReader: unknown kind of value");
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      ((kind == I ? read(value.template emplace<I>()) : void()), ...);
    }
    (std::index_sequence_for<Kinds...>());
  }

  void copy(void* to, std::size_t size) {
    require(size);
    if (size > 0) std::memcpy(to, bytes_.data() + at_, size);
    at_ += size;
  }
  void require(std::uint64_t size) const {
    if (size > bytes_.size() - at_) throw Defect("ByteReader: too short");
  }
  /// Of members that take at least `size` bytes each.
  std::uint64_t count(std::size_t size) {
    std::uint64_t n = 0;
    read(n);
    if (n > (bytes_.size() - at_) / size) throw Defect("ByteReader: too short");
    return n;
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
};

template <class Members, class... Values>
std::string to_bytes_by(const Values&... values) {
  ByteWriter<Members> write;
  write(values...);
  return write.take();
}

template <class Members, class... Values>
void from_bytes_by(const std::string& bytes, Values&... values) {
  ByteReader<Members> read(bytes);
  read(values...);
  read.end();
}

}  // namespace quadrille
