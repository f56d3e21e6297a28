# ISM-V2, HOHQMesh's .inp, Nek5000's .re2 and OpenFOAM's blockMeshDict, read by parsers of their own (tests/exports) and
# compared to the stage file.
load ../tools/common

setup_file() {
  stage_blocks "$BATS_FILE_TMPDIR" half_disc plate_hole s_bend
}

setup() {
  common_setup
  compare=$ROOT/tests/exports/compare
  cells=$ROOT/tests/exports/read_blockmesh.py
  blocks=$BATS_FILE_TMPDIR
}

# exports: all four formats of a.quad.h5; then what the readers say of them. Sides count as straight within 1e-10 of their
# length (1e-11 of the diameter here), and reported losses have two digits.
exports() {
  local format off
  mkdir -p ism inp re2 foam # each with its own table of names
  for format in ism inp re2; do quadexport -q a.quad.h5 -o "$format/a.$format" --report "$format/a.json"; done
  off=$(awk -v x="$(reported_loss ism/a.json 'inside elements')" 'BEGIN { print 1.1 * x + 2e-11 }')
  run -0 "$compare" --off "$off" ism ism/a.ism a.quad.h5 inp inp/a.inp a.quad.h5
  assert_output ''
  run -0 "$compare" re2 re2/a.re2 a.quad.h5
  assert_output ''
  quadexport -q a.quad.h5 -o foam/blockMeshDict --report foam/a.json
  run -0 "$cells" foam/blockMeshDict a.quad.h5
  assert_output --regexp '^cells [0-9]+ blocks [0-9]+ moved [-0-9.e]+$'
}

@test "low and high orders: elements, names and counts of the stage file, in each of the formats" {
  for shape in half_disc plate_hole s_bend; do
    orders='2 7'
    [[ $shape != half_disc ]] || orders='1 2 3 4 7'
    for order in $orders; do
      quadrefine -q --order $order --geometry-tol 1e-2 "$blocks/$shape.blocks.h5" -o a.quad.h5
      exports
    done
  done
}

@test "order 20" {
  quadrefine -q --order 20 --size 0.5 "$blocks/half_disc.blocks.h5" -o a.quad.h5
  exports
}

@test "wall layers: what readers rebuild from the sides is moved as the warning says" {
  quadrefine -q --wall curve_4:first=1e-3,layers=6 "$blocks/plate_hole.blocks.h5" -o a.quad.h5
  exports
  off=$(reported_loss ism/a.json 'inside elements')
  assert [ "$off" != 0 ]
  run -1 "$compare" --off "$(awk -v x="$off" 'BEGIN { print 0.9 * x }')" ism ism/a.ism a.quad.h5
  assert_output --partial 'is off by'
}

@test "awkward names arrive" {
  echo '{"0": "Wand \"Boden\" <Süd>", "1": "---"}' >names.json
  cad2tri -q --boundary-names names.json "$DATA/half_disc.step" | fieldsolve -q | padapt -q -o a.field.h5
  critpoints -q a.field.h5 | separatrix -q a.field.h5 - | blocksplit -q | quadrefine -q -o a.quad.h5
  run quadexport a.quad.h5 -o a.inp
  assert_output --partial '2 names are written in plain letters: "Wand "Boden" <Süd>" as Wand__Boden___S_d_, "---" as _---'
  run -0 jq -r '.boundaries[] | [.id, .name, .tag] | @tsv' a.inp.names.json
  assert_output $'1\tWand "Boden" <Süd>\tWand__Boden___S_d_\n2\t---\t_---'
  exports
}

@test "what blockMesh moves is what the warning says" {
  quadrefine -q "$blocks/plate_hole.blocks.h5" -o a.quad.h5
  exports
  moved=$(jq -r '[.warnings[].message | capture("inside blocks itself, which moves them by up to (?<x>\\S+)").x][0]' foam/a.json)
  [[ $output == *" moved $moved" ]] || fail "$output, but told: $moved"
}

@test "Nek5000's quadratic sides: the warning has their distance, the field beside it the true ones" {
  quadrefine -q --order 3 "$blocks/half_disc.blocks.h5" -o a.quad.h5
  run quadexport a.quad.h5 -o a.re2
  assert_output --partial "sides are stored as parabolas, which moves them by up to"
  assert_output --partial "; a0.f00000 contains the geometry of order 3"
  assert_nothing_left a.quad.h5 a.re2 a0.f00000 a.re2.names.json
  assert_output --partial "names are stored as numbers, which a.re2.names.json lists"
  run -0 "$compare" re2 a.re2 a.quad.h5
  quadrefine -q --order 1 --geometry-tol 1e-2 "$blocks/half_disc.blocks.h5" -o b.quad.h5
  run quadexport b.quad.h5 -o b.re2
  assert_output "quadexport: warning W-EXP-001: names are stored as numbers, which b.re2.names.json lists"
  assert_nothing_left a.quad.h5 a.re2 a0.f00000 a.re2.names.json b.quad.h5 b.re2 b.re2.names.json
}

@test "the file's name chooses the format" {
  quadrefine -q "$blocks/half_disc.blocks.h5" -o a.quad.h5
  mkdir system
  for file in a.ism:ism-v2 a.inp:inp a.re2:re2 system/blockMeshDict:blockmesh blockMeshDict:blockmesh; do
    quadexport -q a.quad.h5 -o "${file%:*}" --report a.json
    run -0 jq -r .format a.json
    assert_output "${file#*:}"
  done
}

@test "the readers see what is wrong" {
  quadrefine -q --inner-edges curved --relax none --size-rule nearest "$blocks/half_disc.blocks.h5" -o a.quad.h5
  for name in a.ism a.inp a.re2 blockMeshDict; do quadexport -q a.quad.h5 -o $name; done
  # spoilt READER FILE SED: a change that the reader must notice
  spoilt() {
    sed -E "$3" "$2" >"b.$1"
    run ! cmp -s "$2" "b.$1"
    case $1 in
      foam) run -1 "$cells" b.foam a.quad.h5 ;;
      *) run -1 "$compare" --off 2e-11 "$1" "b.$1" a.quad.h5 ;;
    esac
  }
  spoilt ism a.ism '3s/^-1 /-1.001 /'
  spoilt ism a.ism 's/^1 2 1 0 1 0$/2 1 1 0 1 0/'
  spoilt ism a.ism 's/^([0-9]+ [0-9]+ [0-9]+ [1-9][0-9]* [0-9]) ([0-9])$/\1 -\2/'
  spoilt ism a.ism '0,/^1 0 1 0$/ s/^1 0 1 0$/1 0 0 1/'
  spoilt ism a.ism 's/curve_1/curve_0/'
  spoilt inp a.inp 's/^ File created/File created/'
  spoilt inp a.inp 's/^(\*\* )(\S+ )(\S+ )(curve_\S+ \S+)$/\1\4 \2\3/'
  spoilt inp a.inp 's/degree = 4/degree = 5/'
  spoilt foam blockMeshDict 's/\(\(0\.1([0-9]{3})/((0.11\1/'
  spoilt foam blockMeshDict 's/hex \(0 1 2 3 /hex (1 2 3 0 /'
  spoilt foam blockMeshDict 's/ domain / block_1 /'
  spoilt foam blockMeshDict 's/^    curve_0$/    curve_2/'
  cp a0.f00000 b0.f00000
  cp a.re2.names.json b.re2.names.json
  for byte in 20 81 100 500; do
    cp a.re2 b.re2
    printf '\x55' | dd of=b.re2 bs=1 seek=$byte conv=notrunc status=none
    run -1 "$compare" re2 b.re2 a.quad.h5
  done
}

@test "eight shapes, two at each of the orders 1, 2, 5 and 8" {
  [[ -n ${QUADRILLE_LONG-} ]] || skip "long: part of tests/run --all"
  local orders=(1 2 5 8) number=0 shape
  for shape in annulus s_bend tilted_half_disc geometry_4 chamfered_plate_hole stadium geometry_5 quarter_annulus; do
    blocks_of_size "$shape" 12
    quadrefine -q --order "${orders[number % 4]}" --size "$size" --geometry-tol 1e-2 "$shape.blocks.h5" -o a.quad.h5
    exports
    number=$((number + 1))
  done
}
