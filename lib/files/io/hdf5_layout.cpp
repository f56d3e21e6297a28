#include "io/hdf5_layout.hpp"

#include <cstdint>
#include <cstring>
#include <limits>
#include <set>
#include <string_view>

namespace quadrille::io {

namespace {

using namespace std::string_view_literals;

constexpr std::uint64_t undefined = std::numeric_limits<std::uint64_t>::max();

// Numbers of header messages (specification, section IV.A.2).
enum class Message : std::uint64_t {
  padding = 0x0,
  data_space = 0x1,
  data_type = 0x3,
  fill_value = 0x5,
  data_layout = 0x8,
  attribute = 0xc,
  continuation = 0x10,
  symbol_table = 0x11
};

constexpr std::string_view signature_and_versions = "\x89HDF\r\n\x1a\n\0\0\0\0\0\x08\x08\0\x04\0\x10\0\0\0\0\0"sv;
constexpr std::uint64_t most_children = 32, most_symbols = 8;  // by those versions: twice 16, twice 4
constexpr std::string_view integer_type_bytes = "\x10\x08\0\0\x04\0\0\0\0\0\x20\0"sv;
constexpr std::string_view real_type_bytes = "\x11\x20\x3f\0\x08\0\0\0\0\0\x40\0\x34\x0b\0\x34\xff\x03\0\0"sv;
constexpr std::string_view text_type_bytes = "\x13\x11\0\0"sv;  // and the size

constexpr std::uint64_t padded(std::uint64_t size) { return (size + 7) / 8 * 8; }

/// Bytes of a structure; what lies outside is read as a number that no structure contains.
class Bytes {
 public:
  Bytes(std::string_view all) : all_(all) {}
  std::uint64_t size() const { return all_.size(); }
  std::uint64_t number(std::uint64_t at, std::size_t width) const {
    std::uint64_t value = 0;
    if (!contains(at, width)) return undefined - 1;
    std::memcpy(&value, all_.data() + at, width);  // little endian, as the processors that the tools are built for
    return value;
  }
  bool contains(std::uint64_t at, std::uint64_t size) const { return at <= all_.size() && size <= all_.size() - at; }
  bool has(std::uint64_t at, std::string_view text) const {
    return contains(at, text.size()) && all_.substr(at, text.size()) == text;
  }
  /// Empty if it is not inside.
  Bytes part(std::uint64_t at, std::uint64_t size) const {
    return contains(at, size) ? all_.substr(at, size) : std::string_view();
  }

 private:
  std::string_view all_;
};

/// The number of values of a data space of at most two dimensions, undefined for others.
std::uint64_t count_of(const Bytes& space) {
  const std::uint64_t rank = space.number(1, 1), has_maxima = space.number(2, 1);
  if (space.number(0, 1) != 1 || rank > 2 || has_maxima > 1 || space.number(3, 5) != 0) return undefined;
  if (!space.contains(8, 8 * rank * (1 + has_maxima))) return undefined;
  std::uint64_t count = 1;
  for (std::uint64_t i = 0; i < rank; ++i) {
    const std::uint64_t extent = space.number(8 + 8 * i, 8);
    if (has_maxima == 1 && space.number(8 + 8 * (rank + i), 8) != extent) return undefined;
    if (extent > std::numeric_limits<std::int32_t>::max()) return undefined;
    count *= extent;  // of at most two numbers below 2^31
  }
  return count;
}

/// The size of one value, 0 for a type that the formats do not use.
std::uint64_t size_of(const Bytes& type) {
  if (type.has(0, integer_type_bytes)) return 4;
  if (type.has(0, real_type_bytes)) return 8;
  const std::uint64_t size = type.number(4, 4);
  return type.has(0, text_type_bytes) && size <= std::numeric_limits<std::int32_t>::max() ? size : 0;
}

/// The bytes that values take, undefined if there cannot be such values.
std::uint64_t size_of_values(const Bytes& type, const Bytes& space) {
  const std::uint64_t size = size_of(type), count = count_of(space);
  return size == 0 || count == undefined || count > undefined / 2 / size ? undefined : size * count;
}

bool is_sound_attribute(const Bytes& message) {
  const std::uint64_t name = message.number(2, 2), type = message.number(4, 2), space = message.number(6, 2);
  const std::uint64_t type_at = 8 + padded(name), space_at = type_at + padded(type), values = space_at + padded(space);
  if (message.number(0, 2) != 1 || name == 0 || message.number(8 + name - 1, 1) != 0) return false;
  const std::uint64_t size = size_of_values(message.part(type_at, type), message.part(space_at, space));
  return size != undefined && message.contains(values, size);
}

/// The messages of one object.
struct Contents {
  std::uint64_t num_messages = 0, num_spaces = 0, num_types = 0, num_layouts = 0, num_tables = 0, num_fill_values = 0;
  Bytes space = {{}}, type = {{}}, layout = {{}}, table = {{}};
};

class Image {
 public:
  explicit Image(std::string_view image) : bytes_(image), room_(image.size()) {}

  bool is_sound() {
    constexpr std::uint64_t root_entry = 56;
    return bytes_.has(0, signature_and_versions) && bytes_.number(24, 8) == 0 && bytes_.number(32, 8) == undefined &&
           bytes_.number(40, 8) == bytes_.size() && bytes_.number(48, 8) == undefined &&
           bytes_.number(root_entry, 8) == 0 && is_sound_entry(root_entry);
  }

 private:
  /// Counts what has been read: structures that overlap would be read over and over.
  bool takes(std::uint64_t size) {
    if (size > room_) return false;
    room_ -= size;
    return true;
  }

  /// A symbol table entry, whose name is elsewhere: an object, and for a group what its header says too.
  bool is_sound_entry(std::uint64_t at) {
    const std::uint64_t header = bytes_.number(at + 8, 8), cached = bytes_.number(at + 16, 4);
    Contents contents;
    if (cached > 1 || bytes_.number(at + 20, 4) != 0 || !takes(40) || !is_sound_header(header, contents)) return false;
    if (contents.num_tables == 0) return cached == 0 && is_sound_dataset(contents);
    const std::uint64_t tree = contents.table.number(0, 8), heap = contents.table.number(8, 8);
    return (cached == 0 || (bytes_.number(at + 24, 8) == tree && bytes_.number(at + 32, 8) == heap)) &&
           is_sound_group(contents, tree, heap);
  }

  bool is_sound_header(std::uint64_t at, Contents& contents) {
    if (!seen_.insert(at).second || bytes_.number(at, 2) != 1 || bytes_.number(at + 4, 4) != 1) return false;
    if (!are_sound_messages(at + 16, bytes_.number(at + 8, 4), contents)) return false;
    return contents.num_messages == bytes_.number(at + 2, 2);
  }

  bool are_sound_messages(std::uint64_t at, std::uint64_t size, Contents& contents) {
    if (!bytes_.contains(at, size) || !takes(size)) return false;
    const std::uint64_t end = at + size;
    while (at < end) {
      const std::uint64_t kind = bytes_.number(at, 2), length = bytes_.number(at + 2, 2);
      if (length % 8 != 0 || length + 8 > end - at || bytes_.number(at + 4, 4) > 1) return false;  // flags: constant
      if (!is_sound_message(kind, bytes_.part(at + 8, length), contents)) return false;
      at += 8 + length;
    }
    return true;
  }

  bool is_sound_message(std::uint64_t kind, const Bytes& message, Contents& contents) {
    ++contents.num_messages;
    switch (static_cast<Message>(kind)) {
      case Message::padding:
        return true;
      case Message::data_space:
        contents.space = message;
        return ++contents.num_spaces == 1;
      case Message::data_type:
        contents.type = message;
        return ++contents.num_types == 1;
      case Message::fill_value:  // none is stored
        return message.number(0, 1) == 2 && message.number(3, 5) == 1 && ++contents.num_fill_values == 1;
      case Message::data_layout:
        contents.layout = message;
        return ++contents.num_layouts == 1;
      case Message::attribute:
        return is_sound_attribute(message);
      case Message::continuation:
        return are_sound_messages(message.number(0, 8), message.number(8, 8), contents);
      case Message::symbol_table:
        contents.table = message;
        return ++contents.num_tables == 1;
      default:
        return false;
    }
  }

  bool is_sound_dataset(const Contents& contents) {
    if (contents.num_spaces != 1 || contents.num_types != 1 || contents.num_layouts != 1) return false;
    const Bytes& layout = contents.layout;
    const std::uint64_t size = size_of_values(contents.type, contents.space);
    if (size == undefined || layout.number(0, 1) != 3) return false;
    if (layout.number(1, 1) == 0) return layout.number(2, 2) == size && layout.contains(4, size);
    const std::uint64_t at = layout.number(2, 8);
    if (layout.number(1, 1) != 1 || layout.number(10, 8) != size) return false;
    return (size == 0 && at == undefined) || (bytes_.contains(at, size) && takes(size));
  }

  bool is_sound_group(const Contents& contents, std::uint64_t tree, std::uint64_t heap) {
    if (contents.num_spaces + contents.num_types + contents.num_layouts + contents.num_fill_values > 0) return false;
    const std::uint64_t names_size = bytes_.number(heap + 8, 8);
    const Bytes names = bytes_.part(bytes_.number(heap + 24, 8), names_size);
    if (!bytes_.has(heap, "HEAP\0\0\0\0"sv) || names_size == 0 || names.size() != names_size ||
        names.number(names_size - 1, 1) != 0 || !takes(names_size) || !seen_.insert(heap).second ||
        !has_sound_gaps(names, bytes_.number(heap + 16, 8)))
      return false;
    return is_sound_tree(tree, names);
  }

  /// The free parts of a heap are a list, ended by 1: offset of the next one, size.
  static bool has_sound_gaps(const Bytes& names, std::uint64_t gap) {
    for (std::uint64_t before = 0; gap != 1; before = gap, gap = names.number(gap, 8)) {
      const std::uint64_t size = names.number(gap + 8, 8);
      if (gap % 8 != 0 || (before != 0 && gap <= before) || size < 16 || !names.contains(gap, size)) return false;
    }
    return true;
  }

  bool is_sound_tree(std::uint64_t tree, const Bytes& names) {
    const std::uint64_t num_children = bytes_.number(tree + 6, 2);
    if (!bytes_.has(tree, "TREE\0\0"sv) || !bytes_.contains(tree, 24 + 16 * most_children + 8) ||
        num_children > most_children || bytes_.number(tree + 8, 8) != undefined ||
        bytes_.number(tree + 16, 8) != undefined || !seen_.insert(tree).second)
      return false;
    for (std::uint64_t i = 0; i <= num_children; ++i)
      if (!names.contains(bytes_.number(tree + 24 + 16 * i, 8), 1)) return false;
    for (std::uint64_t i = 0; i < num_children; ++i)
      if (!are_sound_symbols(bytes_.number(tree + 32 + 16 * i, 8), names)) return false;
    return true;
  }

  bool are_sound_symbols(std::uint64_t node, const Bytes& names) {
    const std::uint64_t count = bytes_.number(node + 6, 2);
    if (!bytes_.has(node, "SNOD\x01\0"sv) || !bytes_.contains(node, 8 + 40 * most_symbols) || count > most_symbols ||
        !seen_.insert(node).second)
      return false;
    for (std::uint64_t entry = node + 8; entry < node + 8 + 40 * count; entry += 40)
      if (!names.contains(bytes_.number(entry, 8), 1) || !is_sound_entry(entry)) return false;
    return true;
  }

  Bytes bytes_;
  std::uint64_t room_;            ///< bytes that structures may still take
  std::set<std::uint64_t> seen_;  ///< where structures are: each is referred to once, so that there are no cycles
};

}  // namespace

bool has_own_layout(std::string_view image) { return Image(image).is_sound(); }

}  // namespace quadrille::io
