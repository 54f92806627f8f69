"""Sentences of core and storage as algorithms say them that have a parameter to mend it with."""

from __future__ import annotations

EVERYWHERE = ""
"""Instead of a key: said by every algorithm and window, since what helps is in reach of all."""

SENTENCES_BY_KEY: dict[str, tuple[str, str]] = {
    "segmentation.no_class_names": (
        "CLASS_TABLE",
        "{source} does not name its classes (metadata key class_names); give them in CLASS_TABLE, in the order "
        "of the network's outputs.",
    ),
    "segmentation.names_in_table": (
        "CLASS_TABLE",
        "{source} tells {channels} classes apart, but there are {count} class names in CLASS_TABLE: {names}; "
        "take the names it was trained with.",
    ),
    "segmentation.table_lacks_class": (
        "CLASS_TABLE",
        "CLASS_TABLE lacks the class {missing} of {source}; add it, or leave CLASS_TABLE empty.",
    ),
    "segmentation.resolution_too_coarse": (
        "RESOLUTION",
        "At {resolution_cm:g} cm a pixel nothing is left of the image; give another RESOLUTION.",
    ),
    "training.damaged": (
        "RESUME",
        "{path} is damaged ({reason}), so this training can't be continued; turn RESUME off to start it again.",
    ),
    "database.levels": (
        "LEVELS",
        "LEVELS must be positive multipliers of the window size, for example 1;2.",
    ),
    "database.before_block_hashes": (
        EVERYWHERE,
        "The database was made by SemRef {plugin_version}, which kept no block hashes and bounds of landmarks, "
        "so what changed can't be told; build it anew once with “Build reference database”.",
    ),
    "storage.too_many_pixels": (
        "PIXEL_SIZE",
        "The label map would have {width} × {height} pixels; choose a larger PIXEL_SIZE or a smaller EXTENT.",
    ),
    "assessment.footprints": (
        "FOOTPRINT",
        "FOOTPRINT is {text}; give edges of the ground in map units, separated by “;”.",
    ),
    "assessment.no_window_on_labels": (
        "MINIMUM_REFERENCES",
        "No window of the database lies on LABELS and has {minimum_references} landmarks or more; choose the "
        "label map of the same ground, or a smaller MINIMUM_REFERENCES.",
    ),
    "assessment.square_edge": (
        "SPACING",
        "SPACING is {size:g}; give the edge of a square in map units.",
    ),
    "assessment.too_many_squares": (
        "SPACING",
        "SPACING is {size:g}, which makes {count} squares of the map; give {least:.3g} or more.",
    ),
    "assessment.point_distance": (
        "SPACING",
        "SPACING is {spacing:g}; give the distance between points in map units.",
    ),
    "assessment.too_many_points": (
        "SPACING",
        "SPACING is {spacing:g}, which makes {count} points; give {least:.3g} or more.",
    ),
    "assessment.route_without_length": (
        "ROUTE",
        "ROUTE has no line with a length; draw one through two points at least.",
    ),
    "assessment.footprint": (
        "FOOTPRINT",
        "FOOTPRINT is {footprint:g}; give the edge of the ground that an image shows.",
    ),
    "onboard.no_landmark_in_area": (
        "CLIP",
        "No landmark lies in the area of CLIP; choose another area or a larger DISTANCE.",
    ),
    "onboard.no_file": (
        EVERYWHERE,
        "There is no file {path}; export one with “Export for onboard use” or choose another.",
    ),
    "onboard.foreign": (
        EVERYWHERE,
        "{path} is no onboard file of SemRef; choose one made by “Export for onboard use”.",
    ),
    "labels.no_reference_class": (
        "REFERENCE_CLASSES",
        "No class is a reference class; name at least one of {classes} in REFERENCE_CLASSES, or give it the role "
        "“reference” in the class table.",
    ),
    "storage.sizes_without_georeference": (
        "REFERENCE",
        "REFERENCE has {width} × {height} pixels and PREDICTED {other_width} × {other_height}, and not both have a "
        "georeference; compare images of one size or two georeferenced maps.",
    ),
    "storage.no_overlap": (
        "REFERENCE",
        "REFERENCE and PREDICTED don't overlap; choose maps of the same ground.",
    ),
    "storage.no_geopackage": (
        EVERYWHERE,
        "{path} is not a GeoPackage; choose a database made by “Build reference database”.",
    ),
    "storage.foreign_database": (
        EVERYWHERE,
        "{path} is not a SemRef reference database (it lacks {missing}); choose one made by “Build reference "
        "database”.",
    ),
    "storage.bands_for_labels": (
        EVERYWHERE,
        "{path} has {bands} bands; a label map has one: decode a color image with “Decode color labels” first.",
    ),
    "storage.no_subset_tiles": (
        "RESOLUTION",
        "The labels leave {training} tiles of {tile_size} pixels for training and {validation} for validation; label "
        "more ground, or give a smaller RESOLUTION or another VALIDATION_FRACTION.",
    ),
    "labels.smaller_than_tile": (
        "RESOLUTION",
        "The ground has {width} × {height} pixels, less than a tile of {tile_size}; label more ground, or give a "
        "smaller RESOLUTION.",
    ),
    "labels.nothing_in_common": (
        "REFERENCE",
        "The maps have no pixel in common that REFERENCE labels; choose maps of the same ground.",
    ),
}
"""(parameter key, English template) by code: said instead of the code's own template by an algorithm with that key."""
