# Simplification: thin strips of blocks go, laps are cut short, and nothing gets worse that should not.
load ../tools/common

# layouts SHAPE [OPTION...]: none, normal and coarsest.sep.json with reports; the options are those of critpoints.
layouts() {
  cad2tri -q "$DATA/$1.step" -o a.tri.h5
  fieldsolve -q a.tri.h5 | padapt -q -o a.field.h5
  critpoints -q "${@:2}" a.field.h5 -o a.crit.json
  for rule in none normal coarsest; do
    separatrix -q a.field.h5 a.crit.json --simplify "$rule" -o "$rule.sep.json" --report "$rule.json"
    run -0 stagecheck "$rule.sep.json"
    run -0 blocksplit -q "$rule.sep.json" -o "$rule.blocks.h5"
  done
}

blocks() { jq .trace.faces "$1.json"; }

# shape RULE: what its blocks are like, in thousandths.
shape() { jq '.simplify.least_scaled_jacobian * 1000 | floor' "$1.json"; }

@test "the nautilus has 14 blocks at most, and no line turns more than allowed" {
  layouts geometry_2
  assert [ "$(blocks none)" -gt 14 ]
  assert [ "$(blocks normal)" -le 14 ]
  assert [ "$(shape normal)" -ge 500 ]
  assert [ "$(jq '.simplify.largest_deviation_degrees <= 40' normal.json)" = true ]
}

@test "a flange loses its thin strips in threes" {
  layouts flange_3_holes --cluster-distance 0 # the zeros of the field as they are
  assert [ "$(blocks normal)" -le 60 ]
  assert_equal "$(jq '.simplify.collapsed % 3' normal.json)" 0
  assert [ "$(shape normal)" -ge 500 ]
}

@test "small_fillets keeps strips that are worth their blocks, unless the coarsest layout is asked for" {
  layouts small_fillets
  assert_equal "$(blocks normal)" "$(blocks none)"
  assert [ "$(blocks coarsest)" -lt "$(blocks normal)" ]
  assert [ "$(shape coarsest)" -ge 300 ]
}

@test "without any turn nothing goes that is not straight" {
  layouts chamfered_plate_hole --ties field
  separatrix -q a.field.h5 a.crit.json --max-deviation 0 -o still.sep.json --report still.json
  assert_equal "$(blocks still)" "$(blocks none)"
  assert [ "$(blocks normal)" -lt "$(blocks none)" ]
}
