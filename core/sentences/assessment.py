"""What is wrong with the settings of assessing and evaluating."""

SENTENCES = {
    "assessment.range": (
        "{setting} goes from {low:g} to {high:g}; give two numbers from {least:g} to {most:g}, the smaller one first."
    ),
    "assessment.no_window_on_labels": (
        "No window of the database lies on the label map and has {minimum_references} landmarks or more; choose "
        "the label map of the same ground, or a smaller number of landmarks."
    ),
    "assessment.square_edge": "The edge of a square is {size:g}; give it in map units.",
    "assessment.too_many_squares": (
        "The edge of a square is {size:g}, which makes {count} squares of the map; give {least:.3g} or more."
    ),
    "assessment.footprints": (
        "“{text}” is no list of footprints; give edges of the ground in map units, separated by “;”."
    ),
    "assessment.nothing": "{path} has neither labels nor landmarks; build it again.",
    "assessment.reason_too_few": "Too few landmarks: {landmarks:.0f} in view on average.",
    "assessment.reason_look_alikes": "Look-alikes: another place, or the mirrored image, fits almost as well.",
    "assessment.reason_too_loose": (
        "Too little evidence: landmarks ({landmarks:.0f} in view) agree with the map too loosely."
    ),
    "assessment.reason_wrong": "Some fixes would be wrong.",
    "assessment.point_distance": "The distance between points is {spacing:g}; give it in map units.",
    "assessment.route_without_length": "The route has no line with a length; draw one through two points at least.",
    "assessment.too_many_points": (
        "The distance between points is {spacing:g}, which makes {count} points; give {least:.3g} or more."
    ),
    "assessment.footprint": "The footprint is {footprint:g}; give the edge of the ground that an image shows.",
    "assessment.no_landmark": "{source} has no landmark; build it with other classes or a smaller area.",
    "assessment.no_overview": "{source} has no overview, by which flights are simulated; build it with one.",
    "assessment.too_many_flights": (
        "The flights have {count} images together, at most {most} can be simulated; choose fewer flights, or a larger "
        "distance between images."
    ),
    "simulation.noise": "Noise: {name} is {value:g}; give a number from 0 to {most:g}.",
}
