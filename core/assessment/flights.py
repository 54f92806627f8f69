"""Simulate flights along a planned route: the first position, the growth of errors, the loss of the track.

Single images do not predict a flight, because its images support each other. So flights are simulated: images cut from
the database's overview along a line with the errors of an assessment, motion with stated errors, and the tracker that
also follows real flights, image by image as on board.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import cast

import numpy as np

from .. import limits
from ..database.model import ReferenceDatabase
from ..errors import DatabaseError, ParameterError
from ..flight.model import FlightImage, FlightPose
from ..flight.motion import Link, as_rows
from ..flight.tracker import FlightTracker
from ..geometry.pose import turn_of
from ..labels.sources import ArrayLabels
from ..localization import Place, Prior
from ..localizer.localizer import Localizer
from ..simulation.conditions import Conditions
from ..simulation.label_errors import spoil_labels
from ..simulation.noise import JITTER_LENGTH_PX
from ..simulation.views import View, cut
from ..steps import Steps
from .route import RoutePoints

TURN_DEG, SCALE = 0.3, 0.003
"""Standard deviations of a link's turn and ln pixel size."""

SIZE_KNOWN = 1.1
"""Ratio to either side of the known pixel size: a height above ground known to 10 %."""


@dataclass(frozen=True)
class FlownRoute:
    """Results of F flights over N points of a route, each (F, N), as known during the flight.

    Attributes:
        is_placed: Whether the image has a position.
        radii: 95 % radius, m; NaN without a position.
        errors: True error, m; NaN without a position.
        is_lost: Whether a track ended there.
    """

    points: RoutePoints
    is_placed: np.ndarray
    radii: np.ndarray
    errors: np.ndarray
    is_lost: np.ndarray

    @property
    def placed(self) -> np.ndarray:
        """(N,) share of the flights with a position."""
        return self.is_placed.mean(axis=0)

    @property
    def lost(self) -> np.ndarray:
        """(N,) share of the flights that lose their track at a point."""
        return self.is_lost.mean(axis=0)

    @property
    def radius(self) -> np.ndarray:
        """(N,) 95 % radius in m, median of the flights with a position; NaN if less than half have one."""
        found = np.full(len(self.points), np.nan)
        usual = self.placed >= 0.5
        if usual.any():
            found[usual] = np.nanmedian(self.radii[:, usual], axis=0)
        return found

    def first(self, line: int, threshold: float) -> float | None:
        """Return the m along a line where ``threshold`` of the flights have had a first position; None for nowhere."""
        members = np.flatnonzero(self.points.lines == line)
        known = np.logical_or.accumulate(self.is_placed[:, members], axis=1).mean(axis=0) >= threshold
        return float(self.points.along[members][known.argmax()]) if known.any() else None

    def at(self, points: RoutePoints) -> np.ndarray:
        """Return (M,) number of the nearest image on the same line for other points of the same route."""
        found = np.zeros(len(points), int)
        for line in range(len(points.lengths)):
            here, there = np.flatnonzero(self.points.lines == line), np.flatnonzero(points.lines == line)
            away = np.abs(points.along[there][:, None] - self.points.along[here])
            found[there] = here[away.argmin(axis=1)]
        return found


class FlownRoutes:
    """Simulates the flights of a route."""

    def __init__(  # noqa: PLR0913 - what is flown over, and how
        self,
        database: ReferenceDatabase,
        localizer: Localizer,
        conditions: Conditions,
        footprint: float,
        drift: float,
        seed: int,
    ) -> None:
        """Prepare the data that all flights share.

        Args:
            database: With its overview.
            footprint: Footprint width of an image, m.
            drift: Error of the motion between images: of each link and of all links together, shares of the distance.

        Raises:
            DatabaseError: The database has no overview or no landmark.
        """
        if database.overview is None or not len(database.references):
            raise DatabaseError(
                "{source} has no overview or no landmarks, which simulated flights need. Build it again with both.",
                source=database.source,
            )
        self._database, self._localizer, self._conditions = database, localizer, conditions
        self._footprint, self._drift, self._seed = footprint, drift, seed
        self._frame = database.parameters.overview_frame
        self._source = ArrayLabels(cast(np.ndarray, database.overview))

    def fly(self, points: RoutePoints, flights: int) -> Steps[FlownRoute]:
        """Fly several times along each line of a route. Raises ParameterError: there are too many images."""
        count = len(points)
        if flights * count > limits.FLOWN_IMAGES:
            raise ParameterError(
                "The flights have {count} images together; at most {most} can be simulated. Choose fewer flights or a "
                "larger distance between images.",
                count=flights * count,
                most=limits.FLOWN_IMAGES,
            )
        placed, lost = np.zeros((2, flights, count), bool)
        radii, errors = np.full((2, flights, count), np.nan)
        done = 0
        for line in range(len(points.lengths)):
            members = np.flatnonzero(points.lines == line)
            for flight in range(flights):
                had_track = False
                for n, pose in zip(members.tolist(), self._fly(points, members, [line, flight])):
                    if pose.is_fix:
                        placed[flight, n] = True
                        radii[flight, n] = cast(float, pose.error_95_m)
                        errors[flight, n] = math.dist(cast(Place, pose.place).position, points.places[n])
                    lost[flight, n] = had_track and not pose.is_fix
                    had_track = pose.is_fix
                    done += 1
                    yield "Simulating flights along the route", done / (flights * count)
        return FlownRoute(points, placed, radii, errors, lost)

    def _fly(self, points: RoutePoints, members: np.ndarray, number: list[int]) -> Iterator[FlightPose]:
        """Yield the pose of each image of one flight along a line, as known at that image."""
        rng = np.random.default_rng([self._seed, 4, *number])
        bias = complex(*rng.normal(0, self._drift, 2))
        tracker, before = FlightTracker(self._localizer), None
        for n in members.tolist():
            x, y = points.places[n].tolist()
            size = max(round(self._footprint / self._frame.pixel_size), 1)
            view = View(x, y, float(points.headings_deg[n]), self._footprint / size, size, size)
            link = None if before is None else link_between(0, (before, view), self._drift, bias, rng)
            yield tracker.add(self._image(view, rng), link)
            before = view

    def _image(self, view: View, rng: np.random.Generator) -> FlightImage:
        database, pixel = self._database, self._frame.pixel_size
        values = database.class_table.reference_values
        seen, noise = self._conditions.drawn(view, rng, values)
        noise = replace(noise.in_pixels(view.pixel_size), jitter_length=max(JITTER_LENGTH_PX / pixel, 2.0))
        labels = cut(self._source, self._frame, seen)
        x, y = database.references.positions[rng.integers(0, len(database.references))]
        donor = cut(self._source, self._frame, replace(view, x=float(x), y=float(y)))
        if labels.any():
            labels = spoil_labels(labels, noise, rng, values, donor)
        sizes = view.pixel_size / SIZE_KNOWN, view.pixel_size * SIZE_KNOWN
        return FlightImage("simulated", labels, prior=Prior(pixel_size_range=sizes), biases=self._conditions.biases)


def link_between(number: int, pair: tuple[View, View], drift: float, bias: complex, rng: np.random.Generator) -> Link:
    """Return the motion between two views with simulated errors, and their standard deviations.

    Args:
        number: Of the first image, from 0.
        drift: Standard deviation, share of the distance.
        bias: Constant error of all links of the flight, share of the distance along and across.
    """
    turns = [turn_of(view.heading_deg, view.pixel_size) for view in pair]
    step = (complex(*pair[1].position) - complex(*pair[0].position)) / turns[0]
    ratio, off = turns[1] / turns[0], drift * abs(step)
    step += step * bias + complex(*rng.normal(0, off, 2))
    turn = float(-np.angle(ratio) + rng.normal(0, math.radians(TURN_DEG)))
    size = float(np.log(abs(ratio)) + rng.normal(0, SCALE))
    known = np.diag([2 * off**2 + 0.25, 2 * off**2 + 0.25, math.radians(TURN_DEG) ** 2, SCALE**2])
    return Link(number, number + 1, (step.real, -step.imag), turn, size, as_rows(known))
