"""Compares two checkpoints byte for byte, particle by particle: columns.py FIRST SECOND. Prints how much it compared."""

import sys

import h5py
import numpy


def columns(path):
    """Columns by name, in the order of the global ids; `/columns` holds one dataset per column."""
    with h5py.File(path) as f:
        found = {name: data[()] for name, data in f["columns"].items()}
    ids = found["id"].reshape(-1)
    assert len(numpy.unique(ids)) == len(ids), f"{path}: an id stands twice"
    order = numpy.argsort(ids)
    return {name: data.reshape(len(ids), -1)[order] for name, data in found.items()}


first, second = columns(sys.argv[1]), columns(sys.argv[2])
assert first.keys() == second.keys(), f"columns differ: {sorted(first.keys() ^ second.keys())}"
for name in first:
    a, b = first[name], second[name]
    if a.dtype != b.dtype or a.tobytes() != b.tobytes():
        where = numpy.argwhere(a.view(numpy.uint64) != b.view(numpy.uint64))
        sys.exit(f"{name}: {len(where)} values differ, first of particle {first['id'][where[0][0]]}")
print(len(first["id"]), "particles", len(first), "columns")
