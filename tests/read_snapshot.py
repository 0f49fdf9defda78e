"""Opens a snapshot with h5py and with VTK's own reader and compares every number: read_snapshot.py FILE"""

import sys

import h5py
import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy


def main(path):
    reader = vtk.vtkHDFReader()
    assert reader.CanReadFile(path), "VTK refuses the file"
    reader.SetFileName(path)
    reader.Update()
    poly = vtk.vtkPolyData.SafeDownCast(reader.GetOutputDataObject(0))
    assert poly is not None, "VTK does not see PolyData"

    with h5py.File(path) as file:
        root = file["VTKHDF"]
        points = root["Points"][:]
        assert len(points) > 0
        np.testing.assert_array_equal(vtk_to_numpy(poly.GetPoints().GetData()), points)
        cells = poly.GetVerts()
        assert poly.GetNumberOfVerts() == poly.GetNumberOfCells() == len(points)
        np.testing.assert_array_equal(vtk_to_numpy(cells.GetConnectivityArray()), np.arange(len(points)))

        fields = root["PointData"]
        data = poly.GetPointData()
        assert data.GetNumberOfArrays() == len(fields)
        for name, field in fields.items():
            assert field.attrs["unit"] is not None and field.attrs["description"], name
            np.testing.assert_array_equal(vtk_to_numpy(data.GetArray(name)), field[:], err_msg=name)
        if "deviatoric_stress" in fields:
            stress = fields["deviatoric_stress"][:]
            np.testing.assert_allclose(stress[:, :3].sum(axis=1), 0, atol=1e-6 * np.abs(stress).max())

        run = file["run"].attrs
        assert run["time"] >= 0 and run["step"] >= 0 and run["version"] and run["scene"]
        print(f"{path}: {len(points)} particles, {len(fields)} fields: {', '.join(fields)}")
        print(f"time {run['time']} s, step {run['step']}, conservation {dict(file['conservation'].attrs)}")


main(sys.argv[1])
