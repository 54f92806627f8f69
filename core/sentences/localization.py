"""What came of an image, by which method, and why it has no fix."""

from .sentence import Plural

SENTENCES = {
    "localization.status_fix": "Fix",
    "localization.status_ambiguous": "Ambiguous",
    "localization.status_no_match": "No match",
    "localization.status_too_few_references": "Too few landmarks",
    "localization.method_automatic": "Automatic",
    "localization.method_topology_vector": "Topology vector (He & Wu 2025)",
    "localization.method_constellation": "Constellation",
    "localization.method_map_correlation": "Map correlation",
    # Any road
    "localization.too_few_landmarks": "{shown}; {needed}.",
    "localization.shows_landmarks": Plural("The image shows {count} landmark", "The image shows {count} landmarks"),
    "localization.shows_whole_landmarks": Plural(
        "The image shows {count} whole landmark", "The image shows {count} whole landmarks"
    ),
    "localization.network_found": Plural(
        "The network found {count} landmark ({classes})", "The network found {count} landmarks ({classes})"
    ),
    "localization.trained_on": "The network was trained on: {places}.",
    "localization.then": "{first} {second}",
    "localization.one_in": "1 in {count:,.0f}",
    "localization.below_one_in": "below 1 in {count:,.0f}",
    "localization.more_needed": Plural("at least {count} more is needed", "at least {count} more are needed"),
    # Topology vector
    "localization.vector_too_far": "The nearest window has distance {distance:.3f}, more than {threshold:g}.",
    # Constellation
    "localization.no_triangles": "No place on the map has triangles like the image's.",
    "localization.risk_too_high": (
        "The best place (log odds {log_odds:.1f}) has an error probability of {risk:.2g}; "
        "at most {allowed:.2g} is allowed."
    ),
    "localization.one_side_elsewhere": (
        "Landmarks agree with the map on one side of the image only: it may show two places."
    ),
    "localization.one_side_unknown": (
        "In the {part} of the image only {agree} of {count} landmarks agree with the map: new there, off the map, or "
        "of another place. The fix holds for the rest."
    ),
    "localization.one_side_unseen": (
        "In the {part} of the image only {agree} of {count} landmarks of the map are seen: hidden, changed, or another "
        "place. The fix holds for the rest."
    ),
    "localization.left_part": "left part",
    "localization.right_part": "right part",
    "localization.upper_part": "upper part",
    "localization.lower_part": "lower part",
    "localization.rivals": Plural(
        "{count} other place fits almost as well as the best one.",
        "{count} other places fit almost as well as the best one.",
    ),
    "localization.mirror_fits": "The mirrored image fits almost as well, so the pattern is too regular.",
    "localization.position_too_loose": ("The objects that agree with the map don't fix the position closely enough."),
    # Map correlation
    "localization.part_disagrees": (
        "In the {part} of the image the classes hardly agree with the map ({agreement:.2f}, {whole:.2f} in all of it): "
        "changed, mistaken, or another place. The fix holds for the rest."
    ),
    "localization.too_few_classes": "The map has one class everywhere, so that no place differs from another.",
    "localization.too_little_ground": (
        "The image shows too little ground to search this whole map for it; give a prior position."
    ),
    "localization.too_few_labels": (
        "Only {labeled:.0%} of the image have classes of the map; at least {least:.0%} are needed."
    ),
    "localization.hardly_one_class": (
        "The image shows hardly more than one class; a larger footprint with several classes is needed."
    ),
    "localization.nothing_under_image": "No place of the map has labels under at least half of the image.",
    "localization.agreement_too_low": (
        "The best match ({score:.2f}) is not significantly better than chance: error probability {risk:.2g}; "
        "at most {allowed:.2g} is allowed."
    ),
    "localization.mirror_agrees": (
        "The match ({score:.2f}) is not significantly better than for the mirrored image ({mirror:.2f}): error "
        "probability {risk:.2g}; at most {allowed:.2g} is allowed."
    ),
    "localization.two_places_agree": (
        "Two places match almost equally well ({score:.2f} and {runner_up:.2f}): error probability {risk:.2g} for the "
        "better one. Set a prior position to choose between them."
    ),
    "localization.direction_unknown": ("One place agrees, but the image doesn't tell its position in all directions."),
    "localization.map_ends": (
        "One place agrees, but more than half of the image lies beyond the map there, so that its position isn't known."
    ),
    "localization.error_too_large": (
        "One place agrees, but its position is known only within {error_95_m:.3g} m; "
        "an image of this size needs {needed_m:.3g} m."
    ),
    # Both roads
    "localization.areas_speak_against": (
        "Landmarks match one place, but class areas there only by {agreement:.2f}: error probability {risk:.2g}; "
        "at most {allowed:.2g} is allowed."
    ),
    "localization.neither_road": "{constellation} Map correlation has no fix either: {correlation:clause}",
    # What was searched
    "localization.searched": (
        "{reason} Searched: {smallest:.3g}–{largest:.3g} map units a pixel, {headings}, {ground}."
    ),
    "localization.all_headings": "all headings",
    "localization.headings_near": "headings within {spread:g}° of {heading:g}°",
    "localization.whole_map": "the whole map",
    "localization.ground_near": "the ground within {radius:g} of {x:.0f}, {y:.0f}",
    # How exactly
    "localization.radius_of": "What makes the 95 % radius: {parts}.",
    "localization.part_of_radius": "{cause} {radius:.2g} m",
    "localization.cause_landmarks": "noise of single landmarks",
    "localization.cause_areas": "errors of areas",
    "localization.cause_map": "accuracy of the map",
    "localization.cause_view": "lens and tilt",
    "localization.cause_classes": "shifts of whole classes",
    "localization.cause_pixels": "size of the pixels",
    # Flights
    "localization.jump": ("It can’t be reached at {speed:g} map units per second from the fixes before and after it."),
}
