"""What is said of a flight, its links and its tracks."""

SENTENCES = {
    "flight.link_order": "A link leads from image {first} to image {second}; the second must come after the first.",
    "flight.link_numbers": "The motion from image {first} to image {second} has numbers that are none.",
    "flight.link_covariance": "The deviations of the motion from image {first} to image {second} are none.",
    "flight.no_image": "{name} is no label image: it has no pixels, or several bands.",
}
