"""What is said of a flight, its links and its tracks."""

SENTENCES = {
    "flight.link_order": "A link leads from image {first} to image {second}; the second must come after the first.",
    "flight.link_numbers": "The motion from image {first} to image {second} has numbers that are none.",
    "flight.link_covariance": "The deviations of the motion from image {first} to image {second} are none.",
    "flight.no_image": "{name} is no label image: it has no pixels, or several bands.",
    # Motion from pixels
    "flight.no_photo": "This is no photo or label image of 8 bits: its pixels are {shape} of {kind}.",
    "flight.no_texture": "One of the two images shows nothing that could be found in the other one.",
    "flight.no_common_motion": "Nothing in the two images tells a common motion; they may show different ground.",
    "flight.overlap_disagrees": (
        "Where the two images would overlap, only {agreeing} of {cells} pieces of ground look alike."
    ),
    # Tables and logs
    "flight.no_file": "{path} is no file; choose a table or a log.",
    "flight.file_too_large": "{path} is larger than {most_mb} MB, which no table or log that is read here is.",
    "flight.unreadable": "{path} can't be read: {reason}.",
    "flight.not_utf8": "{path} is not text in UTF-8; save it as CSV in UTF-8.",
    "flight.line_too_long": "{path} has a line of more than {most} characters; choose another file.",
    "flight.no_such_table": "{path} begins with “{first}”, but its header needs the columns {columns}.",
    "flight.not_a_number": "{place}: {name} is “{text}”, which is not a number.",
    "flight.out_of_range": "{place}: {name} is {value:g}, but it must lie between {least:g} and {most:g}.",
    "flight.no_image_named": "{place}: no image is named; give each image one line.",
    "flight.image_named_twice": "{place}: the image {image} is named a second time; give each image one line.",
    # Camera tables
    "flight.cameras_of_other_images": (
        "{path} names none of the images, for example {image}; its column image holds their file names."
    ),
    "flight.no_camera_table": (
        "{path} is no camera table: its header is “{first}”, but it needs the column image and some of {columns}."
    ),
    "flight.times_mixed": "{path} has times in seconds and times with dates; use one of them throughout.",
    "flight.roll_without_pitch": "{place}: roll or pitch is empty; give both, or neither.",
    "flight.lens_twice": "{place}: {kinds} say the same thing twice; give one of them.",
    "flight.lens_impossible": "{place}: {kind} is {value:g}, which no camera has.",
    "flight.no_time": ("{place}: time is “{text}”; give seconds, or a date and time such as 2025-06-30T14:05:09.250."),
    # The joint answer
    "flight.link_of_no_image": "A link leads to image {second}, but the flight has {count} images.",
    "flight.no_state": "The saved state of the flight can't be read.",
    "flight.state_version": "The saved state of the flight is of version {version}; this version reads {known}.",
    "flight.undecided": (
        "The flight so far does not tell where it is: the best track is wrong with a probability of {risk:.2g}; "
        "at most {allowed:.2g} is allowed."
    ),
    "flight.too_loose": (
        "The flight goes on, but where this image lies is known to {radius:.0f} m only, and it shows {edge:.0f} m."
    ),
    "flight.no_log": "{path} is no flight log that SemRef reads; it reads {kinds}.",
    "flight.empty_log": "{path} tells neither heading nor height nor speed of a flight.",
    # Video
    "flight.frame_step": "An image every {every:g} s can't be had of a video; choose {least:g} to {most:g} s.",
    "flight.no_video": "{path} is no video that can be read; choose an MP4, MOV, MKV, AVI or MPEG file.",
    "flight.no_frames": "{path} has no frames that can be read.",
    "flight.frame_exists": "{path} is there already; choose another folder.",
    "flight.frame_unwritable": "{path} can't be written: {reason}.",
}
