# The pages of the project against each other and against the sources (tests/pages.py has the checks).
load tools/common

check() {
  run python3 "$ROOT/tests/pages.py" "$ROOT" "$@"
  assert_output ''
  assert_success
}

@test "every link between pages leads to a file, and to a heading where it names one" {
  check links
}

@test "every page, section, test and source that pages and comments cite exists" {
  check citations
}

@test "every option that a page names is one of a command" {
  check options
}

@test "every area of lib and every folder of it has a short page that names what comes in, what goes out and a header to start with" {
  check folders
}

@test "formats/README.md lists every schema" {
  check schemas
}

@test "formats/report.md lists exactly the warnings that sources issue" {
  check warnings
}

@test "formats/report.md lists exactly the report keys that sources set" {
  check keys
}

@test "the names in code that the glossary and the pages of lib give are names of lib" {
  check terms
}

# chain_with_reports SHAPE: every stage, with TOOL.json beside; what has two runs has TOOL.2.json.
chain_with_reports() {
  local x=$1
  cad2chart "$DATA/curved/tube.step" -o tube.chart.h5 --report cad2chart.json
  cad2tri "$DATA/$x.step" -o $x.tri.h5 --report cad2tri.json
  fieldsolve $x.tri.h5 -o $x.solve.h5 --report fieldsolve.json
  padapt $x.solve.h5 -o $x.field.h5 --report padapt.json
  critpoints --place energy $x.field.h5 -o $x.crit.json --report critpoints.json
  fieldsolve --nodes $x.crit.json $x.tri.h5 -o $x.nodes.h5 --report fieldsolve.2.json
  padapt $x.nodes.h5 -o $x.phase.h5 --report padapt.2.json
  separatrix $x.phase.h5 $x.crit.json -o $x.sep.json --report separatrix.json
  separatrix --layout quantized $x.phase.h5 $x.crit.json -o $x.2.sep.json --report separatrix.2.json
  blocksplit $x.sep.json -o $x.blocks.h5 --report blocksplit.json
  quadrefine --relax shape --relax-sweeps 2 --wall 0:first=0.01,growth=1.3,layers=3 $x.blocks.h5 -o $x.quad.h5 --report quadrefine.json
  quadexport $x.quad.h5 -o $x.msh --report quadexport.json
  stageview $x.quad.h5 -o $x.svg --report stageview.json
  stagecheck $x.quad.h5 --report stagecheck.json
}

@test "every key that the tools write is on the page" {
  chain_with_reports half_disc
  for tool in cad2chart cad2tri fieldsolve padapt critpoints separatrix blocksplit quadrefine quadexport stageview stagecheck; do
    check keys "$tool" "$tool".*json
  done
  run -3 padapt half_disc.msh --report failed.json
  check keys padapt failed.json
}

@test "the keys of quadmesh are those on the page" {
  "$ROOT/pipelines/quadmesh" -q "$DATA/square.step" -o square.msh --report quadmesh.json
  check keys quadmesh quadmesh.json
}
