# The notebook of the tutorial, executed by Jupyter's nbconvert.
load common

@test "nbconvert executes the notebook, whose meshes draw themselves" {
  need jupyter-nbconvert python3-ipykernel python3-h5py python3-dolfinx python3-gmsh openfoam
  cp -r "$ROOT/pipelines/examples" work && cp "$ROOT/pipelines/python/examples/tutorial.ipynb" work && cd work
  export HOME=$PWD/home XDG_CACHE_HOME=$PWD/cache QUADRILLE_BIN=$BIN PYTHONPATH=$ROOT/pipelines/python
  mkdir home
  run -0 "$PYTHON" -m nbconvert --to notebook --execute tutorial.ipynb --output executed.ipynb
  assert_equal "$(jq '[.cells[].outputs[]? | select(.data["image/svg+xml"])] | length' executed.ipynb)" 3
  jq -r '.cells[].outputs[]? | .text // .data["text/plain"] | join("")' executed.ipynb >text
  grep -qE '^drag 5\.5[67][0-9], lift 0\.01[01][0-9]$' text
  grep -qE ' relative error [1-9]\.[0-9]e-0[89]$' text
}
