#pragma once
// Names of the boundary curves: chosen among the labels in a CAD file, then renamed by rules. No OpenCASCADE types.

#include <vector>

#include "base/report.hpp"
#include "heal/raw_face.hpp"
#include "model/cad_face.hpp"
#include "model/name_rules.hpp"

namespace quadrille::cad {

/// Sets RawEdge::name, and RawFace::name, from the labels of the file. The first of these that exists is used:
///   1. the edge's own name,
///   2. its layer, unless the face is on the same layer (then it is the layer of the part),
///   3. its colour, as "colour_ff0000", unless there are several edges and all have the same colour.
///
/// A face without a name gets the name of its layer, unless an edge is on the same layer. Without any label, names stay
/// empty.
void choose_names(heal::RawFace& raw);

/// Sets face.curve_names by `rules`; old names refer to the names before the first rule, and several curves may have
/// the same name. Both sides of a common curve are one curve for a rule. The rest are curves of the boundary, or those
/// that have two sides in the face. Warns of rules for names or ranges of numbers that name curves of both kinds.
/// Throws FormatError, with the position of the rule in its source, for a rule that matches no curve, for a position
/// that is equally near to several curves (within 1e-6 diameters) or farther than max_distance from all, and for two
/// rules that name the same curve.
///
/// A curve that a rule of `overriding` names, which are for the old names too, keeps that name whatever `rules` say,
/// and their rest is what no rule of either set names. Rules of `overriding` may name a curve several times if they
/// agree.
void rename_curves(CadFace& face, const std::vector<NameRule>& rules, const std::vector<NameRule>& overriding,
                   Report& report);

}  // namespace quadrille::cad
