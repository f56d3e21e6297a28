# The Python modules of pipelines/lib: their unit tests, tests/unit/pipelines/MODULE_test.py for MODULE.
load common

# passes MODULE...: the tests of these modules pass, and there are some.
passes() {
  for module in "$@"; do
    PYTHONPATH=$ROOT/pipelines/lib run -0 /usr/bin/python3 -B -m unittest discover -s "$ROOT/tests/unit/pipelines" \
      -p "${module}_test.py"
    assert_line --regexp '^Ran [1-9][0-9]* tests? in '
  done
}

@test "the frame of the Python commands" {
  passes command_frame nearest_word
}

@test "outlines: reading points, loops, corners" {
  passes point_files point_rows forms aerofoils polygons box_tree loops corners simplify
}

@test "outlines: splines, edges, STEP files, and all together" {
  passes splines near_spline smoothing fit edges near_polygon fine_loops wake wake_ends step_file build
}

@test "drawings: readers, curves, joints, regions" {
  passes dxf_file svg_file svg_path drawing_files curves pieces sketch joining regions step_edges drawing_build
}

@test "search for node positions" {
  passes boundary symmetries layouts goals compass_search
}

@test "many shapes: jobs, results, tables" {
  passes mesh_shape shape_results result_table
}

@test "workbench: states, stages, files, processes, server" {
  passes state work_folder saved_files processes workbench page_server
}

@test "every module has a test, and the tests of all modules are run above" {
  for file in "$ROOT"/pipelines/lib/*.py "$ROOT"/pipelines/lib/*/[a-z]*.py; do
    module=$(basename "$file" .py)
    assert_file_exists "$ROOT/tests/unit/pipelines/${module}_test.py"
    grep -q "^  passes .*\b$module\b" "$BATS_TEST_FILENAME" || fail "$module is not run"
  done
}
