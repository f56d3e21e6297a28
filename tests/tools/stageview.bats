# stageview: a picture of every kind of stage file.
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
    stageview <"$X.$file" >b.svg
    cmp a.svg b.svg
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

@test "--field puts critical points over their field, and no other" {
  run -0 stageview "$X.crit.json" --field "$X.field.h5" -o a.svg
  assert [ "$(shown '<title>boundary curve')" -ge 2 ]
  assert_equal "$(shown 'class="zero-u"')" 2 # the line and its legend
  fieldsolve "$X.tri.h5" --field-order 4 -o other.field.h5
  run -3 stageview "$X.crit.json" --field other.field.h5 -o b.svg
  run -2 stageview "$X.sep.json" --field "$X.field.h5" -o b.svg
  assert_file_not_exists b.svg
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
  run -2 stageview "$X.quad.h5" --curve-labels -o b.svg
  assert_output --partial "--curve-labels needs a tri-mesh file"
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

@test "the examples of --help run" {
  cp "$X".* .
  stageview --help | sed -n '/^EXAMPLES/,$p' | grep -oE 'stageview .*' >examples
  assert_equal "$(wc -l <examples)" 4
  while read -r line; do run -0 bash -c "$line"; done <examples
}
