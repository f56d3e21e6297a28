#pragma once
// Two layouts or meshes side by side in one picture, at one scale, above a table of the counts and qualities of both.

#include <array>
#include <string>

#include "draw/draw.hpp"

namespace quadrille::draw {

/// Layouts and meshes.
template <typename Stage>
concept Comparable =
    std::is_same_v<Stage, SeparatrixGraph> || std::is_same_v<Stage, BlockLayout> || std::is_same_v<Stage, QuadMesh>;

/// The pair need not be of one chain; both show the same part of the plane, `options.window` or what both faces cover.
/// `files` are the names that are written above the drawings. UsageError: nothing of one of them is in the window.
template <Comparable Stage>
std::string draw_comparison(const std::array<const Stage*, 2>& pair, const std::array<std::string, 2>& files,
                            const DrawOptions& options);

}  // namespace quadrille::draw
