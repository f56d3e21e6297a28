#pragma once
// Puts the edges of a wire in order.

#include <string>
#include <vector>

#include "heal/raw_face.hpp"

namespace quadrille::heal {

/// The edges in the order of the wire: each next edge is the first one that starts within `near` of the end of the
/// previous edge, or else the one that starts nearest to it, within `tol` (lengths). Vertices count as well as ends of
/// curves. Throws FormatError if no edge follows, or if the wire does not close. `file`: for the message.
std::vector<const RawEdge*> chain_edges(const std::vector<const RawEdge*>& edges, double near, double tol,
                                        const std::string& file);

}  // namespace quadrille::heal
