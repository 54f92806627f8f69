"""Sentences of what all algorithms share."""

SENTENCES = {
    "framework.scheduler": (
        "{key} is “{text}”; give local: and a number of processes, such as local:4, or the address of a scheduler, "
        "such as tcp://10.0.0.5:8786."
    ),
    "framework.drawn_layer": "QGIS draws this layer, workers can't; choose a raster file, or leave SCHEDULER out.",
    "framework.not_scheduled": "{keys} can't be used together with SCHEDULER; leave them or SCHEDULER out.",
    "inspection.not_editable": (
        "The layer {layer} can't be edited; save it as a GeoPackage and choose that as the annotation."
    ),
    "inspection.elsewhere": (
        "“{layer}” lies outside the map of {name}; choose the annotation and the places that belong to this database."
    ),
    "framework.not_written": "{name} can't be written; choose another place, or see whether the disk is full.",
    "framework.output_is_input": (
        "“{output}” is the same file as “{input}”, {path}, which would be lost; choose another place for “{output}”."
    ),
    "framework.layer_as_output": (
        "“{output}” is {path}, which names a layer of a file; choose a file, or add a layer by “Save to GeoPackage”."
    ),
    "framework.same_output": "“{output}” and “{other}” are the same file, {path}; choose two files.",
}
