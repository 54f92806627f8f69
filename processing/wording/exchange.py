"""What is wrong with layers, rasters and files that algorithms read and write."""

SENTENCES = {
    "exchange.unknown_classes": (
        "“{source}” has classes that the class table does not have: {unknown}; add them to the table ({classes}) or "
        "leave those features out."
    ),
}
