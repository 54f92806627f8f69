"""What is wrong with the parameters of algorithms."""

SENTENCES = {
    "algorithms.no_list_of_numbers": "{key}: “{text}” is not a list of numbers such as 1;2.",
    "algorithms.no_number": "{key} is {number}, which is no number; give one.",
    "algorithms.no_text": "{key} is “{text}”: a path or text has no character of value 0; remove it.",
    "algorithms.too_few_databases": "DATABASES names {count}; choose two or more to use them as one.",
    "algorithms.no_set_name": "{output} can't be known as a set of databases; give a name that ends in {suffix}.",
    "algorithms.no_images": "IMAGES is empty; choose at least one image, a folder with images, or a LAYER.",
    "algorithms.part_of_no_layer": (
        "LAYER is empty, so {keys} can't be a part of it; choose a LAYER, or leave {keys} out."
    ),
    "algorithms.odometry_of_other_images": (
        "{path} tells no motion between two of these images, such as {image}; give the ODOMETRY of this flight."
    ),
    "algorithms.log_of_other_images": (
        "The LOG tells nothing of these images, such as {image}: neither by name nor at the times that they were "
        "taken; give the log of this flight, or a camera table with times."
    ),
    "algorithms.image_elsewhere": (
        "The positions name {path}, which is not in their own folder; select the image, or its folder, as Images."
    ),
    "algorithms.image_moved": "There is no image {path}; give IMAGES, the folder where it lies now.",
    "algorithms.no_route_layer": (
        "ROUTE is {value}, which is neither a line layer nor a GPX, KML, .plan or .waypoints file."
    ),
    "algorithms.route_outside_map": "ROUTE lies outside the database’s map; choose another route or database.",
    "algorithms.not_replaced": "{output} exists and is no onboard file; remove it or choose another name.",
    "algorithms.labels_in_other_crs": (
        "The label map is in {crs}, the database in {database_crs}; rasterize to the database's CRS or build a new "
        "database."
    ),
    "algorithms.other_classes": (
        "The label map and the database don't have the same classes ({value} {name} is in one of them only); "
        "rasterize with the database's class table or build a new database."
    ),
    "algorithms.changed_area_crs": (
        "{key}: the area of feature {feature} can't be brought to the label map's CRS; check the layer's CRS."
    ),
    "algorithms.changed_without_polygon": "{key} has no polygon; leave it out to find the changes by comparing.",
    "algorithms.annotation_or_labels": "Give either an annotation layer (INPUT) or a label map (LABELS).",
    "algorithms.no_class_field": "Choose the class field of the polygons, or enter the one class that all of them are.",
    "algorithms.training_runs": (
        "{path} is being trained already; wait for that training, cancel it, or choose another file."
    ),
    "algorithms.other_training": (
        "{folder} holds a canceled training with another {settings}; give the same again, choose another OUTPUT, or "
        "turn RESUME off to begin anew."
    ),
    "algorithms.no_openstreetmap_class": (
        "No polygon of “{source}” has a tag that the rules know; its columns are {columns}. Choose a layer with "
        "OpenStreetMap's tags, other RULES, or an OTHER_CLASS."
    ),
    "algorithms.openstreetmap_unreadable": "“{source}” can't be read to its end: {reason}. Copy or download it again.",
    "algorithms.nothing_to_repair": "“{source}” has no polygon with area and class; there is nothing to repair.",
    "algorithms.no_class_table": "Give DATABASE or CLASS_TABLE: the label image brings no class table of its own.",
    "algorithms.no_model_to_copy": "MODEL_OUTPUT is a copy of the model; give the network as MODEL.",
    "algorithms.bias_without_meters": (
        "The maps have no metric CRS, so the bias of classes is not known in meters; give maps that have one, or leave "
        "MODEL_OUTPUT empty."
    ),
    "algorithms.no_bias": (
        "No class of {path} has enough landmarks in both maps to tell its bias; give a larger area, or leave "
        "MODEL_OUTPUT empty."
    ),
    "algorithms.no_comparison": (
        "{path} is no report of “Compare label maps” that tells of landmarks; run that with REPORT and give its page "
        "as COMPARISON."
    ),
    "algorithms.few_compared": (
        "{path} compares {count} landmarks, and fewer than {least} tell little of a network; compare a larger area, or "
        "leave COMPARISON empty."
    ),
    "algorithms.no_methods": "METHODS is empty; choose at least one method.",
    "algorithms.stride_above_size": (
        "The stride ({stride:g}) is larger than the window ({size:g}), so ground between the windows would be "
        "missed; make the stride at most the window size."
    ),
    "algorithms.scales": (
        "The smallest scale ({smallest:g}) is above the largest ({largest:g}); give both, the smaller first."
    ),
}
