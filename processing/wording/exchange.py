"""What is wrong with layers, rasters and files that algorithms read and write."""

SENTENCES = {
    "exchange.no_common_ground": (
        "{image} and {labels} show different ground; choose an image and labels of the same place, and check their CRS "
        "and the extent."
    ),
    "exchange.clip_crs": "CLIP does not fit its CRS {crs}; correct the CRS.",
    "exchange.clip_outside": (
        "The area of CLIP is empty or lies outside the database’s map; choose another one, or for lines and points "
        "a larger DISTANCE than {distance:g}."
    ),
    "exchange.mask_crs": "MASK does not fit its CRS {crs}; correct the CRS.",
    "exchange.mask_outside": "No polygon of MASK lies on the image; choose another layer, or leave MASK out.",
    "exchange.mask_without_place": "The image has no place on the ground that MASK could be laid on; leave MASK out.",
    "exchange.not_a_file": "“{layer}” comes from {provider}; save it as GeoTIFF first.",
    "exchange.two_crs": (
        "REFERENCE is in {crs}, but PREDICTED is in {predicted_crs}; warp one of them to the other's CRS."
    ),
    "exchange.no_crs": "{path} has no coordinate reference system; assign a metric one to the layer.",
    "exchange.no_readable_crs": "{path} has no readable parameter crs; build it again.",
    "exchange.annotation_without_crs": (
        "The annotation layer has no coordinate reference system; set one in the layer's properties."
    ),
    "exchange.target_not_in_meters": (
        "{crs} does not measure in meters; choose a projected CRS in meters as TARGET_CRS."
    ),
    "exchange.extent_outside_crs": (
        "The layer's extent does not fit its CRS {crs}; correct the CRS or choose TARGET_CRS."
    ),
    "exchange.route_without_crs": "ROUTE has no CRS; set its layer's CRS.",
    "exchange.route_outside_crs": "ROUTE does not fit its CRS {crs}; correct the CRS.",
    "exchange.no_route": "{name} has no route: no line, and fewer than two waypoints; choose another one.",
    "exchange.no_vector_layer": "INPUT is not a vector layer that can be read; choose a polygon layer.",
    "exchange.no_polygons": "“{layer}” holds {kind} geometry; an annotation layer holds polygons.",
    "exchange.priority_not_numbers": (
        "The priority field “{priority_field}” does not hold numbers; choose one that does."
    ),
    "exchange.no_field": "{key}: “{layer}” has no field “{name}”; its fields are {names}.",
    "exchange.no_results": "{path} holds no results of “Localize images”; localize the images again.",
    "exchange.no_positions": (
        "{key}: “{source}” lacks {missing}; choose what “Localize images” wrote, with all its columns."
    ),
    "exchange.positions_in_degrees": (
        "{key}: “{source}” is in {crs}, which does not measure in meters; take the positions as “Localize images” "
        "wrote them, in the database’s CRS."
    ),
    "exchange.other_run": (
        "{key}: “{source}” is in {crs}, but the positions are in {positions_crs}; take the layers of one run of "
        "“Localize images”."
    ),
    "exchange.extent_needed": (
        "“{layer}” has no edges of its own to go by; give EXTENT, the ground that is wanted of it."
    ),
    "exchange.resolution_needed": "“{layer}” can be drawn at any resolution; give RESOLUTION.",
    "exchange.resolution_unknown": (
        "“{layer}” can be drawn at any resolution, and {model} does not say its own; choose a model that does."
    ),
    "exchange.extent_not_drawn": "The extent for “{layer}” does not fit its CRS {crs}; choose another one.",
    "exchange.drawing_too_large": (
        "“{layer}” would be drawn with {width} × {height} pixels, which is more than {most_million} million; choose a "
        "smaller EXTENT, or get the image as a file from whoever offers it."
    ),
    "exchange.answer_too_large": (
        "The server of “{layer}” answered with more than {most_mb} MB for one tile; SemRef stopped reading it."
    ),
    "exchange.redirected_elsewhere": (
        "The server of “{layer}” redirects to {address}; SemRef reads tiles over http and https only."
    ),
    "exchange.drawing_too_slow": (
        "The server of “{layer}” took longer than {most_s} s for one part; try again later or choose another layer."
    ),
    "exchange.not_drawn": "“{layer}” can’t be drawn: {reason}.",
    "exchange.nothing_drawn": (
        "Nothing of “{layer}” shows in the extent: there is no ground of it, or its server does not answer."
    ),
    "exchange.extent_outside_image": "EXTENT does not touch “{image}”; choose a part of it.",
    "exchange.extent_without_place": (
        "“{image}” has no georeference, or a turned one, so EXTENT can’t be found on it; leave EXTENT out."
    ),
    "exchange.no_database_layers": (
        "{path} is not a SemRef reference database; choose one made by “Build reference database”."
    ),
    "exchange.no_extent": "{layer} has places that are no numbers; remove the features that have them.",
    "exchange.not_shown": "{image} can’t be shown on the map.",
    "exchange.no_label_map": "{key} is not a raster that can be read; choose a label map.",
    "exchange.no_image": "{key} is not a raster that can be read; choose a photo or an orthophoto.",
}
