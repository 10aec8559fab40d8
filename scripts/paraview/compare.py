"""Compares what ParaView's XDMF readers show of results.xdmf with results.h5: names of components, and values.

    python3 scripts/paraview/compare.py RESULTS_DIR...        exit status 1 if anything differs
"""
import sys

import h5py
import numpy as np
from paraview import servermanager, simple
from vtkmodules.numpy_interface import dataset_adapter

READERS = ("XDMFReader", "Xdmf3ReaderS", "Xdmf3ReaderT")
VECTOR = ["X", "Y", "Z"]
TENSOR = [a + b for a in VECTOR for b in VECTOR]
NUMBERS = [str(c) for c in range(9)]  # what the readers call nine columns: 0 to 8, in the order of the file


def reader_of(kind, path):
    make = getattr(simple, kind)
    return make(FileNames=[path]) if kind == "XDMFReader" else make(FileName=[path])


def points_of(reader, time):
    """The points of one step: the only leaf of what a reader gives."""
    reader.UpdatePipeline(time)
    data = servermanager.Fetch(reader)
    while data.IsA("vtkCompositeDataSet"):
        leaves = data.NewIterator()
        leaves.InitTraversal()
        data = leaves.GetCurrentDataObject()
    return data


def components_of(file, step, said):
    """The columns of every tensor of a step under the names that the readers have to show."""
    named = {}
    plane = file.attrs["dimension"] == 2
    for name, dataset in file["steps"][str(step)].items():
        if dataset.ndim != 2 or dataset.shape[1] != 9:
            continue
        for i, a in enumerate("xyz"):
            for j, b in enumerate("xyz"):
                if j < i or (plane and i != j and b == "z"):
                    continue
                named[f"{name}_{a}{b}"] = dataset[:, 3 * i + j]
    views = set(file["components"][str(step)]) if named else set()
    if views != set(named):
        said.append(f"step {step}: results.h5 has the components {sorted(views)}, not {sorted(named)}")
    return named


def compare_step(kind, data, reader, file, step, said):
    places = dataset_adapter.WrapDataObject(data)
    if not np.array_equal(np.asarray(places.Points), file["particles/reference"][:]):
        said.append(f"{kind}, step {step}: the points stand elsewhere")
    fields = dict(file["steps"][str(step)].items())
    fields.update({name: file["particles"][name] for name in ("volume", "block")})
    fields.update(components_of(file, step, said))
    for name, dataset in fields.items():
        wanted = dataset[:]
        array = data.GetPointData().GetArray(name)
        if array is None:
            said.append(f"{kind}, step {step}: no field {name}")
            continue
        shown = np.asarray(places.PointData[name]).reshape(wanted.shape)
        if not np.array_equal(shown, wanted):
            difference = np.abs(shown - wanted).max()
            said.append(f"{kind}, step {step}: {name} differs by up to {difference:g}")
        count = 1 if wanted.ndim == 1 else wanted.shape[1]
        information = reader.PointData[name]
        names = [information.GetComponentName(c) for c in range(count)]
        expected = {1: [], 3: [VECTOR], 9: [TENSOR, NUMBERS]}[count]
        if expected and names not in expected:
            said.append(f"{kind}, step {step}: {name} has the components {names}, not {expected[0]}")
    return len(fields)


def compare(directory):
    said, fields = [], 0
    with h5py.File(directory + "/results.h5") as file:
        steps = sorted(int(k) for k in file["steps"])
        for kind in READERS:
            reader = reader_of(kind, directory + "/results.xdmf")
            reader.UpdatePipelineInformation()
            times = list(reader.TimestepValues)
            if times != [float(file["steps"][str(k)].attrs["t"]) for k in steps]:
                said.append(f"{kind}: the times are {times}")
            for step, time in zip(steps, times):
                count = compare_step(kind, points_of(reader, time), reader, file, step, said)
                fields += count
            simple.Delete(reader)
    return said, fields


def main():
    wrong = 0
    for directory in sys.argv[1:]:
        said, fields = compare(directory)
        for sentence in said:
            print(f"{directory}: {sentence}")
        print(f"{directory}: {fields} fields compared through {len(READERS)} readers, {len(said)} differences")
        wrong += len(said)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
