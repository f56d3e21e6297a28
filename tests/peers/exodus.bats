# The netCDF library and VTK read our Exodus files.
load common

setup() {
  common_setup
}

@test "the NetCDF library reads what is on the page of Exodus" {
  need netcdf-bin
  quadrefine -q --order 2 "$(blocks_of "$DATA/half_disc.step")" | quadexport -q -o a.exo
  run -0 ncdump -v ss_names,eb_names a.exo
  assert_output --partial '"curve_0"'
  assert_output --partial '"domain"'
  assert_output --partial 'connect1:elem_type = "QUAD9"'
}

@test "VTK reads Exodus: cells, points and area" {
  need python3-vtk9
  local kind
  for kind in "1 exodus 4" "2 exodus 9" "2 exodus-serendipity 8"; do
    # shellcheck disable=SC2086
    set -- $kind
    quadrefine -q --order "$1" --size 0.1 --geometry-tol 1 "$(blocks_of "$DATA/half_disc.step")" -o a.quad.h5
    quadexport -q --format "$2" a.quad.h5 -o a.exo --report a.json
    run -0 "$PYTHON" - a.exo "$(jq .quads a.json)" "$3" <<'END'
import sys
import vtk
reader = vtk.vtkExodusIIReader()
reader.SetFileName(sys.argv[1])
reader.UpdateInformation()
assert [reader.GetSideSetArrayName(k) for k in range(reader.GetNumberOfSideSetArrays())] == ["curve_0", "curve_1"]
reader.Update()
block = reader.GetOutput().GetBlock(0).GetBlock(0)
assert block.GetNumberOfCells() == int(sys.argv[2]) and block.GetCell(0).GetNumberOfPoints() == int(sys.argv[3])
sizes = vtk.vtkCellSizeFilter()
sizes.SetInputData(block)
sizes.Update()
areas = sizes.GetOutput().GetCellData().GetArray("Area")
area = sum(areas.GetValue(k) for k in range(block.GetNumberOfCells()))
assert abs(area - 3.14159265 / 2) < 0.01, area
END
  done
}

@test "VTK reads hexahedra: positive Jacobians, the volume of the stage file, names and counts of side sets" {
  need python3-vtk9
  local order shape
  for shape in half_disc plate_hole; do
    for order in 1 2; do
      quadrefine -q --order $order --geometry-tol 1 "$(blocks_of "$DATA/$shape.step")" -o a.quad.h5
      hexsweep -q a.quad.h5 --height 1 --twist 40 --layers 3 -o a.hex.h5
      for format in exodus exodus-serendipity; do
        quadexport -q --format $format a.hex.h5 -o a.exo
        run -0 "$PYTHON" "$ROOT/tests/peers/judge_vtk_reader_hex.py" a.hex.h5 a.exo
      done
    done
  done
}

@test "python3-netcdf4 reads names, nodes and elements of hexahedra" {
  need python3-netcdf4
  echo '{"1": "a name of more than thirty-two letters"}' >names.json
  cad2tri -q --boundary-names names.json "$DATA/half_disc.step" | fieldsolve -q | padapt -q -o a.field.h5
  critpoints -q a.field.h5 | separatrix -q a.field.h5 - | blocksplit -q | quadrefine -q --order 2 -o a.quad.h5
  hexsweep -q a.quad.h5 --height 1 --layers 2 | quadexport -q -o a.exo
  run -0 "$PYTHON" - a.exo <<'END'
import sys
import netCDF4
file = netCDF4.Dataset(sys.argv[1])
assert file.data_model == "NETCDF3_64BIT_OFFSET" and file.dimensions["time_step"].isunlimited()
names = [str(row) for row in netCDF4.chartostring(file["ss_names"][:])]
assert names == ["curve_0", "a_name_of_more_than_thirty-two_l", "bottom", "top"], names
assert file["connect1"].elem_type == "HEX27" and file["connect1"].shape[1] == 27
assert file["connect1"][:].min() == 1 and file["connect1"][:].max() == file.dimensions["num_nodes"].size
assert sum(len(file.dimensions[f"num_side_ss{k}"]) for k in (3, 4)) == file.dimensions["num_elem"].size
END
}
