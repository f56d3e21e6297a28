#pragma once
// Rules for new names of boundary curves (formats/boundary-names.md; a file, or --name) or blocks
// (formats/block-names.md).

#include <string>
#include <vector>

namespace quadrille {

/// One entry: the curves or blocks that get `name`.
struct NameRule {
  enum class Kind {
    key,       ///< `text` is an old name or, if no curve has that name, a number
    number,    ///< number of a curve or block, base 0
    old_name,  ///< all curves of the name `text`
    position,  ///< the curve nearest to the position `position`, or the block around it
    range,     ///< the numbers from `number` to `last_number`
    pattern,   ///< all curves whose name fits `text`, with the wild cards * and ? (base/name_text)
    rest,      ///< all that no other rule names; of curves those of the boundary, unless `part` is interface
  };
  /// Of the curves: the outline and holes of the whole face, or those that two regions share or that lie inside one.
  enum class Part { any, boundary, interface };
  Kind kind = Kind::rest;
  std::string text{};
  int number = -1;
  std::vector<double> position{};  ///< x, y of the face's plane (with face.origin), or x, y, z of the CAD model's space
  std::string name{};              ///< valid UTF-8, trimmed, not empty
  std::string where{};             ///< the file and the entry, or the option, for messages
  int last_number = -1;            ///< of a range
  double max_distance = 1;         ///< of a position from the curve, in diameters
  Part part = Part::any;           ///< of a pattern, or of the rest: what else fits is not meant
};

}  // namespace quadrille
