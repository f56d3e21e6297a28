# The pages in formats/ against the code, the sample files and the schemas: one stem everywhere.
load tools/common

PAGES="cad-face $(stagecheck --list-formats | jq -r '.formats[].name' | tr '\n' ' ')"

@test "every page has all headings" {
  for page in $PAGES order-map alignment size-field boundary-names block-names; do
    for heading in Purpose "Who writes and reads it" "A complete small example" Conventions Rules "Reading it" "Version history"; do
      grep -qx "## $heading" "$ROOT/formats/$page.md" || fail "$page.md has no heading '$heading'"
    done
    grep -qxE "## (Arrays|Keys)" "$ROOT/formats/$page.md"
  done
}

@test "every page has its model, check, test and input/output of the same stem" {
  for page in $PAGES; do
    stem=${page//-/_}
    assert_file_exist "$ROOT/lib/core/model/$stem.hpp"
    assert_file_exist "$ROOT/lib/core/check/${stem}_check.cpp"
    assert_file_exist "$ROOT/tests/unit/check/${stem}_check_test.cpp"
    assert_file_exist "$ROOT/lib/files/io/${stem}_io.cpp"
    [ "$page" = cad-face ] || assert_dir_exist "$ROOT/tests/formats/$stem/passed"
  done
}

@test "pages, code and unit tests number the same rules" {
  for page in $PAGES; do
    stem=${page//-/_}
    in_page=$(grep -oE '^\| [A-Z]{3}-R[0-9]+ ' "$ROOT/formats/$page.md" | tr -d '| ' | sort)
    in_code=$(grep -oE '"[A-Z]{3}-R[0-9]+", RuleKind' "$ROOT/lib/core/check/${stem}_check.cpp" | cut -d'"' -f2 | sort)
    assert_equal "$in_page" "$in_code"
    for rule in $in_page; do
      grep -q "\"$rule\"" "$ROOT/tests/unit/check/${stem}"_*_test.cpp || fail "$rule has no test"
    done
  done
}

@test "the sample files are what make_format_samples writes" {
  cd "$BATS_TEST_TMPDIR"
  make_format_samples .
  count=0
  for file in */passed/* */failed/*; do
    cmp "$file" "$ROOT/tests/formats/$file"
    count=$((count + 1))
  done
  ((count > 30)) || fail "$count files"
}

@test "every dataset and key of the sample files is on its page" {
  for file in "$ROOT"/tests/formats/*/passed/*; do
    stem=$(basename "$(dirname "$(dirname "$file")")")
    page=$ROOT/formats/${stem//_/-}.md
    case $file in
      *.json) names=$(jq -r '.. | objects | keys[]' "$file" | sort -u) ;;
      *) names=$(h5dump -H "$file" | sed -n 's/.*DATASET "\(.*\)".*/\1/p' | sort -u) ;;
    esac
    for name in $names; do
      grep -qwE -- "$name|${name%_offsets}" "$page" "$ROOT/formats/cad-face.md" "$ROOT/formats/tri-mesh.md" "$ROOT/formats/README.md" ||
        fail "$name is not on ${page##*/}"
    done
  done
}

# block N LANGUAGE PAGE: the Nth block of code in that language on the page.
block() {
  awk -v wanted="$1" -v fence="\`\`\`$2" '$0 == "```" { inside = 0 } inside; $0 == fence { inside = ++n == wanted }' \
    "$ROOT/formats/$3.md"
}

@test "the examples on the JSON pages are the sample files" {
  for stem in critical_points separatrix_graph; do
    block 1 json ${stem//_/-} | cmp - "$ROOT"/tests/formats/$stem/passed/square.*
  done
  block 2 json critical-points | cmp - "$ROOT/tests/formats/critical_points/passed/resolved.crit.json"
}

@test "points edited as the page tells stay valid" {
  cp "$ROOT/tests/formats/critical_points/passed/square.crit.json" x.crit.json
  block 1 sh critical-points |
    awk 'sub(/x\.crit\.json$/, "x.crit.json >edited-" n + 1 ".crit.json") { ++n } 1' >edit.sh
  bash -e edit.sh
  for edited in edited-1 edited-2; do
    stagecheck $edited.crit.json
    validates critical-points $edited.crit.json
    run ! cmp x.crit.json $edited.crit.json
  done
  assert_equal "$(jq -c '[.critical_points[0].position, .critical_points[0].valence]' edited-1.crit.json)" '[[0.35,0.5],3]'
  assert_equal "$(jq -c '[.corners[2].valence, (.critical_points | length)]' edited-2.crit.json)" '[2,3]'
  jq '.critical_points[0].valence = 5' x.crit.json >broken.crit.json
  run -3 stagecheck broken.crit.json
}

@test "the example on the page of order maps keeps its schema" {
  sed -n '/^```json$/,/^```$/p' "$ROOT/formats/order-map.md" | sed '1d;$d' > orders.json
  validates order-map orders.json
  for edit in '.elem_order[0] = 0' '.version = [2, 0]' 'del(.elem_order)' '.elem_order[1] = 1.5'; do
    jq "$edit" orders.json > edited.json
    run validates order-map edited.json
    assert_failure
  done
}

@test "the examples on the pages of names keep their schemas and are read" {
  stage_chain half_disc
  for stem in boundary-names block-names; do
    count=$(grep -c '^```json$' "$ROOT/formats/$stem.md")
    for ((i = 1; i <= count; ++i)); do
      block $i json $stem > names.json
      validates $stem names.json
      case $stem in
        boundary-names)
          cad2tri "$DATA/half_disc.step" --boundary-names names.json -o a.tri.h5
          h5dump -A 0 -d /face/curve_names a.tri.h5 | tr -d '\n' | grep -q 'symmetry.*wall' ;;
        block-names)
          blocksplit half_disc.sep.json --block-names names.json -o a.blocks.h5
          stagecheck a.blocks.h5
          h5dump -A 0 -d /block_names a.blocks.h5 | grep -oE 'core|ring|fluid' | sort | uniq -c | tr -s ' \n' '  ' >> regions ;;
      esac
    done
    for wrong in '[{"id": 0}]' '[{"id": -1, "name": "a"}]' '{"0": 3}' '{"0": ""}' '""' '[{"name": "a"}]' '3' \
      '[{"id": 0, "at": [0, 0], "near": [0, 0], "name": "a"}]' '[{"at": [0], "name": "a"}]' '[{"near": [0], "name": "a"}]'; do
      echo "$wrong" > names.json
      run validates $stem names.json
      assert_failure
      run -3 cad2tri "$DATA/half_disc.step" --boundary-names names.json -o b.tri.h5
      run -3 blocksplit half_disc.sep.json --block-names names.json -o b.blocks.h5
    done
  done
  assert_equal "$(cat regions)" " 1 core 3 ring  4 fluid  4 fluid "
}

@test "the example on the page of size fields keeps its schema" {
  sed -n '/^```json$/,/^```$/p' "$ROOT/formats/size-field.md" | sed '1d;$d' > sizes.json
  validates size-field sizes.json
  for edit in '.points[0].size = 0' '.version = [2, 0]' 'del(.points, .boxes)' '.boxes[0].low = [1]' \
    'del(.points[0].position)' '.points[0].radius = -1' '.growth = 1'; do
    jq "$edit" sizes.json > edited.json
    run validates size-field edited.json
    assert_failure
  done
}

@test "the example on the page of alignments keeps its schema and is read" {
  sed -n '/^```json$/,/^```$/p' "$ROOT/formats/alignment.md" | sed '1d;$d' > align.json
  validates alignment align.json
  cad2tri "$DATA/duct.step" -o duct.tri.h5
  fieldsolve --align align.json duct.tri.h5 -o a.solve.h5
  stagecheck a.solve.h5
  for edit in '.points[0].width = 0' '.version = [2, 0]' 'del(.points, .curves, .boxes)' '.boxes[0].low = [1]' \
    'del(.points[0].angle)' '.points[0].strength = -1' '.curves[0].positions = [[0, 0]]' \
    '.points = [] | .curves = [] | .boxes = []'; do
    jq "$edit" align.json > edited.json
    run validates alignment edited.json
    assert_failure
    run -3 fieldsolve --align edited.json duct.tri.h5 -o b.solve.h5
  done
  sed -n '/^## As a table/,/^## Rules/p' "$ROOT/formats/alignment.md" | sed -n '/^```$/,/^```$/p' | sed '1d;$d' > metric.csv
  fieldsolve --align metric.csv duct.tri.h5 -o b.solve.h5
  stagecheck b.solve.h5
}

# validates FORMAT FILE: whether the schema accepts the file.
validates() {
  python3 - "$ROOT/formats/$1.schema.json" "$2" << 'PYTHON'
import json, sys, jsonschema
schema, instance = (json.load(open(path)) for path in sys.argv[1:])
jsonschema.Draft7Validator.check_schema(schema)
jsonschema.Draft7Validator(schema).validate(instance)
PYTHON
}

@test "the schemas accept what the tools write" {
  stage_chain half_disc
  validates critical-points half_disc.crit.json
  validates separatrix-graph half_disc.sep.json
}

@test "the schemas accept the samples and refuse files that lack or mistype a member" {
  crit=$ROOT/tests/formats/critical_points/passed/square.crit.json
  sep=$ROOT/tests/formats/separatrix_graph/passed/square.sep.json
  validates critical-points "$crit"
  validates critical-points "${crit%/*}/resolved.crit.json"
  validates critical-points "${crit%/*}/regions.crit.json"
  validates separatrix-graph "$sep"
  for edit in 'del(.corners)' '.version = [1, 2]' '.format = "field"' '.critical_points[0].index = 0' \
    '.critical_points[0].position = [1]' '.corners[0].valence = 1.5' '.index_sum.expected = 3' '.form = "nice"' \
    'del(.critical_points[0].valence)' '.certificate.cells = 1' '.boundary_nodes = [{"curve": 0}]' \
    '.changes = [{"kind": "place", "reason": 1, "before": [], "after": []}]'; do
    jq "$edit" "$crit" > edited.json
    run validates critical-points edited.json
    assert_failure
  done
  for edit in 'del(.face)' '.nodes[0].kind = "nice"' '.arcs[0].pieces = []' '.splines[0].weights[0] = 0' 'del(.face.curves[0].degree)'; do
    jq "$edit" "$sep" > edited.json
    run validates separatrix-graph edited.json
    assert_failure
  done
  for edit in 'face.region_loops = [-1]' 'face.region_names = [0]' 'face.partners = [-2]' 'face.periodic_pairs = [{}]'; do
    for file in "${crit%/*}/regions.crit.json" "$sep"; do
      jq ".$edit" "$file" > edited.json
      run validates "$(jq -r .format "$file")" edited.json
      assert_failure
    done
  done
}

@test "every format of quadexport has a row and a page, with what is written, what is lost and how to get going" {
  sed -n '/^## Formats of other programs/,/^## What/p' "$ROOT/formats/README.md" | grep '^| \[' >rows
  quadexport --help | sed -nE '/^  --format /,/^  --frame/s/^ +([a-z0-9-]+): .*/\1/p' | grep -vE '^(auto|step)$' | sort >formats
  assert [ "$(wc -l <formats)" -ge 11 ]
  cut -d'|' -f3 rows | grep -oE '[a-z0-9-]+' | sort | diff - formats
  while read -r page; do
    for heading in "What is written" "What is lost" "Getting going"; do
      grep -qx "## $heading" "$ROOT/formats/$page" || fail "$page has no heading '$heading'"
    done
  done < <(sed -nE 's/^\| \[[^]]*\]\(([^)]*)\).*/\1/p' rows)
  diff <(sed -nE 's/^\| \[[^]]*\]\(export\/([^)]*)\).*/\1/p' rows | sort -u) <(ls "$ROOT/formats/export")
  sed -n '/^## Into your solver/,/^## The tools$/p' "$ROOT/README.md" | grep -oE 'formats/export/[a-z0-9-]+\.md' | cut -d/ -f3 |
    sort -u | diff - <(ls "$ROOT/formats/export")
}
