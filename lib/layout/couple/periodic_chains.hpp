#pragma once
// Periodic sides as chains of curves, with the nodes of a layout of the whole on both.

#include <vector>

#include "couple/boundary_place.hpp"
#include "couple/interface_chains.hpp"

namespace quadrille::couple {

/// Successive first curves of periodic pairs, whose second ones follow each other in the opposite direction.
struct PeriodicChain {
  InterfaceChain chain;      ///< of the first curves; the other side of it is that of the second ones
  std::vector<int> seconds;  ///< the second curve of each pair
};

std::vector<PeriodicChain> periodic_chains(const CadFace& face);

/// Sets the stations: the nodes inside the chains, not at their ends. The position of a node on a second curve is that
/// of its image.
void set_stations(const graph::CandidateLayout& layout, std::vector<PeriodicChain>& chains);

/// The place on the other side that is the image of a place on a chain's first or second curves.
Place image_of(const CadFace& face, const PeriodicChain& chain, const Place& place);

}  // namespace quadrille::couple
