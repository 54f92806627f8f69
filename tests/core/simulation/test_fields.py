"""Random fields: as large as said, alike over the lengths said, repeated by a seed."""

import numpy as np
import pytest

from semref.core.simulation.fields import correlated_field, correlated_shifts

KERNELS = ((30.0, 0.5), (500.0, 0.3))


def correlation(distance, count=1500):
    """Measured over many fields at two points and along both axes."""
    points = np.array([[5_000_000.0, 40.0], [5_000_000.0 + distance, 40.0]])
    rng = np.random.default_rng(7)
    one, other = np.array([correlated_shifts(points, KERNELS, rng) for _ in range(count)]).transpose(1, 0, 2)
    return (one * other).mean(), (one**2).mean()


@pytest.mark.parametrize("distance", [0.0, 20.0, 300.0])
def test_shifts_are_correlated_as_the_kernels_say(distance):
    shared, variance = correlation(distance)
    assert variance == pytest.approx(0.8, abs=0.08)
    assert shared == pytest.approx(sum(share * np.exp(-distance / length) for length, share in KERNELS), abs=0.08)


def test_a_field_of_pixels_is_that_of_its_points():
    field = correlated_field((40, 60), KERNELS, 8, np.random.default_rng(3))
    rows, columns = np.divmod(np.arange(6 * 9), 9)
    shifts = correlated_shifts(8 * np.column_stack([columns, rows]), KERNELS, np.random.default_rng(3))
    assert field.shape == (2, 40, 60)
    np.testing.assert_allclose(
        field[:, ::8, ::8].reshape(2, -1).T, shifts.reshape(6, 9, 2)[:5, :8].reshape(-1, 2), atol=1e-5
    )
