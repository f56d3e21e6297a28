#pragma once
// The books of irregular nodes and corner valences. A step that changes them describes what it changes; the nodes, the
// valences, form, zeros, index sum and the record of changes are updated here and nowhere else, so that they agree.

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "model/cad_face.hpp"
#include "model/critical_points.hpp"
#include "model/phase_nodes.hpp"

namespace quadrille::placement {

/// One change. Its record has the corners before the nodes, each with its valence before and after. Corners whose
/// valence is chosen by rule (kind `line`) are recorded without a valence before: the field decides none.
struct NodeEdit {
  ChangeKind kind = ChangeKind::other;
  std::string reason;
  std::vector<CornerValence> corners{};  ///< new valences
  std::vector<NodeMark> added{};         ///< nodes inside
  std::vector<std::size_t> removed{};    ///< entries of critical_points
  std::vector<NodeMark> zeros{};         ///< zeros of the field that are replaced and have no node
};

/// Carries out changes at once: `removed` of each refers to the nodes before all of them. Nodes that stay keep their
/// order, added ones follow. Corners and nodes get the source of the change. The form becomes `phase` unless corners
/// only absorb zeros, which leaves them the valence of the field. Before the nodes of a field first change, they are
/// kept as `zeros`.
void apply(const std::vector<NodeEdit>& edits, CriticalPoints& points);

/// All nodes of a layout.
struct NodeSet {
  std::vector<CriticalPoint> critical_points;
  std::vector<Corner> corners;
  std::vector<IrregularBoundaryPoint> boundary_nodes;
};

/// Replaces the nodes by others that rules made of them, with the record of how. Keeps the same books.
void replace_nodes(NodeSet nodes, const std::vector<NodeChange>& changes, CriticalPoints& points);

/// Adds to the record what changes no node.
void record(const std::vector<NodeChange>& changes, CriticalPoints& points);

/// The node with another position or valence, and so no zero of the field: without Jacobian and error bar.
CriticalPoint changed_node(CriticalPoint node, Vec2 position, int valence, NodeSource source);

NodeMark mark_of(const CriticalPoint& node);
NodeMark mark_of(const Corner& corner);

/// Gives the nodes of `points` the positions of those of `moved`. Adds a change of the kind `place` for each node that
/// moved by more than 1e-9 diameters, with the reason for a move of that length; such nodes get the source `place`, no
/// Jacobian and no error bar, and keep `elem` and `xi` of their old position, because only the caller has the mesh. If
/// no node moved so far, nothing changes.
void record_moves(const CadFace& face, const CriticalPoints& moved, const std::function<std::string(double)>& reason,
                  CriticalPoints& points);

}  // namespace quadrille::placement
