# The pages of the project against each other and against the sources (tests/pages.py has the checks).
load tools/common

check() {
  run python3 "$ROOT/tests/pages.py" "$ROOT" "$@"
  assert_output ''
  assert_success
}

@test "every link between pages leads to a file, and to a heading where it names one" {
  check links
}

@test "every page, section, test and source that pages and comments cite exists" {
  check citations
}

@test "every folder of lib has a short page that names what comes in, what goes out and a header to start with" {
  check folders
}

@test "formats/README.md lists every schema" {
  check schemas
}

@test "formats/report.md lists exactly the warnings that sources issue" {
  check warnings
}
