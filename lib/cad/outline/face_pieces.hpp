#pragma once
// The pieces of a face whose boundary touches itself.

#include <string>
#include <vector>

#include "heal/loop.hpp"

namespace quadrille::outline {

/// The piece that is asked for of a face which touches itself.
struct FacePiece {
  std::string face = "0";  ///< name or number of the face, for messages
  int number = -1;         ///< as in face_pieces(); -1: the only piece
};

/// The loops of each piece: one that goes around it counter-clockwise comes first, then its holes in the order of
/// `loops`. The piece with the largest outline comes first; areas within 1e-6 of each other keep the order of `loops`.
/// Each hole belongs to the smallest outline around it. `loops`: with the face on their left (heal::separated_loops).
std::vector<std::vector<heal::Loop>> face_pieces(const std::vector<heal::Loop>& loops);

}  // namespace quadrille::outline
