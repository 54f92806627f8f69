"""What is wrong with a reference database, or with what it is built from."""

SENTENCES = {
    "database.newer_format": (
        "{source} has format version {version}, newer than this SemRef reads ({known}); update the plugin."
    ),
    "database.no_landmark_left": "The corrected map shows no landmark any more; choose another label map.",
    "database.value_without_class": (
        "The label map has the value {value}, which the database's classes lack; correct it or build a new database."
    ),
    "database.before_block_hashes": (
        "The database was made by SemRef {plugin_version}, which kept no block hashes and bounds of landmarks, so "
        "what changed can't be told; build it anew once."
    ),
    "database.other_pixel_size": (
        "The label map has pixels of {pixel_size:g} m, the database was built with {pixel:g} m; rasterize with the "
        "database's pixel size or build a new database."
    ),
    "database.other_grid": (
        "The label map has {width} × {height} pixels from {x:.10g}, {y:.10g}, the database's had {known_width} × "
        "{known_height} from {known_x:.10g}, {known_y:.10g}; rasterize with the extent of the old label map or "
        "build a new database."
    ),
    "database.window_count": (
        "The database has {count} windows of level {level} where its grid has {known}; build it again."
    ),
    "database.minimum_area": "The minimum area is {minimum_area:g} m²; it must be more than 0.",
    "database.vector_too_short": "A vector of {count} references is too short; use at least {least}.",
    "database.lengths": (
        "The windows have an edge of {window_size:g} and a stride of {stride:g}; give both in map units, above 0."
    ),
    "database.levels": "The levels must be positive multipliers of the window size, for example 1;2.",
    "database.no_landmark_on_map": (
        "The map shows no landmark of {references} with at least {minimum_area:g} m²; choose other reference "
        "classes or a smaller minimum area."
    ),
    "database.read_without_overview": "The database was read without its overview, which map correlation searches.",
    "database.no_described_window": (
        "No window of the database has the {least} landmarks a topology vector needs; build it with larger "
        "windows, a smaller minimum area or more reference classes."
    ),
}
