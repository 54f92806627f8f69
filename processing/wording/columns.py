"""What the columns of layers are called in the user's language, and the words for what is a key in them.

The columns' own names are public and stay as they are; QGIS shows these as their aliases.
"""

from __future__ import annotations

from collections.abc import Collection

from ...core.localization import Method, Status
from ...storage.database.titles import SENTENCES_OF_REFERENCES, SENTENCES_OF_WINDOWS
from ..translation import tr
from .annotation_messages import kind_titles, severity_words
from .sentences import worded


def column_titles() -> dict[str, str]:
    """Title of each column by its name."""
    return {**_database(), **_positions(), **_flights(), **_landmarks(), **_assessment(), **_annotation(), **_trials()}


def _database() -> dict[str, str]:
    """Of windows and landmarks, wherever they are shown."""
    return {name: tr(text) for name, text in {**SENTENCES_OF_WINDOWS, **SENTENCES_OF_REFERENCES}.items()}


def _positions() -> dict[str, str]:
    return {
        "image": tr("Image"),
        "status": tr("Status"),
        "x": tr("Easting"),
        "y": tr("Northing"),
        "heading": tr("Heading (° from grid north)"),
        "pixel_size": tr("Pixel size (m)"),
        "confidence": tr("Probability to be right"),
        "distance": tr("Distance of topology vectors"),
        "inliers": tr("Landmarks that agree"),
        "references": tr("Landmarks in the image"),
        "log_odds": tr("Logarithm of the odds"),
        "error_95": tr("95 % radius (m)"),
        "window": tr("Window"),
        "method": tr("Method"),
        "reason": tr("Reason"),
        "camera_x": tr("Easting below the camera"),
        "camera_y": tr("Northing below the camera"),
        "jump": tr("Out of reach in time"),
        "error_95_minor": tr("Shorter semi-axis of the 95 % ellipse (m)"),
        "error_95_direction": tr("Direction of its longer semi-axis (°)"),
        "heading_deviation": tr("Deviation of the heading (°)"),
        "pixel_size_deviation": tr("Deviation of the pixel size (m)"),
        "search_capped": tr("Search was capped"),
        "sigma_east": tr("Deviation eastwards (m)"),
        "sigma_north": tr("Deviation northwards (m)"),
        "correlation": tr("Correlation of both"),
        "sigma_heading": tr("Standard deviation of the heading (°)"),
        "sigma_scale": tr("Relative deviation of the scale"),
        "camera": tr("Camera"),
        "gps_distance": tr("Distance of the photo’s GPS from the database (m)"),
        "time": tr("Time (UTC)"),
        "rank": tr("Rank"),
        "number": tr("Number"),
    }


def _flights() -> dict[str, str]:
    return {
        "source": tr("Held by"),
        "track": tr("Track"),
        "outvoted": tr("Its own fix was outvoted"),
        "images": tr("Images"),
        "own": tr("Images with a fix of their own"),
        "first": tr("First image"),
        "last": tr("Last image"),
        "length": tr("Length (m)"),
        "largest_error_95": tr("Largest 95 % radius (m)"),
        "start": tr("Start (UTC)"),
        "end": tr("End (UTC)"),
    }


def _landmarks() -> dict[str, str]:
    return {
        "image_column": tr("Column in the image"),
        "image_row": tr("Row in the image"),
        "seen_x": tr("Easting where it is seen"),
        "seen_y": tr("Northing where it is seen"),
        "residual": tr("Residual (m)"),
        "column": tr("Column"),
        "row": tr("Row"),
        "center_distance": tr("Distance from the center (px)"),
    }


def _assessment() -> dict[str, str]:
    return {
        "footprint": tr("Footprint (m)"),
        "success": tr("Expected success"),
        "success_low": tr("Expected success, at least (95 %)"),
        "success_high": tr("Expected success, at most (95 %)"),
        "error": tr("Error (m)"),
        "objects": tr("Landmarks in view"),
        "classes": tr("Classes in view"),
        "distinctiveness": tr("Distinctiveness"),
        "look_alikes": tr("Look-alikes"),
        "wrong": tr("Wrong fixes (share)"),
        "trials": tr("Simulated images"),
        "verdict": tr("Verdict"),
        "reason": tr("Reason"),
        "route": tr("Route"),
        "along": tr("Along the route (m)"),
        "gap": tr("Stretch without an expected fix (m)"),
        "gap_seconds": tr("Stretch without an expected fix (s)"),
        "shift": tr("Shift to the right that helps (m)"),
        "shift_success": tr("Expected success when shifted"),
        "stretch": tr("Stretch of the route (WKT)"),
        "flight_placed": tr("Share of the flights with a position"),
        "flight_radius": tr("95 % radius in flight (m)"),
        "flight_lost": tr("Share of the flights that lose their track"),
    }


def _annotation() -> dict[str, str]:
    return {
        "kind": tr("Kind"),
        "severity": tr("Severity"),
        "message": tr("Message"),
        "feature_id": tr("Feature"),
        "other_id": tr("Other feature"),
        "annotated_class": tr("Annotated class"),
        "predicted_class": tr("Predicted class"),
        "annotated_value": tr("Annotated value"),
        "predicted_value": tr("Predicted value"),
    }


def _trials() -> dict[str, str]:
    return {
        "trial": tr("Trial"),
        "right": tr("Right"),
        "heading_error": tr("Error of the heading (°)"),
        "scale_error": tr("Error of the scale"),
        "true_x": tr("True easting"),
        "true_y": tr("True northing"),
        "scale": tr("Scale"),
        "offset": tr("Offset from the window"),
        "missed": tr("Landmarks missed (%)"),
        "invented": tr("Landmarks invented (%)"),
        "misnamed": tr("Landmarks misnamed (%)"),
        "ragged": tr("Ragged edges (map units)"),
        "landmarks": tr("Landmarks in the database"),
        "background": tr("Background misnamed (%)"),
        "displaced": tr("Map displaced (map units)"),
        "shifted": tr("Classes shifted (map units)"),
        "leaning": tr("Leaning roofs (%)"),
        "lens": tr("Lens distortion (%)"),
        "tilt": tr("Camera tilt (°)"),
        "road": tr("Road to the fix"),
        "radius_ratio": tr("Error over 95 % radius"),
    }


def status_words() -> dict[str, str]:
    """Words for each key of ``status``, of images that could not be read as well."""
    return {**{status.key: worded(status.title) for status in Status}, "error": tr("could not be read")}


def method_words() -> dict[str, str]:
    """Words for each key of ``method``."""
    return {method.key: worded(method.title) for method in Method}


def source_words() -> dict[str, str]:
    """Words for each key of ``source`` of a flight."""
    return {"own": tr("fix of its own"), "flight": tr("the flight")}


def trial_words() -> dict[str, str]:
    """Words for each key of ``kind`` of a trial."""
    return {"map": tr("image of the map"), "mirrored": tr("mirrored image")}


def verdict_words() -> dict[str, str]:
    """Words for each key of ``verdict``, from the worst to the best."""
    return {
        "hardly_ever": tr("hardly ever"),
        "sometimes": tr("sometimes"),
        "often": tr("often"),
        "reliably": tr("reliably"),
        "very_reliably": tr("very reliably"),
    }


def column_words(names: Collection[str]) -> dict[str, dict[str, str]]:
    """Words by key, of each column of a layer that holds keys; ``names``: of its columns."""
    words = {
        "status": status_words(),
        "method": method_words(),
        "source": source_words(),
        "verdict": verdict_words(),
        "severity": severity_words(),
        "kind": kind_titles() if "severity" in names else trial_words(),
        "road": method_words(),
    }
    return {name: found for name, found in words.items() if name in names}
