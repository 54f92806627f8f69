"""The sample area in small, so that tests make it in seconds."""

from __future__ import annotations

from semref.core.sample import landscape

SIZE_XY = (1500.0, 1300.0)
"""Meters; hardly less holds a photo turned by any angle."""


def make_small(monkeypatch) -> None:
    monkeypatch.setattr(landscape, "SIZE_XY", SIZE_XY)
