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
    "database.parts_other_pixel_size": (
        "{source} has pixels of {pixel_size:g} m and {other} of {known:g} m; databases that are used as one have the "
        "same pixel size."
    ),
    "database.parts_other_setting": (
        "{source} was built with another {setting} ({value}) than {other} ({known}); build them alike to use them as "
        "one."
    ),
    "database.setting_window_size": "window size",
    "database.setting_stride": "stride",
    "database.setting_levels": "levels",
    "database.setting_references_per_vector": "number of landmarks a vector",
    "database.setting_minimum_area": "minimum area",
    "database.setting_overview_factor": "reduction of the overview",
    "database.parts_other_classes": (
        "{source} has another class table than {other}; build them with one class table to use them as one."
    ),
    "database.parts_off_grid": (
        "{source} begins {columns:.10g} pixels to the side of {other} and {rows:.10g} up or down; to be used as one "
        "both must be whole multiples of {factor} pixels ({length:g} m)."
    ),
    "database.parts_too_far": (
        "The databases lie so far apart that a map of all would have {width} × {height} pixels; use those together "
        "that are neighbors."
    ),
    "database.parts_without_bounds": (
        "{source} was made by SemRef {plugin_version}, which kept no bounds of landmarks, so it can't be used together "
        "with others; build it anew once."
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
