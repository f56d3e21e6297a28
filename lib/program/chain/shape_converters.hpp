#pragma once
// Commands that convert points or a drawing to a CAD file. The ending of the shape's name, or an option that only one
// of them has, selects the command.

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille::chain {

struct ChainOptions;
struct ChainState;

struct ShapeConverter {
  std::string_view command;             ///< the shape, options, and -o FILE
  std::string_view input;               ///< what it reads, in words
  std::vector<std::string> endings;     ///< of shapes, in small letters
  std::map<std::string, bool> options;  ///< of quadmesh that it takes, and whether they take a value
};

/// All of them.
const std::vector<ShapeConverter>& shape_converters();

/// The command that has the option; nullptr: none.
const ShapeConverter* converter_with_option(const std::string& flag);

/// The command that the shape needs, by the options, else by the ending of the shape; nullptr: none, it is a CAD file.
/// Throws UsageError if the options are of two commands, or of one that does not read files with such an ending.
const ShapeConverter* converter_of_shape(const ChainOptions& options);

/// The path of the shape as a CAD file, converted if necessary. Throws ChainFailure.
std::string cad_file(ChainState& chain);

}  // namespace quadrille::chain
