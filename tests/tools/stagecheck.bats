# stagecheck: the numbered rules of every stage file.
load common

setup_file() {
  stage_chain half_disc "$BATS_FILE_TMPDIR"
}

setup() {
  common_setup
  stem=$BATS_FILE_TMPDIR/half_disc
}

@test "every file of the chain passes, silently" {
  run --separate-stderr stagecheck "$stem".{tri,solve,field,blocks,quad}.h5 "$stem".{crit,sep}.json
  assert_success
  assert_equal "$output$stderr" ""
}

@test "-v says what was checked" {
  run --separate-stderr stagecheck -v "$stem.crit.json"
  assert_success
  assert_equal "$stderr" "stagecheck: $stem.crit.json: critical-points, all rules hold"
}

@test "a broken rule is printed with file, number and place, and ends with 3" {
  jq '.corners[0].valence = 3' "$stem.crit.json" > edited.json
  run --separate-stderr stagecheck edited.json
  assert_equal "$status" 3
  assert_regex "$output" '^edited.json: CRT-R05: '
  assert_equal "$stderr" "stagecheck: 1 of 1 file is broken"
}

@test "all files are checked, and the broken ones counted" {
  jq '.arcs[0].to = 9999' "$stem.sep.json" > edited.json
  run --separate-stderr stagecheck "$stem.crit.json" edited.json no/such/file "$stem.tri.h5"
  assert_equal "$status" 3
  assert_equal "${#lines[@]}" 2
  assert_equal "$stderr" "stagecheck: 2 of 4 files are broken"
}

@test "one flipped bit of an HDF5 file is noticed" {
  cp "$stem.quad.h5" a.quad.h5
  printf '\xff' | dd of=a.quad.h5 bs=1 seek=5000 conv=notrunc status=none
  printf '\xfe' | dd of=a.quad.h5 bs=1 seek=5001 conv=notrunc status=none
  run stagecheck a.quad.h5
  assert_equal "$status" 3
  assert_output --partial "damaged: its checksum does not match its data"
}

@test "each format with a newer and an older major version, and each with one broken rule" {
  for file in "$ROOT"/tests/formats/*/passed/*; do
    run stagecheck "$file"
    assert_success
  done
  for file in "$ROOT"/tests/formats/*/failed/*; do
    run --separate-stderr stagecheck "$file"
    assert_equal "$file $status" "$file 3"
    case $file in
      *version-newer*) assert_output --partial "is newer than this program" ;;
      *version-older*) assert_output --partial "is from an older program" ;;
      *) name=$(basename "$file") && assert_output --partial ": ${name%%.*}: " ;;
    esac
  done
}

@test "--list-formats prints the table of formats for scripts" {
  run -0 --separate-stderr stagecheck --list-formats
  assert_equal "$(jq -r '[.formats[].name] | join(" ")' <<<"$output")" \
    "chart tri-mesh field critical-points separatrix-graph block-layout quad-mesh hex-mesh"
  assert_equal "$(jq -c '.tools[] | select(.after == "padapt")' <<<"$output")" \
    '{"name":"critpoints","after":"padapt","writes":"critical-points","ending":"crit.json"}'
  assert_equal "$(jq -r '.optional_inputs[] | select(.format == "size-field") | .tool + " " + .option' <<<"$output")" \
    "quadrefine --size-field"
  for file in "$ROOT"/tests/formats/*/passed/square.*; do
    ending=${file##*/square.}
    assert [ "$(jq --arg ending "$ending" '[.tools[] | select(.ending == $ending)] | length' <<<"$output")" = 1 ]
  done
}

@test "regions and partners that do not fit are refused" {
  crit=$ROOT/tests/formats/critical_points/passed/regions.crit.json
  for broken in 'FAC-R01 .face.partners |= .[1:]' 'FAC-R01 .face.partners[1] = 99' 'FAC-R01 del(.face.region_names)' \
    'FAC-R02 .face.region_loops = [0, 2, 1]' 'FAC-R09 .face |= del(.region_loops, .region_names)' \
    'FAC-R11 .face.partners[1] = 6' 'FAC-R11 .face.curves[7].poles[0] = [1, 0.999999999999]' \
    'FAC-R12 .face.periodic_pairs[0].angle = 0.001' 'CRT-R06 .index_sum.expected = 4'; do
    jq "${broken#* }" "$crit" >edited.json
    run -3 --separate-stderr stagecheck edited.json
    assert_output --partial ": ${broken%% *}: "
  done
}

@test "HDF5 files are what h5dump shows" {
  command -v h5dump || skip "no h5dump"
  run h5dump -a /format "$stem.quad.h5"
  assert_success
  assert_output --partial '"quad-mesh"'
  run h5dump -H "$stem.tri.h5"
  assert_success
  assert_output --partial 'DATASET "elem2vertices"'
}
