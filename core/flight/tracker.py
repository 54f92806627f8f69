"""Follow a flight image by image: each fix uses all images before it, in bounded memory and time.

See docs/explanation/method.md#flights.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import cast

import numpy as np

from ..errors import ParameterError
from ..localization import Method, Prior, Status, log_odds_of, risk_of
from ..localizer.localizer import Localizer, default_scales
from ..sentences import Sentence
from .evidence import SeenImage, best_poses, prepare_image
from .measurement import Measurement, measure_near, shared_after, shared_variance
from .model import FlightImage, FlightPose
from .motion import Link, LinkSource, as_rows
from .pool import (
    NOWHERE,
    OWN_MOST,
    Past,
    Pool,
    look_noise,
    new_pool,
    own_noise,
    pack,
    predict,
    prune,
    rival_of,
    same_place,
    unpack,
    update,
    with_past,
)
from .reported_pose import predicted, report_pose, unplaced
from .settings import FLIGHT, FlightSettings
from .smoothing import Estimate, drift_of, first_estimate, soften, step_over, with_measurement

OVERLAP_SHARE = 0.2
"""Least weight of an image with hardly any new ground. With 0.35 or 0.6, tracks of overlapping photos were more often
wrong than stated."""

APART = 0.25
"""Least distance of different tracks as a share of the image's edge on the ground, as of places in map correlation."""

SEARCH_FIRST = 4
"""Number of first images that are searched on the whole map. Set by hand, for the time."""

SEARCH_EVERY = (2, 5)
"""Later, one of this many images is searched: before a track is followed, and while one is. Set by hand, for the
time."""

ASSUMED = (0.4, 20.0, 0.1)
"""Standard deviations of an assumed link: share of the distance, degrees, ln pixel size."""

SIZE_RANGE = 1.15
"""Ratio, to either side, in which pixel sizes are searched around the known one."""

STATE_VERSION = 2


@dataclass(frozen=True)
class Looked:
    """Result for the latest image, for later smoothing.

    Attributes:
        estimate: Of its track; None without one, and while own fixes contest it.
        measured: Measurement at the place that the track expects; None without one.
        link: To this image, assumed ones included; None for the first image and after a break.
        is_new: A track began with this image.
    """

    estimate: Estimate | None = None
    measured: Measurement | None = None
    link: Link | None = None
    is_new: bool = False


class FlightTracker:
    """Follows one flight. The same images and links give the same result.

    Attributes:
        looked: Result for the latest image.
        track: Number of the latest track, from 1; 0 before the first.
        risk: Error probability of the latest track as a whole, from the images that began it; 1 before the first.
        doubt: The same from the last images, while it is followed.
    """

    def __init__(self, localizer: Localizer, settings: FlightSettings = FLIGHT) -> None:
        """Begin a flight; ``localizer``: of a database with its overview."""
        self.localizer, self.settings = localizer, settings
        self.track, self.looked = 0, Looked()
        self._number = -1
        self._pool = self._mirror = self._rival = Pool.empty(settings.window)
        self._past: list[Past] = []
        self._latest: Past | None = None
        self._held: Estimate | None = None
        self._lost: Estimate | None = None
        self.risk = self.doubt = 1.0
        self._shared_m2 = 0.0

    def add(self, image: FlightImage, link: Link | None = None) -> FlightPose:
        """Add the next image and return its pose, which is a fix only while a track is followed.

        Args:
            link: From the image before. If None, the motion before continues. Without any motion, and where the pixels
                contradict it, the flight begins again.
        """
        self._number += 1
        prior = self._prior(image)
        seen = prepare_image(image, self.localizer.pyramid, prior, self.settings)
        if self._latest is not None:
            link = link or self._assumed_link(image)
        if link is None or self._latest is None:
            self._begin()
        else:
            self._past.insert(0, replace(self._latest, link=link))
            del self._past[self.settings.window - 1 :]
        weight = self._weight(seen, link)
        self._look(seen, link, weight)
        self._latest = Past(seen, NOWHERE, weight)
        self._follow(image, seen, link)
        return self._report(image)

    def state(self) -> dict[str, np.ndarray]:
        """Return the state of the flight as arrays by name, for ``from_state``. Its size does not grow."""
        pools = {"pool": self._pool, "mirror": self._mirror, "rival": self._rival}
        arrays = {f"{name}_{field}": value for name, pool in pools.items() for field, value in vars(pool).items()}
        arrays["counts"] = np.array([STATE_VERSION, self._number, self.track, len(self._past)])
        arrays["numbers"] = np.array([self.risk, self._shared_m2])
        for name, estimate in (("held", self._held), ("lost", self._lost)):
            if estimate is not None:
                arrays.update({f"{name}_mean": estimate.mean, f"{name}_covariance": estimate.covariance})
        remembered = [*self._past, *([] if self._latest is None else [self._latest])]
        for number, past in enumerate(remembered):
            arrays.update({f"past{number}_{field}": value for field, value in pack(past).items()})
        return arrays

    @classmethod
    def from_state(
        cls, localizer: Localizer, state: Mapping[str, np.ndarray], settings: FlightSettings = FLIGHT
    ) -> FlightTracker:
        """Return a tracker that continues from a state.

        Args:
            localizer: Of the same database.
            state: Result of ``state``.

        Raises:
            ParameterError: The state is of another version or of other settings.
        """
        tracker = cls(localizer, settings)
        version, tracker._number, tracker.track, count = (int(value) for value in state["counts"])
        if version != STATE_VERSION or count >= settings.window:
            raise ParameterError(
                "The saved state of the flight has version {version}; this SemRef reads version {known}.",
                version=version,
                known=STATE_VERSION,
            )
        tracker.risk, tracker._shared_m2 = state["numbers"].tolist()
        tracker._pool, tracker._mirror, tracker._rival = (
            Pool(*(state[f"{name}_{part}"] for part in ("states", "variances", "evidence")))
            for name in ("pool", "mirror", "rival")
        )
        tracker._held, tracker._lost = (
            Estimate(state[f"{name}_mean"], state[f"{name}_covariance"]) if f"{name}_mean" in state else None
            for name in ("held", "lost")
        )
        if tracker._number >= 0:
            remembered = [_part(state, f"past{number}_") for number in range(count + 1)]
            *tracker._past, tracker._latest = map(unpack, remembered)
        return tracker

    def _begin(self) -> None:
        self._pool = self._mirror = self._rival = Pool.empty(self.settings.window)
        self._past, self._held, self._lost = [], None, None

    def _prior(self, image: FlightImage) -> Prior:
        """Return the prior of the image with a range of pixel sizes: its own, otherwise that of the track."""
        if image.prior.pixel_size_range is not None:
            return image.prior
        if self._held is not None:
            size, ratio = float(np.exp(self._held.mean[3])), SIZE_RANGE
            return replace(image.prior, pixel_size_range=(size / ratio, size * ratio))
        sizes = self.localizer.pixel_sizes(image.size_wh[::-1], default_scales(Method.MAP_CORRELATION))
        return replace(image.prior, pixel_size_range=sizes)

    def _assumed_link(self, image: FlightImage) -> Link | None:
        """Return the motion before as a link; None without one, and if the image should overlap but does not."""
        latest = self._past[0].link if self._past else None
        if latest is None or (image.is_apart and latest.source is LinkSource.PIXELS):
            return None
        share, heading_deg, size = ASSUMED
        known = np.diag([*[(share * abs(latest.step)) ** 2] * 2, np.radians(heading_deg) ** 2, size**2])
        return replace(latest, turn=0.0, log_scale=0.0, covariance=as_rows(known), source=LinkSource.ASSUMED)

    def _weight(self, seen: SeenImage, link: Link | None) -> float:
        """Return the weight of the image's evidence: the share of new ground, with a minimum for the rest."""
        if link is None:
            return 1.0
        length = abs(link.step)
        if link.in_meters:
            length /= float(np.exp(np.mean(np.log(seen.prior.pixel_size_range or (1.0, 1.0)))))
        return float(np.clip(length / seen.edge_px, OVERLAP_SHARE, 1.0))

    def _look(self, seen: SeenImage, link: Link | None, weight: float) -> None:
        """Update the hypotheses and, while no track is followed, those of the mirrored flight."""
        searching, held = SEARCH_EVERY
        every = searching if self._held is None else held
        is_searched = len(self._past) < SEARCH_FIRST or self._number % every == 0
        is_searched = is_searched or self._held is None and not len(self._mirror)
        latest, past = Past(seen, link or NOWHERE, weight), self._past if is_searched else None
        self._pool = self._update_pool(self._pool, latest, past)
        if self._held is None:
            flipped = None if past is None else [one.mirrored() for one in past]
            self._mirror = self._update_pool(self._mirror, latest.mirrored(), flipped)

    def _update_pool(self, pool: Pool, latest: Past, past: list[Past] | None) -> Pool:
        """Return the hypotheses after an image; with ``past``, new ones are searched.

        ``latest``: the image, with the link that leads to it.
        """
        settings, pyramid, seen, weight = self.settings, self.localizer.pyramid, latest.seen, latest.weight
        if len(pool):
            pool = update(predict(pool, latest.link), seen, pyramid, weight, settings)
        if past is not None:
            count = settings.added if len(pool) else settings.candidates
            new = new_pool(best_poses(seen, pyramid, count, APART), seen, weight, settings)
            new = new.append(self._at_own(seen, weight))
            pool = pool.append(with_past(new, past, pyramid, settings))
        return prune(pool, self._edge_m(seen), settings.hypotheses, APART)

    def _at_own(self, seen: SeenImage, weight: float) -> Pool:
        """Return a hypothesis at the image's own best place."""
        if seen.own_state is None or seen.own_odds <= 0:
            return Pool.empty(self.settings.window)
        alone = Pool(seen.own_state[None], own_noise(seen)[None], np.zeros((1, self.settings.window)))
        return update(alone, seen, self.localizer.pyramid, weight, self.settings)

    @staticmethod
    def _edge_m(seen: SeenImage) -> float:
        return seen.edge_px * float(np.exp(np.mean(np.log(seen.prior.pixel_size_range or (1.0, 1.0)))))

    def _follow(self, image: FlightImage, seen: SeenImage, link: Link | None) -> None:
        """Continue the track, begin one, or end it."""
        settings, found, is_lost = self.settings, Looked(link=link), False
        if self._held is not None and link is not None:
            expected = step_over(self._held, link, self._shared_m2, settings).predicted
            measured = self._measure(image, expected)
            self._held = expected
            if measured is not None:
                self._held = with_measurement(expected, soften(measured, expected), self._shared_m2)
                self._shared_m2 = shared_after(self._shared_m2, measured, settings)
            found = Looked(self._held, measured, link)
            self._rival = self._rival_place(image, seen, link, self._held)
            risk, is_lost = self._risk_now(), self._is_lost(seen, link, self._held)
            if risk >= 1 - settings.allowed_risk or (is_lost and len(self._rival)):
                # The past was wrong: the flight begins again with this image.
                self._begin()
                self._latest = Past(seen, NOWHERE, 1.0)
                self._look(seen, None, 1.0)
                found, is_lost = Looked(link=link), False
            elif is_lost and not self._is_still_best(seen, link, self._held):
                # The mirrored flight was not updated meanwhile: the next decision waits for it.
                self._held, self._mirror, self._lost = None, Pool.empty(settings.window), self._held
                found = Looked(link=link)
            else:
                is_lost = False
                if risk > settings.allowed_risk:
                    found = replace(found, estimate=None)
        elif self._lost is not None and link is not None:
            found = self._look_for_lost(image, seen, link)
        if self._held is None and not is_lost:
            risk = self._best_risk()
            if risk <= settings.allowed_risk:
                self.risk, self.track = risk, self.track + 1
                found = replace(self._start(image, seen), link=link)
                self._held, self._lost = found.estimate, None
        self.looked = found
        if self._held is not None:
            self.doubt = self._doubt(self._here(seen, self._held))

    def _look_for_lost(self, image: FlightImage, seen: SeenImage, link: Link) -> Looked:
        """Carry a lost track on by the motion, and continue it if images agree there again."""
        settings = self.settings
        lost = cast(Estimate, self._lost)
        self._lost = expected = step_over(lost, link, self._shared_m2, settings).predicted
        here, edge_m = self._here(seen, expected), APART * self._edge_m(seen)
        if not len(here) or here[0] > 0:
            return Looked(link=link)
        # The more places are within reach, the more of them agree by chance.
        places = (1 + 3 * float(np.sqrt(expected.covariance[:2, :2].trace())) / edge_m) ** 2
        odds = min(log_odds_of(self.risk), OWN_MOST) - float(np.log(places))
        support = float(self._pool.evidence[0, -settings.recent :].sum())
        measured = self._measure(image, expected)
        if measured is None or risk_of(odds + settings.risk_curve[1] * support) > settings.allowed_risk:
            return Looked(link=link)
        self._held = with_measurement(expected, soften(measured, expected), self._shared_m2)
        self._lost = None
        return Looked(self._held, measured, link)

    def _rival_place(self, image: FlightImage, seen: SeenImage, link: Link, held: Estimate) -> Pool:
        """Return the place of own fixes that contradict the track, see ``rival_of``."""
        is_fix = image.own is not None and image.own.is_fix
        variances = np.diag(held.pose_covariance)[None, [0, 2, 3]]
        track = Pool(held.state[None], variances, np.zeros((1, self.settings.window)))
        track = track.append(self._pool.select(self._here(seen, held)[:1]))
        weight = self._weight(seen, link) if is_fix else 0.0
        return rival_of(track, predict(self._rival, link), seen, weight, self.settings)

    def _risk_now(self) -> float:
        """Return the error probability of the track. Where own fixes contest it, the past counts at most as one fix."""
        if not len(self._rival):
            return self.risk
        odds = min(log_odds_of(self.risk), OWN_MOST)
        return max(self.risk, risk_of(odds - self.settings.risk_curve[1] * float(self._rival.totals[0])))

    def _best_risk(self) -> float:
        """Return the error probability of the best hypothesis against the second best and the mirrored flight."""
        if not len(self._pool):
            return 1.0
        totals = self._pool.totals
        return self._risk_of(float(totals[0]) - max([0.0, *totals[1:2], *self._mirror.totals[:1]]))

    def _risk_of(self, lead: float) -> float:
        """Return the error probability of a hypothesis from its lead over the strongest opponent."""
        offset, slope = self.settings.risk_curve
        return risk_of(offset + slope * lead)

    def _start(self, image: FlightImage, seen: SeenImage) -> Looked:
        """Return the first estimate of a track, at the best hypothesis."""
        state, drift = self._pool.states[0], drift_of(past.link for past in self._past)
        # A hypothesis is known to one pixel of the first look, after any number of looks.
        deviations = np.sqrt(look_noise(seen, state[None], self.settings.start_noise)[0][[0, 0, 1, 2]])
        bare = first_estimate(state, deviations, 0.0, drift)
        measured = self._measure(image, bare)
        self._shared_m2 = 0.0 if measured is None else shared_variance([measured], self.settings)
        estimate = first_estimate(state, deviations, self._shared_m2, drift)
        if measured is not None:
            estimate = with_measurement(estimate, measured, self._shared_m2)
        return Looked(estimate, measured, None, is_new=True)

    def _measure(self, image: FlightImage, expected: Estimate) -> Measurement | None:
        return measure_near(image, self.localizer, expected.state, expected.pose_covariance, self.settings)

    def _here(self, seen: SeenImage, held: Estimate) -> np.ndarray:
        """Return the hypotheses at an estimate of the track, best first."""
        reach = APART * self._edge_m(seen) + 3 * float(np.sqrt(held.covariance[:2, :2].trace()))
        return np.flatnonzero(same_place(self._pool.states, held.state, reach))

    def _doubt(self, here: np.ndarray) -> float:
        """Return the error probability of the hypotheses at the track against all others."""
        if not len(here):
            return 1.0
        totals = self._pool.totals
        return self._risk_of(float(totals[here[0]]) - max([0.0, *np.delete(totals, here)[:1]]))

    def _is_lost(self, seen: SeenImage, link: Link, held: Estimate) -> bool:
        """Return whether the last images contradict the track, or all images of the window support another place.

        The evidence of images that overlap by more than two thirds is small.
        """
        here = self._here(seen, held)
        if not len(here):
            return True
        evidence = self._pool.evidence[here[0]]
        least = self.settings.lost_evidence * min(1.0, 3 * self._weight(seen, link))
        if evidence[-self.settings.recent :].sum() < least:
            return True
        others = np.delete(self._pool.totals, here)
        return len(others) > 0 and self._risk_of(float(others[0] - evidence.sum())) <= self.settings.allowed_risk

    def _is_still_best(self, seen: SeenImage, link: Link, held: Estimate) -> bool:
        """Return whether a track would begin at once again at the same place, so that it only passes a bad stretch."""
        here = self._here(seen, held)
        if not len(here) or here[0] > 0:
            return False
        latest = Past(seen, link, self._weight(seen, link))
        past = [one.mirrored() for one in self._past]
        self._mirror = self._update_pool(Pool.empty(self.settings.window), latest.mirrored(), past)
        return self._best_risk() <= self.settings.allowed_risk

    def _report(self, image: FlightImage) -> FlightPose:
        held, allowed = self._held, self.settings.allowed_risk
        if self._lost is not None:
            return predicted(image, self.localizer, self._lost)
        risk = self._best_risk() if held is None else self._risk_now()
        if held is None or risk > allowed:
            reason = Sentence(
                "The images of the flight so far are not sufficient for a fix: error probability {risk:.2g}; at most "
                "{allowed:.2g} is allowed.",
                risk=risk,
                allowed=allowed,
            )
            status = Status.AMBIGUOUS if len(self._pool) > 1 else Status.NO_MATCH
            return unplaced(image, reason, status)
        return report_pose(image, self.localizer, held, risk, self.track)


def _part(state: Mapping[str, np.ndarray], prefix: str) -> dict[str, np.ndarray]:
    """Return the arrays with a prefix, by the rest of their names."""
    return {name[len(prefix) :]: np.array(value) for name, value in state.items() if name.startswith(prefix)}
