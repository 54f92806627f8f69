"""Sentences of what all algorithms share."""

SENTENCES = {
    "inspection.elsewhere": (
        "“{layer}” lies outside the map of {name}; choose the annotation and the places that belong to this database."
    ),
    "framework.not_written": "{name} can't be written; choose another place, or see whether the disk is full.",
    "framework.output_is_input": (
        "“{output}” is the same file as “{input}”, {path}, which would be lost; choose another place for “{output}”."
    ),
    "framework.same_output": "“{output}” and “{other}” are the same file, {path}; choose two files.",
}
