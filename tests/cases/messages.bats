# What messages say where a user once read them wrong: each names what is the case, where, and what to do.
load ../tools/common

quadmesh=$ROOT/pipelines/quadmesh
points=$ROOT/pipelines/examples/aerofoil.dat

@test "an error that looks like its target is printed with as many digits as it takes" {
  cad2tri -q "$DATA/half_disc.step" | fieldsolve -q --field-order 4 >coarse.solve.h5
  run -0 padapt --max-order 5 coarse.solve.h5 -o a.field.h5
  assert_regex "$output" '^padapt: warning W-ADAPT-002: the estimated error of the field is up to [0-9.]+e-[0-9]+, above'
  local error seen=
  error=$(sed -E 's/.* is up to ([^,]+),.*/\1/' <<<"$output")
  # The greatest error rounds to this one: the first target below it that a warning names has the same two digits.
  for part in 1.02 1.01 1 0.99 0.98; do
    run -0 padapt --max-order 5 --target-error "$(awk -v x="$error" -v part=$part 'BEGIN { print x * part }')" \
      coarse.solve.h5 -o a.field.h5
    [[ $output == *W-ADAPT-002* ]] || continue
    assert_regex "$output" "is up to [0-9.]+e-[0-9]+, above the target $error, although"
    seen=$(sed -E 's/.* is up to ([^,]+),.*/\1/' <<<"$output")
    break
  done
  assert_regex "$seen" '^[0-9]\.[0-9]{2,}e-[0-9]+$'
}

@test "where there was a field, the warning of midpoint blocks says why no line could follow it" {
  stage_blocks . half_disc
  run -0 separatrix half_disc.field.h5 half_disc.crit.json --max-length 0.01 -o a.sep.json
  assert_output --regexp '^separatrix: warning W-SEP-002: .* has reached neither boundary nor node after .*: the face was divided into triangles, and each of them into three blocks, with many irregular nodes$'
  refute_output --partial 'there is no field'
  replace_stage critpoints 'while [ "$1" != --report ]; do shift; done' \
    "echo '{\"tool\": \"critpoints\", \"exit_code\": 1, \"error\": \"no luck\", \"warnings\": []}' >\"\$2\"" \
    'echo "critpoints: no luck" >&2' 'exit 1'
  run -0 "$quadmesh" "${replaced[@]}" "$DATA/half_disc.step" -o a.msh
  assert_line --index 1 'quadmesh: critpoints found no valid result: the quads are made without a field'
  assert_line --index 2 --regexp '^separatrix: warning W-SEP-002: there is no field that separatrices could follow: the face was divided'
}

@test "a far field of a CAD file, and one without radius, say what to do" {
  run -3 "$quadmesh" "$DATA/bracket.step" --farfield circle:20 -o a.msh
  assert_output "quadmesh: $DATA/bracket.step: a CAD file: --farfield and the other options of points do not apply: draw the region up to the far field in the CAD program, and leave them out"
  for command in "$quadmesh" "$ROOT/pipelines/points2step"; do
    run -2 "$command" "$points" --farfield cgrid -o a.step
    assert_line --index 0 "$(basename "$command"): --farfield: 'cgrid' has no radius: give it in chords, as in cgrid:20"
    run -2 "$command" "$points" --farfield ring:4 -o a.step
    assert_line --index 0 "$(basename "$command"): --farfield: 'ring:4' is not circle:R, box:R or cgrid:R"
  done
}

@test "a document of FreeCAD is named with the way to export it" {
  printf 'PK\3\4document' >part.FCStd
  for command in "cad2tri part.FCStd" "$quadmesh part.FCStd -o a.msh"; do
    # shellcheck disable=SC2086
    run -3 $command
    assert_output "cad2tri: part.FCStd: a document of FreeCAD: select the shape there, and export it as STEP (File, Export)"
  done
}

@test "what was healed has its length with the unit, if the file has one" {
  sed -E "s/^(#[0-9]+ = CIRCLE\('',#[0-9]+,)1\.\)/\11.000002)/" "$DATA/stadium.step" >slot.step
  run -0 cad2tri slot.step -o a.tri.h5 -v
  assert_line 'cad2tri: healed 4 joints; by at most 2e-06 millimetre (5e-07 diameters)'
  cad2tri -q slot.step -o b.tri.h5 --write-healed slot.brep # without a unit
  sed -E '/^2 /s/ 1\.000000000000000[0-9]*$/ 1.000002/' slot.brep >off.brep
  run -0 cad2tri off.brep -o a.tri.h5 -v
  assert_line 'cad2tri: healed 4 joints; by at most 2e-06 (5e-07 diameters)'
}

@test "curves beside the face are counted without those of other faces" {
  run -0 cad2tri "$DATA/bad/construction.step" --face 0 -o a.tri.h5
  assert_line --index 0 "cad2tri: warning W-CAD-001: $DATA/bad/construction.step: ignored 1 curve beside the face"
  run -0 cad2tri "$DATA/bad/solid.step" --face 4 -o a.tri.h5
  assert_output ''
}

@test "the history of a mesh from points names points2step with its options, and can be repeated" {
  cp "$points" .
  "$quadmesh" -q aerofoil.dat --farfield cgrid:20 --points-unit mm --size 3 --workdir stages -o a.msh
  run -0 stagecheck --history stages/aerofoil.quad.h5
  assert_line --index 0 "# aerofoil.dat: dat, SHA-256 $(sha256sum <aerofoil.dat | cut -d ' ' -f 1)"
  assert_line --index 1 'points2step --farfield=cgrid:20 --unit=mm aerofoil.dat -o aerofoil.step'
  PATH=$ROOT/pipelines:$PATH bash -euo pipefail <<<"${lines[1]} -q"
  cmp aerofoil.step stages/aerofoil.outline.step
}

@test "help says what the formats are, and how many elements --refine makes" {
  run -0 "$ROOT/pipelines/quadplace" --help
  assert_line --regexp '-o, --output FILE +mesh to write, in the format of its ending \(see quadexport --help;'
  for command in quadrefine "$quadmesh"; do
    run -0 "$command" --help-all
    assert_output --regexp '--refine N +nested refinement,.*becomes 2\^N x 2\^N elements'
    refute_output --partial '2^K'
  done
}

@test "selectors and wild cards name boundaries in every option that takes a boundary" {
  local flange=("$DATA/flange_3_holes.step" --size 0.4)
  elements() { jq --arg name "$1" '.boundaries[] | select(.name == $name) | .elements' a.json; }
  # The three small circles have a diameter of 0.44, the large one of 1.1.
  for name in 'bolts=circles(<0.5)' 'bolts=box(-3,-1.2,3,-0.5)' 'bolts=tangent(5)' 'bolts=6,7,9' 'bolts@1.4722,-0.85'; do
    "$quadmesh" -q "${flange[@]}" --name "$name" -o a.msh --report a.json
    assert [ "$(elements bolts)" -gt 0 ]
  done
  echo '{"bolts": "x"}' >wrong.json
  run -3 "$quadmesh" "${flange[@]}" --boundary-names wrong.json -o a.msh
  echo '{"circles(<0.5)": "bolts", "*": "rim"}' >names.json
  "$quadmesh" -q "${flange[@]}" --boundary-names names.json -o a.msh --report a.json
  assert_equal "$(jq -r '.boundaries | map(.name) | join(" ")' a.json)" 'rim bolts'
  local plain
  plain=$(elements bolts)
  "$quadmesh" -q "${flange[@]}" --boundary-names names.json --size-near 'bol*=0.05' -o a.msh --report a.json
  assert [ "$(elements bolts)" -gt $((2 * plain)) ]
  "$quadmesh" -q "${flange[@]}" --boundary-names names.json --count 'bol?s=48' -o a.msh --report a.json
  assert_equal "$(elements bolts)" 48
  "$quadmesh" -q "${flange[@]}" --boundary-names names.json --count 'circles(<0.5)=72,even' -o a.msh --report a.json
  assert_equal "$(elements bolts)" 72
  jq -e '.counts["0"].unevenness < 1e-6' a.json
  "$quadmesh" -q "${flange[@]}" --boundary-names names.json --wall 'b*:first=0.01,layers=2' -o a.msh --report a.json
  assert_equal "$(jq -r '.walls["0"].names' a.json)" 'b*'
  "$quadmesh" -q "$DATA/regions/plate_crack.step" --open 'cra*' --size 0.3 -o open.msh --report a.json
  local open
  open=$(jq .quads a.json)
  "$quadmesh" -q "$DATA/regions/plate_crack.step" --open crack --size 0.3 -o named.msh --report a.json
  assert_equal "$(jq .quads a.json)" "$open"
  cmp <(tail -n +5 open.msh) <(tail -n +5 named.msh)
}
