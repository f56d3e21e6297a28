#pragma once
// Commands that make a CAD file of what is none, points or a drawing: an option of such a command, or the ending of the
// shape, tells which one.

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille::chain {

struct ChainOptions;
struct ChainState;

struct ShapeMaker {
  std::string_view command;             ///< the shape, options, and -o FILE
  std::string_view input;               ///< what it reads, in words
  std::vector<std::string> endings;     ///< of shapes, in small letters
  std::map<std::string, bool> options;  ///< of quadmesh that it takes, and whether they take a value
};

/// All of them.
const std::vector<ShapeMaker>& shape_makers();

/// The command that has the option; nullptr: none.
const ShapeMaker* maker_with_option(const std::string& flag);

/// The command that the shape needs, by the options, else by the ending of the shape; nullptr: none, it is a CAD file.
/// Throws UsageError if the options are of two commands, or of one that does not read files with such an ending.
const ShapeMaker* maker_of_shape(const ChainOptions& options);

/// The shape as a CAD file, made if necessary. Throws ChainFailure.
std::string cad_file(ChainState& chain);

}  // namespace quadrille::chain
