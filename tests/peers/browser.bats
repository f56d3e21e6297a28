# Chromium opens pages of stageview: no message on the console, keys and pointer do what the page says.
load common

setup() {
  common_setup
  need chromium chromium-driver python3-selenium
}

# judge PAGE TABS
judge() {
  run "$PYTHON" "$ROOT/tests/peers/judge_page.py" "$1" "$2"
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
    judge page.html 6
  done
}

@test "a page of 100,000 quads of order 5 has at most 30 MB and works" {
  quadrefine -q --size 0.0039 --order 5 "$(blocks_of "$DATA/half_disc.step")" -o fine.quad.h5 --report report.json
  assert [ "$(jq .quads report.json)" -gt 100000 ]
  stageview fine.quad.h5 -o page.html
  assert [ "$(stat -c %s page.html)" -lt 30000000 ]
  judge page.html 1
}
