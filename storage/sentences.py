"""What is wrong with files that are read and written here."""

SENTENCES = {
    "storage.labels_not_in_table": (
        "The labels have the value {unknown}, which the class table lacks; its classes are {classes}."
    ),
}
