"""Arrays from an untrusted zip."""

import io
import zipfile

import numpy as np
import pytest
from numpy.lib.format import write_array_header_1_0

from semref.core.onboard.arrays import UNREADABLE, number_arrays


def npy(shape, kind="|u1", data=b"x"):
    file = io.BytesIO()
    write_array_header_1_0(file, {"descr": kind, "fortran_order": False, "shape": shape})
    return file.getvalue() + data


def test_numbers_come_back_as_they_were(tmp_path):
    arrays = {
        "rows": np.arange(6.0).reshape(2, 3),
        "columns": np.asfortranarray(np.arange(6).reshape(2, 3)),
        "none": np.zeros((0, 4)),
        "one": np.array(3.5),
        "told": np.array([True, False]),
    }
    np.savez(tmp_path / "a.npz", **arrays)
    found = number_arrays(str(tmp_path / "a.npz"), 10_000)
    assert found.keys() == arrays.keys()
    for name, array in arrays.items():
        assert found[name].dtype == array.dtype and np.array_equal(found[name], array)
    with pytest.raises(UNREADABLE, match="more than possible"):
        number_arrays(str(tmp_path / "a.npz"), 100)


@pytest.mark.parametrize(
    "data", [b"", b"no array", npy((10**12,)), npy((2, -1)), npy((1,), "|O", b"12345678"), npy((1,), "|S1")]
)
def test_what_is_no_array_of_numbers_is_refused_before_it_takes_memory(tmp_path, data):
    with zipfile.ZipFile(tmp_path / "a.npz", "w") as archive:
        archive.writestr("a.npy", data)
    with pytest.raises(UNREADABLE):
        number_arrays(str(tmp_path / "a.npz"), 1 << 20)
