"""Snapshots that no run of ours wrote: every entry of HOSTILE spoils a good one in its own way."""

import random
import shutil

import h5py
import numpy as np

POINTS, FAILED = "VTKHDF/Points", "VTKHDF/PointData/failed"
METADATA = 4000  # bytes at the start of a snapshot that describe more than they hold
SECRET = b"what nobody may read" * 500


def put(name, **options):
    """A dataset in place of the one called `name`."""
    def spoil(path):
        with h5py.File(path, "r+") as file:
            del file[name]
            file.create_dataset(name, **options)
    return spoil


def put_changed(name, change):
    """Other numbers in place of those called `name`."""
    def spoil(path):
        with h5py.File(path, "r+") as file:
            values = change(file[name][()])
            del file[name]
            file[name] = values
    return spoil


def store(name, **options):
    """The same numbers, stored in another way."""
    def spoil(path):
        with h5py.File(path, "r+") as file:
            values = file[name][()]
            del file[name]
            file.create_dataset(name, data=values, **options)
    return spoil


def link(name, target):
    def spoil(path):
        with h5py.File(path, "r+") as file:
            file.move(name, "elsewhere")
            file[name] = target
    return spoil


def link_out(name):
    """A link to a whole and right snapshot in another file."""
    def spoil(path):
        other = path.with_name("other.h5")
        shutil.copy(path, other)
        with h5py.File(path, "r+") as file:
            del file[name]
            file[name] = h5py.ExternalLink(other.name, name)
    return spoil


def store_outside(path):
    secret = path.with_name("secret")
    secret.write_bytes(SECRET)
    with h5py.File(path, "r+") as file:
        shape = file[POINTS].shape
        del file[POINTS]
        file.create_dataset(POINTS, shape, "f8",
                            external=[(str(secret), 0, h5py.h5f.UNLIMITED)])


def make_virtual(path):
    other = path.with_name("other.h5")
    shutil.copy(path, other)
    with h5py.File(path, "r+") as file:
        shape = file[POINTS].shape
        del file[POINTS]
        layout = h5py.VirtualLayout(shape, "f8")
        layout[...] = h5py.VirtualSource(other, POINTS, shape=shape)
        file.create_virtual_dataset(POINTS, layout)


def remove(name):
    def spoil(path):
        with h5py.File(path, "r+") as file:
            del file[name]
    return spoil


def group_for(name):
    def spoil(path):
        with h5py.File(path, "r+") as file:
            del file[name]
            file.create_group(name)
    return spoil


def never_written(path):
    with h5py.File(path, "r+") as file:
        shape = file[POINTS].shape
        del file[POINTS]
        file.create_dataset(POINTS, shape, "f8")


def cut(share):
    def spoil(path):
        whole = path.read_bytes()
        path.write_bytes(whole[:int(share * len(whole))])
    return spoil


HOSTILE = {
    "rank 1": put_changed(POINTS, np.ravel),
    "rank 3": put_changed(POINTS, lambda values: values[:, :, None]),
    "scalar": put(POINTS, data=1.0),
    "null": put(POINTS, data=h5py.Empty("f8")),
    "no rows": put(POINTS, shape=(0, 3), dtype="f8"),
    "row too few": put_changed(FAILED, lambda values: values[1:]),
    "row too many": put_changed(FAILED, lambda values: np.append(values, 0)),
    "two columns": put_changed(POINTS, lambda values: values[:, :2]),
    "texts": put_changed(POINTS, lambda values: values.astype("S20")),
    "texts of any length": put(FAILED, shape=(10,), dtype=h5py.string_dtype()),
    "lists": put(FAILED, shape=(10,), dtype=h5py.vlen_dtype("i4")),
    "references": put(FAILED, shape=(10,), dtype=h5py.ref_dtype),
    "compound": put_changed(POINTS, lambda values: values.astype([("x", "f8"), ("y", "f8")])),
    "complex numbers": put_changed(POINTS, lambda values: values.astype(complex)),
    "opaque": put_changed(POINTS, lambda values: values.astype("V8")),
    "more than memory": put(POINTS, shape=(1 << 50, 3), dtype="f8", chunks=(1024, 3)),
    "more than the file": put(POINTS, shape=(1 << 50, 3), dtype="f8"),
    "never written": never_written,
    "compressed": store(POINTS, compression="gzip"),
    "in chunks": store(POINTS, chunks=(8, 3)),
    "in another file": store_outside,
    "virtual": make_virtual,
    "link to another file": link_out(POINTS),
    "group in another file": link_out("VTKHDF"),
    "link": link(POINTS, h5py.SoftLink("/elsewhere")),
    "link to nothing": link(POINTS, h5py.SoftLink("/nothing")),
    "link to itself": link(POINTS, h5py.SoftLink("/VTKHDF/Points")),
    "group through a link": link("VTKHDF", h5py.SoftLink("/elsewhere")),
    "group for numbers": group_for(POINTS),
    "numbers for a group": put("VTKHDF/PointData", data=[1.0]),
    "nothing for numbers": remove(POINTS),
    "nothing at all": remove("VTKHDF"),
    "empty file": cut(0.0),
    "first tenth": cut(0.1),
    "first half": cut(0.5),
    "all but the end": cut(0.99),
    "noise": lambda path: path.write_bytes(random.Random(1).randbytes(5000)),
}


class HostileSnapshots:
    """For a TestCase: what somebody might do to the good snapshot whose path is self.snapshot."""

    def for_each_hostile(self, check):
        """check() with the snapshot spoiled in every way."""
        whole = self.snapshot.read_bytes()
        for name, spoil in HOSTILE.items():
            with self.subTest(name=name):
                self.snapshot.write_bytes(whole)
                spoil(self.snapshot)
                check()

    def for_each_turned_bit(self, count, check):
        """check() with the snapshot whole but for one bit, `count` times."""
        whole = self.snapshot.read_bytes()
        generator = random.Random(6)
        for _ in range(count):
            place, bit = generator.randrange(min(METADATA, len(whole))), generator.randrange(8)
            with self.subTest(place=place, bit=bit):
                self.snapshot.write_bytes(
                    whole[:place] + bytes([whole[place] ^ 1 << bit]) + whole[place + 1:])
                check()
