"""What is wrong with a class table, a label map or an image."""

SENTENCES = {
    "labels.no_pixels": "The image has no pixels.",
    "labels.class_value_out_of_range": "Class “{name}” has the value {value}; class values go from 0 to {most}.",
    "labels.class_without_name": "The class with value {value} has no name; give it one.",
    "labels.class_color": "Class “{name}” has the color “{color}”; write it as #rrggbb.",
    "labels.class_role": "Class “{name}” has the role “{role}”; it must be “{reference}” or “{background}”.",
    "labels.class_unlabeled_reference": (
        "Class “{name}” has the value 0, which means unlabeled; it can't be a reference."
    ),
    "labels.class_hsv_half": "Class “{name}” has only one of hsv_min and hsv_max; give both or none.",
    "labels.class_repeated": "The class table has the {column} {repeated} more than once.",
    "labels.no_such_class": "There is no class “{text}”; the classes are {classes}.",
    "labels.no_reference_class": (
        "No class is a reference class; choose at least one of {classes} as one, or give it the role “reference” in "
        "the class table."
    ),
    "labels.class_table_empty": (
        "{source} has no classes; it needs a header value,name,color,role and a line a class."
    ),
    "labels.class_table_lacks_column": "{source} lacks the column {missing}; its header is “{header}”.",
    "labels.too_many_classes": (
        "There are {count} classes, but a label map holds {most}; choose another class field, or merge classes "
        "with a class table."
    ),
    "labels.class_value_not_whole": "{where}: “{text}” is not a whole number for value.",
    "labels.class_order_not_number": "{where}: “{text}” is not a number for draw_order.",
    "labels.class_order_not_finite": "The class {name} has a draw_order that is no number; give one such as 3.",
    "labels.class_name_too_long": (
        "The class {value} has a name of more than {most} characters; give it a shorter one."
    ),
    "labels.class_table_line_too_long": (
        "{source} has a line of more than {most} characters, which no class table has; choose another file."
    ),
    "labels.at_line": "{where}: {fault}",
    "labels.class_hsv": "{where}: “{text}” is not “h s v” in OpenCV's ranges (h 0–180, s and v 0–255).",
    "labels.other_kind": (
        "{path} is named as {named}, but it is {found}; give it the suffix {suffix}, or export it again."
    ),
    "labels.unknown_image_format": "{path} is neither PNG nor TIFF nor JPEG; save the label image as PNG.",
    "labels.damaged": "{path} is damaged or cut short; copy it again.",
    "labels.color_not_8_bits": "{path} holds {kind} values; a color label image has 8 bits a band.",
    "labels.not_whole_numbers": "{path} holds {kind} values; a label map holds whole numbers from 0 to 255.",
    "labels.value_out_of_range": "{path} has the value {found}; a label map holds class values from 0 to 255.",
    "labels.photo_not_8_bits": "{path} holds {kind} values; a photo has 8 bits a band: convert it first.",
    "labels.folder_without_images": "The folder {path} holds no image ({endings}).",
    "labels.image_unreadable": "Image {path} can't be read: {reason}.",
    "labels.no_regular_file": "Image {path} is no regular file but a folder, pipe or device; choose an image file.",
    "labels.file_too_large": (
        "Image {path} has {size_mb} MB, more than a query image may have ({most_mb} MB); cut it to what one photo "
        "shows."
    ),
    "labels.image_not_decoded": (
        "Image {path} can't be read: it is damaged, cut short or of a kind that OpenCV does not know."
    ),
    "labels.image_too_large": (
        "{path} has {width} × {height} pixels, more than a query image may have ({most_million} million); cut it "
        "to what one photo shows."
    ),
    "labels.two_bands": "{path} has 2 bands; a label map has one: save it without transparency.",
    "labels.palette_bits": "{path} is a paletted TIFF of {bits} bits a pixel; save it with 8, or as PNG.",
    "labels.smaller_than_tile": (
        "The image has {width} × {height} pixels, less than a tile of {tile_size} pixels; choose a smaller tile."
    ),
    "labels.nothing_in_common": (
        "The maps have no pixel in common that the reference labels; choose maps of the same ground."
    ),
    "labels.no_color_ranges": (
        "No class has hsv_min and hsv_max; add them to the class table or decode by nearest color."
    ),
    "labels.rules_unreadable": (
        "{source} is no table of rules: it needs a header key,value,class,priority, then 1 to {most} lines of at most "
        "{longest} characters."
    ),
    "labels.name_too_long": "{key} has more than {most} characters; give a shorter name.",
    "labels.rules_lack_column": "{source} lacks the column {missing}; its header is “{header}”.",
    "labels.rule_without_tag": "{where}: a rule needs a key and a value; * stands for any value.",
    "labels.rule_class_too_long": "{where}: the class has a name of more than {most} characters; give a shorter one.",
    "labels.rule_priority": "{where}: “{text}” is not a whole number for priority.",
    "labels.unknown_classes": (
        "“{source}” has classes that the class table does not have: {unknown}; add them to the table ({classes}) or "
        "leave those features out."
    ),
    "labels.no_class_filled": "“{source}” has no feature with a class; fill its class field first.",
    "labels.and_more": "{shown} and {count} more",
    "labels.line": "{source}, line {line}",
}
