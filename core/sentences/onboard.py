"""What is wrong with an onboard file, or with how the command line is called."""

SENTENCES = {
    "onboard.threads": "--threads is {threads}; it must be from 1 to {most}.",
    "onboard.near": "--near is {near}; it must be three numbers up to {most:g}.",
    "onboard.near_radius": "The radius of --near is {radius:g}; it must be more than 0 map units.",
    "onboard.sun": "--sun is {sun:g}; it must be a direction from 0 to 360 degrees.",
    "onboard.risk": "--risk is {risk:g}; it must be a probability from {least:g} to {most:g}.",
    "onboard.no_overview": "{database} has no overview, which map correlation searches; export it with one.",
    "onboard.no_overview_for_flights": (
        "{database} has no overview, by which tracks are told apart; export it with one."
    ),
    "onboard.state_without_flight": "Only of a flight is a state kept: add --flight, or leave --state out.",
    "onboard.odometry_without_flight": "Only of a flight is motion told: add --flight, or leave --odometry out.",
    "onboard.no_flight_state": "{path} is no state of a flight that this SemRef wrote, or is damaged.",
    "onboard.state_not_ours": (
        "{path} was not written with the key of this flight (--require-signature, otherwise the secret of this user), "
        "or was changed since."
    ),
    "onboard.no_state_folder": "The folder {folder} of --state {path} does not exist; create it or choose another one.",
    "onboard.state_no_file": "--state {path} is not a regular file; choose another name.",
    "onboard.state_of_another_kind": (
        "--state {path} is a file of another kind, which would be replaced; choose another name."
    ),
    "onboard.no_private_folder": (
        "There is no private folder for the secret that --state is authenticated with; set up a home folder for this "
        "user, or add --require-signature."
    ),
    "onboard.state_of_other_database": "{path} is the state of a flight in another database.",
    "onboard.no_folder": "There is no folder {folder}; create it or watch another one.",
    "onboard.no_lon_lat": "{database} can't tell longitude and latitude, which GGA sentences and MAVLink need.",
    "onboard.folder_gone": "The folder {folder} can't be looked into ({reason}); start again when it can.",
    "onboard.unwritable": "{where} can't be written: {reason}; choose another place.",
    "onboard.no_udp_port": "“{where}” is no UDP port of this computer; write udp:PORT, with PORT from 1 to 65535.",
    "onboard.no_mavlink_place": (
        "“{where}” is no place for MAVLink; write udp:PORT, udp:HOST:PORT, serial:DEVICE or serial:DEVICE:BAUD."
    ),
    "onboard.mavlink_system": "--mavlink-system is {system}; it must be from 1 to {most}.",
    "onboard.mavlink_origin": (
        "--mavlink-origin is {latitude:g} {longitude:g}; it must be a latitude and a longitude in degrees."
    ),
    "onboard.camera_yaw": "--camera-yaw is {yaw:g}; it must be an angle of at most 360 degrees.",
    "onboard.package_missing": "{option} needs the Python package {package}; install it: pip install {package}.",
    "onboard.no_file": "There is no file {path}; export one or choose another.",
    "onboard.unreadable": "{path} can't be read: {reason}.",
    "onboard.foreign": "{path} is no onboard file of SemRef; choose one that SemRef exported.",
    "onboard.unsigned": "{path} is not signed; export it with the key {key}, or leave the key out.",
    "onboard.wrong_signature": (
        "{path} was not signed with the key {key}, or was changed since; fetch it again from where it was exported."
    ),
    "onboard.key_unreadable": "The key {path} can't be read: {reason}.",
    "onboard.key_length": "The key {path} has {size} bytes; a key has {least} to {most} random ones.",
    "onboard.newer_format": (
        "{path} has onboard format version {version}, newer than this SemRef reads ({known}); update SemRef's core "
        "folder on this computer."
    ),
    "onboard.no_landmark_in_area": (
        "No landmark lies in the area; choose another area or a larger distance around it."
    ),
    "onboard.precision": "The precision is {precision:g}; it must be more than 0 map units.",
    "onboard.class_table_changed": "The class table of {source} was changed after it was built; build it again.",
    "onboard.header_too_long": "The header would have {size} bytes, more than {most}.",
    "onboard.nothing_to_export": "There is no landmark to export; choose another database or a larger area.",
    "onboard.precision_too_fine": (
        "The precision of {precision:g} map units is too fine for the map; choose a larger one."
    ),
    "onboard.landmark_without_area": "A landmark has no area; build the database again.",
    "onboard.window_sizes": "The windows' sizes are not those of their levels; build the database again.",
    "onboard.damaged": (
        "{path} is damaged, cut short or no onboard file of SemRef ({reason}); fetch another copy or export it again."
    ),
    "onboard.lacks": (
        "{path} is damaged, cut short or no onboard file of SemRef ({name} is missing); fetch another copy or "
        "export it again."
    ),
    "onboard.the_database": "the database",
}
