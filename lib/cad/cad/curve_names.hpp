#pragma once
// Names of the boundary curves: chosen among the labels in a CAD file, then renamed by rules, also by those of options.
// No OpenCASCADE types.

#include <string>
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

// The options --name and --region-name of cad2tri (formats/boundary-names.md, "On the command line"): names of boundary
// curves and of regions without a file.

/// The greatest distance of a point of --name from its curve, in diameters: a point farther away was taken from another
/// picture, or is in another unit.
constexpr double max_option_distance = 0.1;

/// One rule for each item of "NAME=LIST", a list of numbers, ranges a-b, names and patterns (base/name_text), or for
/// "NAME@X,Y[,Z]". The item "*" is the rest; "boundary:" and "interface:" before a pattern or "*" are its part. Throws
/// UsageError, with the option, for anything else. `option_name`: for messages.
std::vector<NameRule> name_option_rules(const std::vector<std::string>& options,
                                        const std::string& option_name = "--name");

}  // namespace quadrille::cad
