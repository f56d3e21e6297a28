// The texts of quadmesh --help, a page, and --help-all: its own options, then those of the stages as their own help has
// them.

#include <algorithm>
#include <cctype>

#include "chain/chain_options.hpp"
#include "cli/stage_words.hpp"

namespace quadrille::chain {

namespace {

constexpr const char* brief_help = R"help(Usage: quadmesh [OPTIONS] SHAPE

quadmesh meshes a CAD face, or the shape that points or a drawing describe, with curved quads.

SHAPE is a STEP, IGES or BREP file, a drawing (SHAPE.dxf, SHAPE.svg), or the points of an outline or an aerofoil
(SHAPE.dat, SHAPE.xy). The ending of the output decides its format (quadexport --help lists them).

OPTIONS (--help-all: all of them, by stage)
  -o, --output FILE         mesh to write: x.msh, x.vtu, x.xml, x.mesh, x.inp, ...; x.step: its blocks as a CAD model
  --size X                  edge length of elements, in file units (default: diameter / 20)
  --size-near NAME=H        edge length H along a boundary, growing with the distance from it (--growth)
  --order N                 polynomial order of the elements (default: 4)
  --name NAME=LIST|NAME@X,Y name boundary curves by number (wall=1,3-6), or the one nearest to a point
  --wall NAME:first=H,growth=R,layers=N
                            thin layers along a boundary
  --periodic A=B            nodes of side B are images of those of side A
  --nodes fewest            as few irregular nodes as possible
  --face N|NAME             the face, if SHAPE holds several (cad2tri --list SHAPE shows them); it may be curved
  --farfield KIND:R         points: up to a far field circle:R, box:R or cgrid:R, R in chords
  --sweep                   hexahedra, by --height, --revolve, --layers, ...
  --workdir DIR             keep the files of all stages
  --html FILE               also a page for a browser, with every stage and the shapes of elements
  -h, --help                print this page; --help-all: all options
  --version                 print the version

EXIT CODES
0 success, 1 no valid result, 2 mistake on the command line, 3 bad input, 4 output not written

EXAMPLES
  quadmesh half_disc.step -o half_disc.msh
  quadmesh half_disc.step -o fine.vtu --size 0.05 --order 6 --name axis=0
  quadmesh half_disc.step -o layers.msh --wall 0:first=0.001,growth=1.3,layers=10
  quadmesh aerofoil.dat --farfield cgrid:20 -o aerofoil.msh
  quadmesh half_disc.step --sweep --height 2 --layers 8 -o solid.msh
)help";

constexpr const char* own_help = R"help(Usage: quadmesh [OPTIONS] SHAPE

quadmesh meshes a CAD face, or the shape that points or a drawing describe, with curved quads.

Runs all stages on the only face of a STEP, IGES or BREP file (-: standard input), or that of --face, and ends
with one line about the mesh. Options of critpoints, separatrix, blocksplit, quadrefine and quadexport are
passed on to them. SHAPE.dat and SHAPE.xy are points of an outline or an aerofoil, from which points2step
makes a STEP face (SHAPE.outline.step in --workdir); so is any SHAPE with an option for points. SHAPE.dxf and
SHAPE.svg are drawings, whose closed curves drawing2step turns into faces in the same way.
Where separatrix can only divide triangles (W-SEP-002), critpoints runs again with other nodes, by options that
separatrix proposes, one after another: if a strip of blocks winds onto itself, up to seven that change nodes on it
(--corner-absorb 0, --ties field, --place energy, --corner-valence A:B=V), in a far field other grids (--topology).
The first that gives a layout is kept. Where the layout's mesh is poor (a resolution ratio above 2, not proved, an edge
ratio above 100 or a scaled Jacobian below 0.3), nodes at the least energy (--place energy) are tried too, and taken
if their mesh is better; both are judged at edges of diameter / 20, so that blocks do not depend on sizes. Not with
more than 24 nodes, in a far field, with --wall, --place or --nodes.
Where the field gives no valid mesh, the face is meshed without it, by triangles divided into quads, with a
warning (--layout midpoint; with --layout traced or quantized the exit code is 1 instead).

The stages are cad2tri, fieldsolve, padapt, critpoints, separatrix, blocksplit, quadrefine, with --sweep hexsweep, and
quadexport. --until and --from run some of them. In between, files of --workdir may be edited: --from STAGE reads the
files of the stages before it and writes those from it on. --from separatrix (or --nodes) uses an edited x.crit.json.
--from critpoints finds the nodes again and uses an x.crit.json that differs from them in its content alone, because it
was edited; one with another provenance was made with other options and is replaced, but never nodes that were set by
hand (exit code 2). Results are those of the single commands, byte for byte.

OPTIONS
  -o, --output FILE         mesh to write, in the format of its ending or of --format (default: -, standard output);
                            x.step: not the mesh but its blocks, as a CAD model of named faces
  --farfield KIND:R         points: mesh the region between the shape and a far field, circle:R, box:R or cgrid:R, R in
                            chords; it makes an O-, H- or C-grid (--topology; see points2step --help)
  --wake auto|FILE          points: sides of blocks follow a curve called wake from the body to the far field: computed,
                            or through the points of FILE (see points2step --help)
  --chord C                 points: scale them so that the chord is C
  --points-corner-angle X   points: where the polygon turns by more than X degrees is a corner
  --points-tolerance T      points: smooth noise; curves stay within T of the polygon (unit: that of the points)
  --simplify-outline T      points: leave out those of noisy lines, none of which is farther than T from the rest
  --straight                points: straight edges from point to point
  --points-format FORMAT    points: auto, points, selig or lednicer
  --points-unit UNIT        points: their unit, m, cm, mm, um, in or ft
  --face-name NAME          points: name of the face, from which blocks get theirs (see points2step --help for these)
  --drawing-layers NAME,... drawings: read only curves of these layers or names, with ! in front all but these
  --drawing-tolerance T     drawings: ends this near to each other meet (unit: that of the drawing)
  --drawing-unit UNIT       drawings: their unit, m, cm, mm, um, in or ft
  --regions                 drawings: closed curves inside others bound regions, not holes
  --embed NAME,...          drawings: curves of these layers or names bound nothing, sides of elements follow them (see
                            drawing2step --help for these)
  --face N|NAME             the face to mesh, if SHAPE holds several (cad2tri --list SHAPE shows them), or N,N: several
                            of one surface, as regions; a curved one is meshed in its chart (SHAPE.chart.h5 in
                            --workdir; see cad2chart --help)
  --sweep                   sweep the quads into hexahedra, by the options of hexsweep (--height, --revolve, ...;
                            without them one layer as high as the quads are long), and write those
  --section PLANE           cut the solids of SHAPE by a plane, z=0.5 or NX,NY,NZ@X,Y,Z (its normal and a point), and
                            mesh the faces of the cut (see cad2tri --help)
  --name NAME=LIST|NAME@X,Y name of boundary curves by number (wall=1,3-6), present name or pattern ('wall=edge_*'), in
                            a box, by the diameter of circles ('bolts=circles(<5)'), as what continues curve 4 without
                            a corner ('rim=tangent(4)'), or of the curve nearest to a point; '*': all others of the
                            outline and of holes, 'interface:*' those between regions; may be given several times (see
                            cad2tri --help)
  --region-name NAME=LIST|NAME@X,Y
                            name of regions, where SHAPE has several faces of one surface, in the same way; a point lies
                            inside the region; neighbours of one name become one region
  --keep-joints             keep the lines between neighbours that --region-name gives one name
  --periodic A=B[:MOTION]   the sides A and B, names of curves, are periodic: their nodes are images of each other;
                            may be given several times (see cad2tri --help)
  --offset NAME=T           embed a curve at the distance T from the boundary NAME, which blocks end at; --wall
                            NAME:...,blocks=own does so by itself; may be given several times (see cad2tri --help)
  --boundary-names FILE     new names of boundary curves, JSON (see formats/boundary-names.md)
  --heal-tolerance X        the most that edges which do not meet are moved, in diameters (see cad2tri --help)
  --fit-tolerance X         the most that splines with many knots are moved to need fewer, in diameters (see
                            cad2tri --help)
  --blunt auto|WIDTH        cut off the tips of cusps, of corners below 0.2 degrees and of corners in which the
                            boundary touches itself: straight edges of this length, in file units; auto, the default:
                            1e-3 diameters, with a warning; 0: cusps and contacts are refused (see cad2tri --help)
  --write-healed FILE       also write the healed face as a CAD file: x.step or x.brep
  --workdir DIR             keep the files of all stages in DIR (default: a temporary folder)
  --until STAGE             end after this stage; its file is in --workdir, and -o is not written; without --workdir
                            -o is this file, x.blocks.h5 and so on
  --from STAGE              begin with this stage, with the files of earlier ones in --workdir; of SHAPE only the name
                            is used, and it may be left out if --workdir has the files of one shape
  --nodes RULE|FILE         RULE: which irregular nodes critpoints chooses (none, fewest, field, auto; see below); FILE:
                            use those of x.crit.json, edited or of another run (-: standard input), in their place
  --dry-run                 print the commands that would be run, one a line, and run nothing (without --workdir with
                            the files of the stages in the present folder)
  --html FILE               also write a page for a browser (x.html): every stage as a tab, and one with the report
                            of the run, histograms of the shapes of elements and the commands that made them
  --html-parts PARTS        of the page the tabs of these parts alone, with commas between them: triangles, field,
                            nodes, phase, separatrices, blocks, quads, hexahedra (default: all)
  --report FILE             write counts, least Jacobian and seconds of every stage as JSON, also after a failure, with
                            the stage, the exit code and the message (-: standard output)
  --max-seconds S           stop the stage that runs when all stages together have used S seconds, of CPU time (that of
                            all threads) or elapsed (unit: s; default: no limit; interval: above 0). A quarter of S
                            (or five times what cad2tri took, if that is more) is kept for quads without a field
                            (--layout midpoint), which are then made, with a warning (W-RUN-001). If they do not fit
                            in either, the exit code is 1
  --max-memory SIZE         stop a stage that has more in memory, with the same consequences: 500M, 2G (K, M, G, T:
                            powers of 1024; default: no limit)
  --stage NAME=COMMAND      run COMMAND in place of the stage NAME: a program, or a command for the shell, that takes
                            the words of the stage's own command and writes its file; may be given several times
  --threads N|auto          number of threads of a stage, 1 to 1024; auto: as many as there are processors, for work
                            that lasts longer than 0.2 s; the mesh does not depend on it (default: auto)
  -v, --verbose             print the seconds and the share of each stage
  -q, --quiet               print errors only
  -h, --help                print the options that most people need and exit
  --help-all                print this help and exit
  --version                 print the version and exit
)help";

constexpr const char* help_end = R"help(
EXIT CODES
Those of the stages: 0 success, 1 no valid result, 2 mistake on the command line, 3 bad input, 4 output not written,
70 internal error, please report it, 128 + n signal n. After 1 and 70 a picture of the last stage file is written to
--workdir, unless a stage was stopped by --max-seconds or --max-memory, or killed. Temporary folders are removed.

EXAMPLES
  quadmesh half_disc.step -o half_disc.msh
  quadmesh half_disc.step -o fine.msh --size 0.05 --order 6 --workdir stages --report fine.json -v
  quadmesh half_disc.step -o placed.msh --place energy
  quadmesh half_disc.step -o in_time.msh --max-seconds 60 --max-memory 2G
  quadmesh half_disc.step -o half_disc.xml --order 7
  quadmesh half_disc.step -o fewest.msh --nodes fewest
  quadmesh aerofoil.dat --farfield cgrid:20 -o aerofoil.msh
  quadmesh plate.dxf --drawing-layers plate,bore,bolts -o plate.msh
  quadmesh half_disc.step -o named.msh --name axis=0 --name wall@0,1
  quadmesh half_disc.step -o half_disc.msh --html half_disc.html
  quadmesh half_disc.step -o layers.msh --wall 0:first=0.001,growth=1.3,layers=10
  quadmesh bow_shock.step -o aligned.msh --align shock.json
  quadmesh bow_shock.step -o adapted.msh --metric metric.csv --align metric.csv
  quadmesh half_disc.step --until critpoints --workdir stages
  quadmesh half_disc.step --from separatrix --workdir stages -o half_disc.msh
  quadmesh half_disc.step --nodes stages/half_disc.crit.json -o half_disc.msh
  quadmesh half_cylinder.step --face 0 -o half_cylinder.msh
  quadmesh half_disc.step --sweep --height 2 --layers 8 --twist 90 -o twisted.msh
  quadmesh half_disc.step --dry-run -o half_disc.msh
)help";

}  // namespace

std::string help_text() { return brief_help; }

std::string full_help_text() {
  std::string text = own_help;
  StageOptions values;
  for (const ChainStage stage : {ChainStage::critpoints, ChainStage::separatrix, ChainStage::blocksplit,
                                 ChainStage::quadrefine, ChainStage::hexsweep, ChainStage::quadexport}) {
    std::string name = enum_name(stage);
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
    text += "\nOPTIONS OF " + name + '\n' + cli::option_rows([&](Options& o) { declare(o, stage, values); });
  }
  return text + help_end;
}

}  // namespace quadrille::chain
