# What the manual (pipelines/manual.md) shows works as it stands there.
load ../tools/common

page=$ROOT/pipelines/manual.md

@test "the commands that run a part of the chain work" {
  cp "$DATA/half_disc.step" d.step
  sed -n '/^## Part of the chain/,/^## /p' "$page" | sed -nE 's/^    (.*)/\1/p' >commands
  assert [ "$(wc -l <commands)" -ge 7 ]
  PATH=$ROOT/pipelines:$PATH run -0 bash -euo pipefail commands
  assert_line --partial 'critpoints'
  run -0 stagecheck stages/d.quad.h5
}

@test "the commands that choose irregular nodes work" {
  cad2tri "$DATA/half_disc.step" -o d.tri.h5
  fieldsolve d.tri.h5 | padapt -o d.field.h5
  sed -n '/^## Irregular nodes/,/^## /p' "$page" | sed -nE 's/^    (.*)/\1/p' >commands
  assert [ "$(wc -l <commands)" -ge 5 ]
  run -0 bash -euo pipefail commands
  assert_output ''
  run -0 stagecheck d.phase.h5 d.blocks.h5
}

@test "the commands that name things and begin with points work" {
  ln -s "$ROOT/pipelines" .
  cp "$DATA/half_disc.step" .
  { echo section; awk 'BEGIN { for (k = 0; k <= 40; ++k) { a = k * atan2(0, -1) / 20
    printf "%.9f %.9f\n", (1 + cos(a)) / 2, sin(a) * sin(a / 2) / 8 } }'; } >aerofoil.dat
  printf '%s\n' '0 0' '4 0' '4 2' '3 2.04' '2 2' '1 2.04' '0 2' >coast.xy
  "$ROOT/tests/cases/halves.py" aerofoil_c && sed -i "s/'symmetry'/'axis'/" half.step
  for section in Names "From points"; do
    sed -n "/^## $section/,/^## /p" "$page" | sed -nE 's/^    (.*)/\1/p' >commands
    assert [ "$(wc -l <commands)" -ge 2 ]
    run -0 bash -euo pipefail commands
  done
  assert_equal "$(sed -nE 's/^[12] [0-9]+ (".*")$/\1/p' half_disc.msh | tr -d '\n')" '"symmetry""wall""fluid"'
  assert_equal "$(sed -nE 's/^[12] [0-9]+ (".*")$/\1/p' aerofoil.msh | tr -d '\n')" '"farfield""lower""upper""fluid"'
}

@test "the commands that begin with drawings work" {
  ln -s "$ROOT/pipelines" .
  cp "$ROOT/pipelines/examples/plate.dxf" .
  sed -n '/^## From drawings/,/^## /p' "$page" | sed -nE 's/^    (.*)/\1/p' >commands
  assert [ "$(wc -l <commands)" -eq 4 ]
  run -0 bash -euo pipefail commands
  local file
  for file in plate:'1bolts 1bore 1plate 2domain' weld:'1bolts 1bore 1plate 1weld 2domain' \
    filled:'1bolts 1bore 1plate 2bolts 2bore 2plate'; do
    assert_equal "$(sed -nE 's/^([12]) [0-9]+ "(.*)"$/\1\2/p' "${file%%:*}.msh" | sort | xargs)" "${file#*:}"
  done
}

@test "the commands for sizes and wall layers work" {
  echo '{"curve_4": "hole", "curve_3": "inlet"}' >names.json
  "$ROOT/pipelines/quadmesh" -q "$DATA/plate_hole.step" --boundary-names names.json --workdir . -o x.msh
  mv plate_hole.blocks.h5 x.blocks.h5
  sed -n '/^## Sizes and wall layers/,/^## /p' "$page" | sed -nE 's/^    (.*)/\1/p' >commands
  assert [ "$(wc -l <commands)" -eq 5 ]
  run -0 bash -euo pipefail commands
  assert_equal "$(grep -v W-QUA-005 <<<"$output")" ''
  run -0 stagecheck x.quad.h5
}

@test "the sections whose commands are run above are all that have commands" {
  run -0 awk '/^## / { heading = substr($0, 4) } /^    [^ ]/ && !seen[heading]++ { print heading }' "$page"
  assert_output "$(printf '%s\n' 'Part of the chain' 'From points' 'From drawings' Names 'Irregular nodes where you want them' 'Sizes and wall layers')"
}
