#pragma once
// What a message says about a contact between curves of a boundary.

#include <string>
#include <vector>

#include "heal/loop.hpp"
#include "outline/outline_checks.hpp"

namespace quadrille::outline {

/// "the outline" or "hole 1".
std::string loop_name(size_t loop);

/// Edges and place of a contact, its size, and what to do. The size is how far the place lies from the nearest end of
/// the two edges, or, if an edge meets itself, the length of the edge between both passes. `diameter`: of the face.
std::string contact_text(const std::vector<heal::Loop>& loops, const Contact& contact, double diameter);

}  // namespace quadrille::outline
