# Chromium opens pages of stageview: no message on the console, keys and pointer do what the page says.
load common

setup() {
  common_setup
  need chromium chromium-driver python3-selenium
}

# judge PAGE TABS [WORDS...]: as judge_page.py
judge() {
  run "$PYTHON" "$ROOT/tests/peers/judge_page.py" "$@"
  assert_output ''
  assert_success
}

@test "a page of all stages works by keys and pointer" {
  local shape blocks x
  for shape in "$DATA/gear_filleted.step" "$ROOT"/../shared/geometries/flange_3_holes.step; do
    [[ -e $shape ]] || continue
    blocks=$(blocks_of "$shape")
    x=${blocks%.blocks.h5}
    stageview "$x.tri.h5" "$x.field.h5" "$x.crit.json" "$x.sep.json" "$x.blocks.h5" "$x.quad.h5" -o page.html
    judge page.html 6 "$(basename "$shape" .step)"
  done
}

@test "the first view of a far field fits the body" {
  printf '%s\n' '1 0' '0.5 0.06' '0 0' '0.5 -0.06' >wing.dat
  "$ROOT/pipelines/quadmesh" -q wing.dat --farfield cgrid:20 -o wing.msh --workdir stages
  stageview stages/wing.quad.h5 -o far.html
  judge far.html 1 body wing
}

# fine_page PAGE: of 100,000 quads of order 5.
fine_page() {
  quadrefine -q --size 0.0039 --order 5 "$(blocks_of "$DATA/half_disc.step")" -o fine.quad.h5 --report report.json
  stageview fine.quad.h5 -o "$1"
}

@test "a page of 100,000 quads of order 5 has at most 30 MB and works" {
  fine_page page.html
  assert [ "$(jq .quads report.json)" -gt 100000 ]
  assert [ "$(stat -c %s page.html)" -lt 30000000 ]
  judge page.html 1
}

@test "the pointer turns hexahedra, a plane cuts them, also 100,000, on a dark and a narrow page" {
  local quads
  quads=$(blocks_of "$DATA/half_disc.step")
  quads=${quads%.blocks.h5}.quad.h5
  hexsweep "$quads" --height 1 --twist 90 --layers 8 -o twisted.hex.h5
  stageview "$quads" twisted.hex.h5 -o page.html
  run "$PYTHON" "$ROOT/tests/peers/judge_page.py" page.html 2 space
  assert_output ''
  quadrefine -q --size 0.02 "$(blocks_of "$DATA/half_disc.step")" -o fine.quad.h5
  hexsweep fine.quad.h5 --height 1 --layers 25 -o fine.hex.h5 --report report.json
  assert [ "$(jq .hexahedra report.json)" -gt 100000 ]
  stageview fine.hex.h5 -o page.html
  assert [ "$(stat -c %s page.html)" -lt 30000000 ]
  run "$PYTHON" "$ROOT/tests/peers/judge_page.py" page.html 1 space
  assert_output ''
}

@test "pages look as stored, also with another font, and the comparison notices a missing layer" {
  need python3-pil python3-numpy
  local x
  x=$(blocks_of "$DATA/bracket.step")
  x=${x%.blocks.h5}
  stageview "$x.tri.h5" "$x.field.h5" "$x.crit.json" "$x.sep.json" "$x.blocks.h5" "$x.quad.h5" -o stages.html
  fine_page fine.html
  for choice in --compare --font --drop; do
    run "$PYTHON" "$ROOT/tests/peers/screenshots.py" stages.html fine.html $choice
    assert_output ''
    assert_success
  done
}

@test "the page of a run shows its report, and two meshes lie side by side" {
  "$ROOT/pipelines/quadmesh" -q "$DATA/half_disc.step" -o out.msh --html run.html --workdir stages
  run "$PYTHON" "$ROOT/tests/peers/judge_page.py" run.html 7 report
  assert_output ''
  quadrefine -q --size 0.2 stages/half_disc.blocks.h5 -o other.quad.h5
  stageview --compare stages/half_disc.quad.h5 other.quad.h5 -o both.html
  run "$PYTHON" "$ROOT/tests/peers/judge_page.py" both.html 2 comparison
  assert_output ''
}

@test "labels of thin holes lie on the sides that they name, in every view" {
  local gap
  for gap in 0.02 0.2 2; do
    {
      echo '<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="60mm" viewBox="0 0 100 60">'
      echo '<path id="rim" d="M0 0H100V60H0z"/>'
      awk -v gap=$gap 'BEGIN { for (k = 0; k < 3; ++k) { y = 15 * (k + 1)
        printf "<path id=\"above-%d\" d=\"M30 %gH70\"/><path id=\"below-%d\" d=\"M30 %gH70\"/>\n", k, y, k, y + gap
        printf "<path id=\"left-%d\" d=\"M30 %gV%g\"/><path id=\"right-%d\" d=\"M70 %gV%g\"/>\n", k, y, y + gap, k, y, y + gap } }'
      echo '</svg>'
    } >holes.svg
    "$ROOT/pipelines/drawing2step" -q holes.svg -o holes.step
    cad2tri -q holes.step -o holes.tri.h5
    stageview holes.tri.h5 -o page.html
    run "$PYTHON" "$ROOT/tests/peers/judge_labels.py" page.html rim {above,below}-{0,1,2}
    assert_output ''
    assert_success
  done
}

@test "the table of quadbatch: sorted both ways by each column, long names cut, dark" {
  need parallel
  local long
  long=a_rather_long_name_of_a_shape_that_no_column_has_room_for
  cp "$DATA/annulus.step" $long.step
  run "$ROOT/pipelines/quadbatch" -q "$DATA"/{half_disc,square,plate_hole}.step "$DATA/bad/open_wire.step" ./$long.step \
    --to out --size 0.3
  run "$PYTHON" "$ROOT/tests/peers/judge_table.py" out/table.html $long
  assert_output ''
  assert_success
}
