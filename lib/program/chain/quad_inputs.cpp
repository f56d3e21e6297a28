#include "chain/quad_inputs.hpp"

#include <filesystem>

#include "io/name_rules_io.hpp"
#include "io/size_field_io.hpp"
#include "triangulate/size_triangles.hpp"

namespace quadrille::chain {

namespace fs = std::filesystem;

io::InputFile read_input(const ChainState& chain, const std::string& path) {
  if (path != "-" || !chain.standard_input) return io::read_input(path);
  io::InputFile file{io::identity_of("standard input", *chain.standard_input), *chain.standard_input};
  if (file.bytes.empty()) throw FormatError("standard input: is empty");
  return file;
}

Names boundary_names(const ChainState& chain) {
  if (chain.values.cad2tri.names_file.empty()) return {};
  const io::InputFile file = read_input(chain, chain.values.cad2tri.names_file);
  return {io::read_boundary_names(file), file};
}

Names block_names(const ChainState& chain) {
  if (chain.values.blocksplit.names_file.empty()) return {};
  const io::InputFile file = read_input(chain, chain.values.blocksplit.names_file);
  return {io::read_block_names(file), file};
}

PrescribedSizes prescribed_sizes(const ChainState& chain, const CadFace& face) {
  if (chain.values.quadrefine.size_field_file.empty()) return {};
  const io::InputFile file = read_input(chain, chain.values.quadrefine.size_field_file);
  PrescribedSizes sizes{io::read_size_field(file, face.origin), file};
  if (sizes.content.is_table) triangulate::add_size_triangles(sizes.content);
  return sizes;
}

}  // namespace quadrille::chain
