# stageview: a picture and a page of every kind of stage file.
load common

setup_file() {
  stage_chain half_disc "$BATS_FILE_TMPDIR"
}

setup() {
  common_setup
  X=$BATS_FILE_TMPDIR/half_disc
}

@test "every stage file gives a well-formed picture, silently, and the same bytes twice" {
  for file in tri.h5 solve.h5 field.h5 crit.json sep.json blocks.h5 quad.h5; do
    run -0 stageview "$X.$file" -o a.svg
    assert_output ''
    xmllint --noout a.svg
    run ! grep -iE '\bnan\b|\binf\b' a.svg
    stageview "$X.$file" >b.svg
    cmp a.svg b.svg
    stageview <"$X.$file" >b.svg
    cmp <(sed 's|<text class="file"[^<]*</text>||' a.svg) b.svg # without the name of the file
  done
}

# shown PATTERN: how many lines of a.svg match.
shown() { grep -cE "$1" a.svg; }

@test "a picture shows every element, block, line and point" {
  cad2tri "$DATA/half_disc.step" --report report.json | stageview -o a.svg
  assert_equal "$(shown 'id="elem-')" "$(jq .mesh.elements report.json)"
  stageview "$X.crit.json" -o a.svg
  assert_equal "$(shown '<title>critical point of valence 3')" 2
  assert_equal "$(shown '<title>corner at .*, 90 degrees, valence 1')" 2
  stageview "$X.sep.json" -o a.svg
  assert_equal "$(shown 'id="line-')" "$(jq '.lines | length' "$X.sep.json")"
  assert_equal "$(shown '<title>node ')" "$(jq '.nodes | length' "$X.sep.json")"
  stageview "$X.blocks.h5" -o a.svg
  assert_equal "$(shown 'id="block-')" 4
  quadrefine "$X.blocks.h5" --report report.json | stageview -o a.svg
  assert_equal "$(shown 'id="elem-')" "$(jq .quads report.json)"
}

@test "--show chooses what is drawn of a field, --width the size" {
  for show in psi u v order; do
    stageview "$X.field.h5" --show $show --width 400 -o $show.svg
    xmllint --noout $show.svg
    grep -q 'width="400"' $show.svg
  done
  run ! cmp u.svg v.svg
  run -2 stageview "$X.field.h5" --show w -o a.svg
  assert_file_not_exists a.svg
}

@test "a picture has the name of the file without folders, and a scale bar with the unit" {
  stageview "$X.quad.h5" -o a.svg
  assert_equal "$(shown '>half_disc.quad.h5<')" 1
  run ! grep -F "$BATS_FILE_TMPDIR" a.svg
  assert_equal "$(shown 'class="scale"')$(shown '>0.2 mm<')" 11
}

@test "--field puts critical points over their field, and no other" {
  run -0 stageview "$X.crit.json" --field "$X.field.h5" -o a.svg
  assert [ "$(shown '<title>boundary curve')" -ge 2 ]
  assert_equal "$(shown 'class="zero-u"')" 2 # the line and its legend
  fieldsolve "$X.tri.h5" --field-order 4 -o other.field.h5
  run -3 stageview "$X.crit.json" --field other.field.h5 -o b.svg
  run -2 stageview "$X.sep.json" --field "$X.field.h5" -o b.svg
  assert_file_not_exists b.svg
}

@test "critical points alone are drawn in the outline of their face" {
  stageview "$X.crit.json" -o a.svg
  assert_equal "$(shown '<title>boundary curve')$(shown 'class="zero-u"')" 20
  assert_equal "$(shown '>0.2 mm<')" 1
  stageview "$X.crit.json" --curve-labels | grep -q 'class="label"[^>]*>0<'
  stageview "$X.crit.json" -o a.html
  page_data a.html | jq -e '.sheets[0].boundary.names | length == 2'
  jq 'del(.face)' "$X.crit.json" | stageview -o a.svg # a file of an older version, or made by hand
  assert_equal "$(shown '<title>boundary curve')" 0
  jq '.face.curves[0].knots = [0, 1]' "$X.crit.json" >damaged.crit.json
  run -3 stageview damaged.crit.json -o b.svg
  assert_output --partial 'FAC-R'
  assert_file_not_exists b.svg
}

@test "of several regions the names are shown, and each interface once, in a colour of its own" {
  formats=$ROOT/tests/formats
  for file in tri_mesh/passed/regions.tri.h5 field/passed/regions{,-phase}.field.h5 critical_points/passed/regions.crit.json; do
    stageview "$formats/$file" -o a.svg
    xmllint --noout a.svg
    assert_equal "$(shown '<title>interface, curves 1 and 7: fluid-solid')" 1
    assert_equal "$(shown 'class="interface"')" 2 # and its mark in the legend
    assert_equal "$(shown '<title>boundary curve')" 6
    assert_equal "$(shown 'class="region".*>(fluid|solid)<')" 2
    stageview "$formats/$file" --no-curve-labels -o a.svg
    assert_equal "$(shown 'class="region"')" 0
    stageview "$formats/$file" -o a.html
    assert_equal "$(grep -cE '"regions":\[\["fluid",.*"solid"' a.html)" 1
  done
  stageview "$formats/tri_mesh/passed/slit.tri.h5" -o a.svg
  assert_equal "$(shown '<title>slit, curves 4 and 5: crack')" 1
  assert_equal "$(shown 'class="slit"')" 2
}

@test "--curve-labels writes number and name beside each boundary curve, without overlaps" {
  cad2tri "$DATA/gear_filleted.step" --name inlet=0 --name 'the hole=36' -o gear.tri.h5
  run -0 stageview gear.tri.h5 --curve-labels -o a.svg
  assert_output ''
  xmllint --noout a.svg
  assert_equal "$(grep -oP '(?<=class="label")[^>]*>\K[0-9]+' a.svg | sort -n | tr '\n' ' ')" "$(echo {0..36}) "
  assert_equal "$(shown '>0 inlet<')$(shown '>36 the hole<')" 11
  stageview gear.tri.h5 -o plain.svg
  run ! grep -q 'class="label"' plain.svg
  assert_equal "$(grep -oP '(?<=class="name")[^>]*>\K[^<]+' plain.svg | sort | tr '\n' ' ')" "inlet the hole "
  stageview gear.tri.h5 --no-curve-labels -o plain.svg
  run ! grep -q '<text class="name"' plain.svg
  fieldsolve gear.tri.h5 --field-order 2 | stageview -o a.svg
  assert_equal "$(shown '<text class="name".*>inlet<')" 1
  jq 'del(.face)' "$X.crit.json" >no_face.crit.json
  run -2 stageview no_face.crit.json --curve-labels -o b.svg
  assert_line "stageview: --curve-labels needs --field, as no_face.crit.json does not contain the face"
  run -2 stageview gear.tri.h5 --curve-labels --no-curve-labels -o b.svg
}

@test "what is no stage file is refused with exit 3" {
  run -3 stageview "$DATA/half_disc.step" -o a.svg
  assert_output --regexp '^stageview: .*half_disc.step'
  run -3 stageview missing.h5 -o a.svg
  assert_file_not_exists a.svg
}

@test "pictures can be drawn: librsvg reads them" {
  command -v rsvg-convert >/dev/null || skip "no rsvg-convert"
  for file in tri.h5 field.h5 crit.json sep.json blocks.h5 quad.h5; do
    stageview "$X.$file" | rsvg-convert -o "$file.png"
    assert_file_not_empty "$file.png"
  done
}

@test "--window shows a part of the plane, in the coordinates of the file" {
  for file in tri.h5 field.h5 crit.json sep.json blocks.h5 quad.h5; do
    run -0 stageview "$X.$file" --window -1,0,0,0.5 -o a.svg
    assert_output ''
    xmllint --noout a.svg
    assert_equal "$(shown 'class="frame"')$(shown '<clipPath id="window"><rect width="928" height="464"/>')" 11
  done
  run -2 stageview "$X.quad.h5" --window 5,5,6,6 -o b.svg
  assert_output --regexp 'nothing is there; the picture extends from \(-1, .*\) to \(1, 1\)'
  for window in 1,2,3 0,0,0,1 0,1,1,0 a,b,c,d 0,0,1,nan 0,0,1,1,; do
    run -2 stageview "$X.quad.h5" --window "$window" -o b.svg
    assert_line --partial "--window: '$window' is not X0,Y0,X1,Y1"
  done
  run -2 stageview "$X.quad.h5" --window 0,0,1,1 -o b.html
  assert_file_not_exists b.svg
}

@test "--bare draws without title, labels and legend" {
  run -0 stageview "$X.blocks.h5" --bare --width 300 -o a.svg
  assert_output ''
  xmllint --noout a.svg
  assert_equal "$(grep -c '<text' a.svg)" 0
  assert [ "$(grep -c 'id="block-' a.svg)" -gt 0 ]
  run -2 stageview "$X.blocks.h5" --bare -o a.html
  assert_output --partial '--bare is for the picture of one stage in the plane: give no page, --compare or --view'
}

@test "names that end in .png and .pdf choose the format, with the same bytes each time" {
  command -v rsvg-convert >/dev/null || skip "no rsvg-convert"
  for ending in png pdf; do
    run -0 stageview "$X.quad.h5" -o a.$ending
    assert_output ''
    SOURCE_DATE_EPOCH=86400 stageview "$X.quad.h5" -o b.$ending # another date would show in a time stamp
    cmp a.$ending b.$ending
  done
  assert_equal "$(head -c 4 a.png | tail -c 3)$(head -c 4 a.pdf)" PNG%PDF
  stageview "$X.quad.h5" --width 300 -o c.png
  assert_equal "$(od -An -tu1 -j 18 -N 2 c.png | xargs)" "1 44" # 300 pixels
}

@test "without rsvg-convert, PNG and PDF are refused with a message, SVG is written" {
  mkdir bin
  ln -s "$BIN/stageview" bin/
  PATH=$PWD/bin run -4 stageview "$X.quad.h5" -o a.png
  assert_output "stageview: a.png: cannot be written: the program rsvg-convert is not installed (package librsvg2-bin of Debian): install it, or end the name in .svg"
  assert_file_not_exists a.png
  PATH=$PWD/bin run -0 stageview "$X.quad.h5" -o a.svg
}

@test "every stage file gives a page that needs nothing else, silently, and the same bytes twice" {
  for file in tri.h5 solve.h5 field.h5 crit.json sep.json blocks.h5 quad.h5; do
    run -0 stageview "$X.$file" -o a.html
    assert_output ''
    run ! grep -qE 'https?:|src=|@import|url\(|import\(|fetch\(' a.html
    run ! grep -qF "$BATS_FILE_TMPDIR" a.html
    page_data a.html >data.json
    assert_equal "$(jq '.sheets | length' data.json)" 1
    stageview "$X.$file" -o b.html
    cmp a.html b.html
  done
}

# page_data FILE: the data of a page, JSON.
page_data() {
  sed -n 's/^.*<script type="application\/json" id="data">\(.*\)<\/script>$/\1/p' "$1"
}

@test "several files of one chain are tabs of one page, in their order" {
  run -0 stageview "$X.tri.h5" "$X.field.h5" "$X.crit.json" "$X.sep.json" "$X.blocks.h5" "$X.quad.h5" -o a.html
  page_data a.html >data.json
  assert_equal "$(jq -c '[.sheets[].title]' data.json)" \
    '["Triangle mesh","Guiding field","Critical points","Separatrices","Blocks","Quad mesh"]'
  stageview "$X.crit.json" --field "$X.field.h5" -o b.html
  assert_equal "$(page_data b.html | jq -c '[.sheets[].title]')" '["Guiding field","Critical points"]'
}

@test "files of different chains, and several files without a page, are refused" {
  fieldsolve "$X.tri.h5" --field-order 4 -o other.field.h5
  run -3 stageview "$X.field.h5" other.field.h5 -o a.html
  assert_output --partial 'was not made from'
  run -2 stageview "$X.tri.h5" "$X.quad.h5" -o a.svg
  assert_line "stageview: several files are shown by a page only: give -o with a name that ends in .html"
  assert_nothing_left other.field.h5
}

@test "--compare shows two files of one format, which need not be of one chain" {
  quadrefine "$X.blocks.h5" --size 0.2 -o b.quad.h5
  run -0 stageview --compare "$X.quad.h5" b.quad.h5 -o a.html
  assert_output ''
  assert_equal "$(page_data a.html | jq -c '[.comparison, (.sheets | length)]')" '[true,2]'
  stageview --compare "$X.sep.json" "$X.sep.json" -o b.html
  assert_equal "$(page_data b.html | jq -r '.sheets[1].title')" Separatrices
  run -2 stageview --compare "$X.quad.h5" "$X.blocks.h5" -o c.html
  assert_line 'stageview: --compare needs two files of one format: two layouts, or two meshes'
  run -2 stageview --compare "$X.tri.h5" "$X.tri.h5" -o c.html
  assert_line --partial '--compare needs layouts or meshes'
  run -2 stageview --compare "$X.quad.h5" -o c.html
  assert_file_not_exists c.html
}

@test "--compare draws both side by side at one scale, with a table, as every kind of picture" {
  quadrefine "$X.blocks.h5" --size 0.2 -o b.quad.h5 --report b.json
  quadrefine "$X.blocks.h5" -o a.quad.h5 --report a.json
  run -0 stageview --compare a.quad.h5 b.quad.h5 --width 1400 -o a.svg
  assert_output ''
  xmllint --noout a.svg
  assert_equal "$(shown 'A: Quad mesh</text>')$(shown 'B: Quad mesh</text>')$(shown '>a.quad.h5<')$(shown '>b.quad.h5<')" 1111
  assert_equal "$(shown 'id="[ab]-elem-')" "$(jq -s 'map(.quads) | add' a.json b.json)"
  assert_equal "$(sed -n '/id="table"/,$p' a.svg | grep -A2 '>quads<' | grep -oE '>[0-9]+<' | tr -d '<>' | xargs)" \
    "$(jq -r .quads a.json b.json | xargs)"
  stageview --compare "$X.sep.json" "$X.sep.json" -o b.svg
  stageview --compare "$X.blocks.h5" "$X.blocks.h5" --window 0,0,0.5,0.5 | xmllint --noout -
  run -2 stageview --compare a.quad.h5 b.quad.h5 --field "$X.field.h5" -o c.svg
  run -2 stageview --compare a.quad.h5 "$X.blocks.h5" -o c.svg
  assert_file_not_exists c.svg
  command -v rsvg-convert >/dev/null || return 0
  stageview --compare a.quad.h5 b.quad.h5 -o c.png
  stageview --compare a.quad.h5 b.quad.h5 -o c.pdf
}

@test "--run-report adds a report and the commands to a page of one chain" {
  quadrefine "$X.blocks.h5" -o mesh.quad.h5 --report report.json
  run -0 stageview "$X.blocks.h5" mesh.quad.h5 --run-report report.json -o a.html
  assert_output ''
  page_data a.html >data.json
  assert_equal "$(jq .report.quads data.json)" "$(jq .quads report.json)"
  assert_equal "$(jq -r '.commands[-1]' data.json | grep -oE ' mesh.blocks.h5 -o .*')" " mesh.blocks.h5 -o mesh.quad.h5"
  echo '["no report"]' >list.json
  run -3 stageview mesh.quad.h5 --run-report list.json -o b.html
  assert_output "stageview: list.json: expected a report, a JSON object (formats/report.md)"
  run -2 stageview mesh.quad.h5 --run-report report.json -o b.svg
  run -2 stageview --compare mesh.quad.h5 mesh.quad.h5 --run-report report.json -o b.html
  assert_file_not_exists b.html
}

@test "--workbench makes the page that edits, or its data alone" {
  echo '{"state": {"size": 1}}' >bench.json
  run -0 stageview "$X.blocks.h5" "$X.quad.h5" --workbench bench.json -o a.html
  assert_output ''
  stageview "$X.blocks.h5" "$X.quad.h5" --workbench bench.json -o a.json
  cmp <(page_data a.html | jq -c .) <(jq -c . a.json)
  assert_equal "$(jq -c '[.workbench.state.size, (.sheets | length)]' a.json)" '[1,2]'
  echo '[]' >list.json
  run -3 stageview "$X.quad.h5" --workbench list.json -o b.html
  assert_output "stageview: list.json: expected the state of a workbench, a JSON object (pipelines/quadbench.md)"
  run -2 stageview "$X.quad.h5" --workbench bench.json -o b.svg
  run -2 stageview "$X.quad.h5" -o b.json
  run -2 stageview --compare "$X.quad.h5" "$X.quad.h5" --workbench bench.json -o b.json
  assert_file_not_exists b.html b.svg b.json
}

@test "names are escaped in a page" {
  cad2tri "$DATA/half_disc.step" --boundary-names <(echo '{"*": "</script><b>&"}') -o named.tri.h5
  stageview named.tri.h5 -o a.html
  assert_equal "$(grep -c '</script><b>' a.html)" 0
  page_data a.html | jq -e '.sheets[0].boundary.names | all(startswith("</script><b>&"))'
}

@test "a page of many quads of high order is small: less than 200 bytes for each" {
  quadrefine "$X.blocks.h5" --size 0.04 --order 7 -o fine.quad.h5 --report report.json
  stageview fine.quad.h5 -o a.html
  assert [ "$(stat -c %s a.html)" -lt $((60000 + 200 * $(jq .quads report.json))) ]
}

@test "a page of a field is small: less than 1 MB, also where its orders are high" {
  cad2tri -q "$DATA/gear_filleted.step" | fieldsolve -q | padapt -q -o gear.field.h5
  stageview gear.field.h5 -o a.html
  assert [ "$(stat -c %s a.html)" -lt 1000000 ]
}

@test "the examples of --help run" {
  cp "$X".* .
  stageview --help | sed -n '/^EXAMPLES/,$p' | grep -oE 'stageview .*' >examples
  assert_equal "$(wc -l <examples)" 8
  command -v rsvg-convert >/dev/null || sed -i '/p[dn][fg]$/d' examples
  while read -r line; do run -0 bash -c "$line"; done <examples
}
