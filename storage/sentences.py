"""What is wrong with files that are read and written here."""

SENTENCES = {
    "storage.labels_not_in_table": (
        "The labels have the value {unknown}, which the class table lacks; its classes are {classes}."
    ),
    "storage.sizes_without_georeference": (
        "The reference has {width} × {height} pixels and the prediction {other_width} × {other_height}, and not "
        "both have a georeference; compare images of one size or two georeferenced maps."
    ),
    "storage.rotated_against": "One of the maps is rotated against the other; warp both to a north-up grid first.",
    "storage.no_georeference": "{path} has no georeference, so its windows would have no place on the map.",
    "storage.rotated": "{path} is rotated or mirrored; warp it to a north-up grid first.",
    "storage.not_square": "{path} has pixels of {pixel_x:g} × {pixel_y:g}; resample it to square pixels first.",
    "storage.not_in_meters": (
        "{path} is in {crs}, which does not measure in meters; rasterize or warp it to a projected CRS in meters."
    ),
    "storage.map_in_other_crs": (
        "{path} is in {crs} and the database in {database_crs}; warp the label map to the database’s CRS."
    ),
    "storage.class_called_otherwise": (
        "{path} calls the class {value} “{name}” and the database “{known}”; rasterize the map with the database’s "
        "class table."
    ),
    "storage.pixel_size": "The pixel size is {pixel_size:g} m; it must be more than 0.",
    "storage.too_many_pixels": (
        "The label map would have {width} × {height} pixels; choose larger pixels or a smaller extent."
    ),
    "storage.nothing_to_rasterize": "“{source}” has no polygon with area and class; there is nothing to rasterize.",
    "storage.no_overlap": "The reference and the prediction don't overlap; choose maps of the same ground.",
    "storage.tilted_for_world_file": (
        "{image} was tilted, which a world file can’t tell; write GeoTIFFs or control points instead."
    ),
    "storage.unwritable": "{path} can't be written: {reason}.",
    "storage.no_polygons": "The polygons can’t be made: {reason}.",
    "storage.database_unwritable": "The database can't be written: {reason}.",
    "storage.layer_unwritable": "The layer {name} can't be written: {reason}.",
    "storage.overview_unwritable": "The overview can't be written: {reason}.",
    "storage.no_database": "There is no database {path}; build one or choose another file.",
    "storage.no_database_named": "No database is named; build one or choose a file.",
    "storage.database_damaged": "{path} is damaged or cut short ({reason}); build it again or fetch another copy.",
    "storage.bad_georeference": (
        "{path} has a georeference that no map has ({numbers}); give it its place on the ground anew."
    ),
    "storage.foreign_side_car": (
        "{path} is beside {raster}, but does not hold pixels or metadata of its own, so GDAL would open other files; "
        "remove it."
    ),
    "storage.overviews_elsewhere": (
        "{path} names another file for its overviews ({name}), which SemRef does not open; remove {path}.aux.xml, or "
        "build the overviews again."
    ),
    "storage.database_in_use": "{path} is being written by another program; try again.",
    "storage.database_unfinished": (
        "{path} was left half written by another program and can't be mended where it lies; copy it with the file "
        "{path}-journal or {path}-wal to a place where you may write."
    ),
    "storage.nothing_to_undo": (
        "{path} was changed after the update that {before} belongs to, so that update can't be undone. To go back "
        "further, open {before} itself."
    ),
    "storage.database_changed": "{path} was changed by another program meanwhile; try again.",
    "storage.no_readable_overview": "{path} has no overview that can be read ({reason}); build it again.",
    "storage.no_geopackage": "{path} is not a GeoPackage; choose a database that SemRef built.",
    "storage.foreign_database": (
        "{path} is not a SemRef reference database (it lacks {missing}); choose one that SemRef built."
    ),
    "storage.no_readable_parameter": "{path} has no readable parameter {reason}; build it again.",
    "storage.vector_length": "{path} has vectors that are not {length} numbers long; build it again.",
    "storage.bounds_count": "{path} has {count} landmarks and bounds of {bounds}; build it again.",
    "storage.no_route_file": "There is no file {path}; choose another route.",
    "storage.route_too_large": "{path} is larger than {most_mb} MB; no route is.",
    "storage.plan_not_json": "{path} is no JSON and so no plan of QGroundControl; save the plan again.",
    "storage.plan_without_mission": "{path} has no mission; save it with QGroundControl as a plan.",
    "storage.no_waypoint_list": "{path} is no waypoint list: its first line is not “QGC WPL 110”.",
    "storage.no_waypoint": "{path} has a line that is no waypoint: {line}",
    "storage.waypoint_position": ("{path} has a waypoint at {latitude}, {longitude}, which is no latitude, longitude."),
    "storage.route_not_text": "{path} is no text and so no route; choose another file.",
    "storage.route_unreadable": "{path} can't be read as a route ({reason}).",
    "storage.tiles_need_8_or_16_bits": ("{path} holds {name} values; training tiles are made of 8- or 16-bit images."),
    "storage.has_palette": "{path} has a palette; convert it to an RGB image first.",
    "storage.damaged": "{path} is damaged or cut short: {reason}.",
    "storage.labels_not_georeferenced": (
        "{path} has {size} pixels, the image {image_size}, and not both are georeferenced; give both a place on "
        "the ground, or labels of the image’s size."
    ),
    "storage.labels_not_on_image": "The labels can’t be brought onto the image: {reason}.",
    "storage.labels_out_of_range": ("The labels have the value {found}; a label map holds class values from 0 to 255."),
    "storage.image_without_place": (
        "{path} has no georeference, so polygons can't be laid on it; give a label map of its size, or an image with "
        "its place on the ground."
    ),
    "storage.nothing_labeled": ("No pixel of the image is labeled; check that image and labels show the same ground."),
    "storage.no_subset_tiles": (
        "The labels leave {training} tiles for training and {validation} for validation; choose smaller tiles than "
        "{tile_size} pixels, a smaller stride, or another validation fraction."
    ),
    "storage.complex_numbers": "{path} holds complex numbers; a network takes photos.",
    "storage.unreadable": "{path} can't be read: {reason}.",
    "storage.bands_for_labels": (
        "{path} has {bands} bands; a label map has one: decode its colors to class values first."
    ),
    "storage.no_palette": "{path} has {bands} band(s) and no palette; a color image has three bands.",
    "storage.no_folder": "The folder {folder} does not exist; create it or choose another place for {name}.",
    "storage.is_folder": "{path} is a folder; give a file name.",
    "storage.is_file": "{path} is a file or a link; choose a folder.",
    "storage.other_layers": (
        "{path} holds other layers ({layers}), which would be lost; choose another file, or add to it by “Save to "
        "GeoPackage”."
    ),
    "storage.other_kind": "{path} exists and is another kind of file, which would be lost; choose another name.",
    "storage.older_unreadable": (
        "{path} exists and can't be read ({reason}), so SemRef does not replace it; remove it or choose another name."
    ),
    "storage.stranger_beside": (
        "{path} would be taken for a part of the new {name}, but belongs to another file; remove it or choose another "
        "name."
    ),
    "storage.not_whole": "{path} could not be written whole: {reason}; see whether the disk is full.",
    "storage.folder_not_empty": (
        "The folder {path} holds other files, which are left alone; choose a new or empty one."
    ),
    "storage.folder_unwritable": "The folder {folder} can't be written to; choose another place for {name}.",
    "storage.file_unwritable": "{path} can't be written: {reason}; choose another place.",
    "storage.not_kept_by_update": (
        "{path} was not made by an update of SemRef, and the update would replace it. Move it elsewhere and update "
        "again."
    ),
    "storage.not_replaceable": (
        "{path} can't be replaced; it may be open in this or another program: close or remove it, or choose "
        "another name."
    ),
    "storage.unknown_reason": "unknown reason",
    "storage.unknown_format": "unknown format",
}
