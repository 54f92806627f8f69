"""What is wrong with a camera's attitude, or with the size of windows."""

SENTENCES = {
    "geometry.attitude": "A camera with a {name} of {value:g}° does not look at the ground; 0° is straight down.",
    "geometry.gimbal_pitch": "A gimbal pitch of {pitch_deg:g}° does not look at the ground; −90° is straight down.",
    "geometry.focal_length": "The focal length is {focal_length_px:g} pixels; it must be above 0, up to {most:g}.",
    "geometry.near_horizon": (
        "With roll {roll_deg:g}° and pitch {pitch_deg:g}° a corner of the image looks {steepest:.0f}° away from "
        "straight down, more than {most_deg:g}° and too near the horizon; use images that look down more steeply."
    ),
    "geometry.leveled_too_large": (
        "The image has {width} × {height} pixels and {level_width} × {level_height} when leveled, but an edge may "
        "have {most} at most; reduce it first."
    ),
    "windows.below_one_pixel": (
        "Window size ({size} px) and stride ({stride} px) must be at least one pixel; enlarge them."
    ),
    "windows.stride_above_size": (
        "The stride ({stride} px) is larger than the window ({size} px), so ground between the windows would be "
        "missed; make the stride at most the window size."
    ),
    "windows.larger_than_map": (
        "The window ({size} px) is larger than the map ({width} × {height} px); choose a smaller window or a "
        "larger map."
    ),
}
