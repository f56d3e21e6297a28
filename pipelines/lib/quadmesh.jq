# What quadmesh reports of a run, from the reports of its stages (files NUMBER.STAGE.json, the inputs of jq).

# report($start; $nodes; $remedy; $version): the report of the whole run, begun $start seconds after 1970; $nodes is the file
# x.crit.json, $remedy the options of try_remedies.sh. Runs of stages failed_* have only their times in it, and the
# warning of quadmesh that one of them was stopped.
def report($start; $nodes; $remedy; $version):
  [inputs | select(.tool?) | . + {stage: (input_filename | split(".")[-2])}] as $all |
  ($all | map(select(.stage | startswith("failed_") | not))) as $runs | ($runs | map({(.tool): .}) | add) as $of |
  { tool: "quadmesh", version: ($runs[0].version // $version),
    form: (if $nodes then $nodes.form // "harmonic" else null end),
    critical_points: ($nodes.critical_points | length),
    irregular_nodes: $of.quadrefine.irregular_nodes,
    blocks: $of.quadrefine.blocks,
    certificate: $of.separatrix.certificate,
    given_up: (if ($runs[-1].exit_code // 0) != 0 then null else [$runs[] | select((.exit_code // 0) != 0) | "\(.tool): \(.error)"] | first end),
    remedy: (if $remedy == "" then null else $remedy end),
    estimated_quads: $of.quadrefine.estimated_quads,
    quads: ($of.quadrefine.quads // $of.quadexport.quads),
    least_jacobian_bound: $of.quadrefine.least_jacobian_bound,
    valid: $of.quadrefine.valid,
    least_scaled_jacobian: $of.quadrefine.least_scaled_jacobian,
    greatest_edge_ratio: $of.quadrefine.greatest_edge_ratio,
    greatest_area_jump: $of.quadrefine.greatest_area_jump,
    least_node_distance: $of.quadrefine.least_node_distance,
    walls: $of.quadrefine.walls,
    growth: $of.quadrefine.growth,
    boundary: $of.quadrefine.boundary,
    unit: $of.quadexport.unit,
    scale: $of.quadexport.scale,
    cpu_seconds: ($all | map(.timings.total.cpu_seconds) | add // 0),
    wall_seconds: (now - $start),
    stages: (reduce ($all[] | select(.timings)) as $run ({}; .[$run.stage] as $before |
      .[$run.stage] = (($run.timings.total // {}) | with_entries(.value += ($before[.key] // 0))))),
    warnings: [$all[] | select((.stage | startswith("failed_") | not) or .warnings[0].tool == "quadmesh") |
      {tool} + .warnings[]?] };

def count(n; noun): "\(n) \(noun)" + (if n == 1 then "" else "s" end);
def places(n): . * pow(10; n) | round / pow(10; n) | tostring;

# A line for each stage with its time and its share.
def times:
  .cpu_seconds as $all |
  (.stages | to_entries[] | "\(.key + "                " | .[:16]) \(.value.cpu_seconds | places(3)) s CPU, " +
    "\(.value.cpu_seconds / $all * 100 | round) %"),
  "all stages       \($all | places(3)) s CPU, \(.wall_seconds | places(3)) s";

# The line about the mesh; after --until, about the last file of the stages. $last is a name.
def summary($until; $last):
  if $until != "" and $until != "quadexport" then "stages up to \($until): \($last)"
  elif .blocks == null then count(.quads; "quad")
  else
    "\(count(.blocks; "block")), \(count(.irregular_nodes; "irregular node")), \(count(.quads; "quad")), " +
      "worst scaled Jacobian \(.least_scaled_jacobian | places(2)), greatest edge ratio " +
      "\(.greatest_edge_ratio.value | places(1))" +
      (if .certificate.method == "midpoint" then ", by midpoint division of triangles" else "" end) +
      (if .scale == 1 or .scale == null then "" else
        ", coordinates in \(if .unit == "unknown" then "an unknown unit" else .unit end), " +
        "\(.scale) times those of the CAD file" end)
  end;
