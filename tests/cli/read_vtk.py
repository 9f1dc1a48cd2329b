"""Reads the samples that the unit tests of the writers leave (tests/unit/output/vtk_test.cpp) with VTK's own readers.

usage: read_vtk.py FOLDER        exit status 77: no VTK here, skipped
"""
import math
import os
import sys
import xml.etree.ElementTree as xml

try:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLPolyDataReader
    import numpy as np
except ImportError as error:
    print(f"skipped: {error} (package python3-vtk9)")
    sys.exit(77)


def read(reader, path):
    errors = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append(path))
    reader.SetFileName(path)
    assert reader.CanReadFile(path), path
    reader.Update()
    assert not errors, errors
    return reader.GetOutput()


def array(data, name):
    values = data.GetArray(name)
    assert values is not None, name
    return vtk_to_numpy(values)


def check_image(folder, dim, single, appended=False):
    name = "appended" if appended else "fields"
    image = read(vtkXMLImageDataReader(), os.path.join(folder, f"{name}_{'float_' if single else ''}{dim}d.vti"))
    cells = [9, 10, 11][:dim]
    count = math.prod(cells)
    assert image.GetNumberOfCells() == count
    assert list(image.GetDimensions()) == [n + 1 for n in cells] + [1] * (3 - dim)
    assert image.GetSpacing() == (0.25, 0.25, 0.25)
    assert list(image.GetOrigin()) == [-0.5, 0.5, 1.5][:dim] + [0.0] * (3 - dim)

    key = np.arange(count)
    kind = np.float32 if single else np.float64
    pressure, velocity = array(image.GetCellData(), "pressure"), array(image.GetCellData(), "velocity")
    assert pressure.dtype == kind and velocity.dtype == kind
    assert np.allclose(pressure, np.sin(key), rtol=0, atol=1e-7 if single else 1e-15)
    expected = np.array([(a + 1) / 3 + key if a < dim else 0 * key for a in range(3)]).T
    assert np.array_equal(velocity, expected.astype(kind))
    assert image.GetCellData().GetScalars().GetName() == "pressure"
    assert image.GetCellData().GetVectors().GetName() == "velocity"

    time = image.GetFieldData().GetArray("TimeValue")
    assert time is None if single and not appended else time.GetTuple1(0) == 0.125


def cell_points(surface):
    result = []
    for i in range(surface.GetNumberOfCells()):
        cell = surface.GetCell(i)  # valid until the next call only
        result.append([cell.GetPointId(j) for j in range(cell.GetNumberOfPoints())])
    return result


def check_surface_2d(folder, name="film_2d.vtp"):
    surface = read(vtkXMLPolyDataReader(), os.path.join(folder, name))
    points = vtk_to_numpy(surface.GetPoints().GetData())
    assert np.array_equal(points, [[0.1, 0, 0], [1, 0.2, 0], [0.5, 1 / 3, 0]])
    assert surface.GetNumberOfLines() == 3 and surface.GetNumberOfPolys() == 0
    assert cell_points(surface) == [[0, 1], [1, 2], [2, 0]]
    assert np.array_equal(array(surface.GetPointData(), "thickness"), [1e-7, 0.25, -3])
    assert np.array_equal(array(surface.GetCellData(), "velocity"), [[1, 2, 0], [3, 4, 0], [5, 6, 0]])
    assert surface.GetFieldData().GetArray("TimeValue").GetTuple1(0) == 0.125


def check_surface_3d(folder, name="film_3d.vtp"):
    surface = read(vtkXMLPolyDataReader(), os.path.join(folder, name))
    points = vtk_to_numpy(surface.GetPoints().GetData())
    assert np.array_equal(points, [[0, 0, 0], [1, 0, 0.1], [0, 1, 0], [0, 0, 1 / 3]])
    assert surface.GetNumberOfLines() == 0 and surface.GetNumberOfPolys() == 2
    assert cell_points(surface) == [[0, 2, 1], [0, 1, 3]]
    assert np.array_equal(array(surface.GetPointData(), "thickness"), [1e-7, 0.25, -3, 1e30])
    assert np.array_equal(array(surface.GetPointData(), "normal"), [[0, 0, 1], [0, 1, 0], [1, 0, 0], [0, 0, -1]])
    assert np.array_equal(array(surface.GetCellData(), "pressure <full>"), [-1.5, 1 / 3])


def check_empty(folder, dim):
    surface = read(vtkXMLPolyDataReader(), os.path.join(folder, f"empty_{dim}d.vtp"))
    assert surface.GetNumberOfPoints() == 0 and surface.GetNumberOfCells() == 0


def check_collection(folder):
    root = xml.parse(os.path.join(folder, "gapflow.pvd")).getroot()
    assert root.get("type") == "Collection"
    entries = [entry.attrib for entry in root.find("Collection")]
    assert [e["name"] for e in entries] == ["fields 2d", "film 2d", "fields 3d", "film 3d"]
    assert [e["part"] for e in entries] == ["0", "1", "2", "3"]
    for entry in entries:
        assert float(entry["timestep"]) == 0.125
        assert os.path.isfile(os.path.join(folder, entry["file"])), entry["file"]


def main(folder):
    for dim in (2, 3):
        check_image(folder, dim, single=False)
        check_image(folder, dim, single=True)
        check_image(folder, dim, single=False, appended=True)
        check_image(folder, dim, single=True, appended=True)
        check_empty(folder, dim)
    check_surface_2d(folder)
    check_surface_3d(folder)
    check_surface_2d(folder, "appended_film_2d.vtp")
    check_surface_3d(folder, "appended_film_3d.vtp")
    check_collection(folder)
    print("all samples read back as written")


if __name__ == "__main__":
    main(sys.argv[1])
