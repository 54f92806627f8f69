"""Inverses and eigenvectors of small matrices."""

import numpy as np
import pytest

from semref.core.geometry.small_matrices import eigen, inverse_of


def definite(size, smallest=1e-3):
    rng = np.random.default_rng(size)
    turn = np.linalg.qr(rng.normal(size=(size, size)))[0]
    return turn * np.geomspace(1, smallest, size) @ turn.T


@pytest.mark.parametrize("size", [1, 4, 9])
def test_an_inverse_times_its_matrix_is_one_also_with_different_units(size):
    units = 10.0 ** np.arange(size) ** 1.5
    matrix = definite(size) * units * units[:, None]
    product = inverse_of(matrix) @ matrix * (units[:, None] / units)
    np.testing.assert_allclose(product, np.eye(size), atol=1e-9)


def test_tiny_matrices_have_an_inverse():
    np.testing.assert_allclose(inverse_of(1e-30 * definite(4)) * 1e-30, np.linalg.inv(definite(4)), rtol=1e-9)


def test_an_almost_singular_matrix_has_a_large_finite_inverse():
    matrix = 1e8 * definite(9, 1e-20)
    found = inverse_of(matrix)
    assert np.isfinite(found).all() and np.linalg.eigvalsh(found).max() > 1e3


@pytest.mark.parametrize("size", [4, 9])
def test_eigenvectors_are_turned_into_themselves(size):
    matrix = definite(size)
    values, vectors = eigen(matrix)
    np.testing.assert_allclose(values, np.linalg.eigvalsh(matrix)[::-1], atol=1e-12)
    np.testing.assert_allclose(matrix @ vectors, vectors * values, atol=1e-12)
    np.testing.assert_allclose(vectors.T @ vectors, np.eye(size), atol=1e-12)
