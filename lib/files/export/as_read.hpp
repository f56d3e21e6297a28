#pragma once
// A mesh as a program has it that reads it in a format.

#include "export/format_table.hpp"
#include "model/hex_mesh.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// The elements of the file: pieces of those of the mesh where the format has no others, and where it has no nodes
/// inside elements, or inside faces, blends of the sides or edges there (Boolean sums, see hex_blend.hpp). Bounds and
/// measures of elements are those of `mesh`, or empty. Linear cost.
QuadMesh as_read(const QuadMesh& mesh, const ExportFormat& format);
HexMesh as_read(const HexMesh& mesh, const ExportFormat& format);

/// The element of the mesh that an element of as_read is a piece of.
int source_element(const QuadMesh& mesh, const QuadMesh& read, int elem);
int source_element(const HexMesh& mesh, const HexMesh& read, int elem);

}  // namespace quadrille::exports
