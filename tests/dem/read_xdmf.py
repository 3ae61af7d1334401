"""Arrays of particles as VTK's two XDMF readers see them, as JSON: read_xdmf.py FILE ARRAY

For a Python whose VTK has these readers, which Debian's python3-vtk9 has not; ParaView's pvpython has. Exit code 77 without.
"""
import json
import os
import sys

try:
    from vtkmodules.vtkIOXdmf2 import vtkXdmfReader
    from vtkmodules.vtkIOXdmf3 import vtkXdmf3Reader
except ImportError:
    sys.exit(77)


def leaves(data):
    """The data sets of a tree of blocks."""
    if not data.IsA("vtkMultiBlockDataSet"):
        return [data]
    return [leaf for n in range(data.GetNumberOfBlocks()) if data.GetBlock(n) for leaf in leaves(data.GetBlock(n))]


def last(reader, path, name):
    """Values of the point array of this name at the file's last time, a row for each point."""
    reader.SetFileName(os.path.abspath(path))
    reader.UpdateInformation()
    reader.UpdateTimeStep(reader.GetOutputInformation(0).Get(reader.GetExecutive().TIME_STEPS())[-1])
    arrays = [leaf.GetPointData().GetArray(name) for leaf in leaves(reader.GetOutputDataObject(0))]
    array = next(filter(None, arrays))
    return [list(array.GetTuple(n)) for n in range(array.GetNumberOfTuples())]


print(json.dumps({reader.__name__: last(reader(), *sys.argv[1:3]) for reader in (vtkXdmfReader, vtkXdmf3Reader)}))
