"""Limits of what SemRef reads and computes, each with its reason: files from strangers are untrusted data.

Use as limits.<name>. A value that only makes an algorithm faster or better is not a limit and is defined with it.
"""

from __future__ import annotations

# Texts
NAME_CHARACTERS = 255  # Of a name, a version or a hash: the limit of file systems and of OGR's fields.
TEXT_CHARACTERS = 100_000  # Of any other text, such as a CRS; the longest in EPSG's registry has 30,000.
NUMBER_DIGITS = 64  # Of a whole number in JSON: Python needs quadratic time for longer ones.
JSON_CHARACTERS = 64 << 20  # The block hashes of a map of 900,000 × 900,000 pixels, or a plan of 10⁶ waypoints.
JSON_DEPTH = 32  # Nested lists; SemRef's own files have three levels, QGroundControl's plans eight.
LINE_CHARACTERS = 10_000  # Of a table of classes, rules, cameras or motion; csv itself stops at 131,072 a field.
LINE_BYTES = 4 * LINE_CHARACTERS  # A character has at most four bytes.
RULES = 10_000  # Of a table that classifies OpenStreetMap's features.
TABLE_BYTES = 64_000_000  # Of a table or a text log: ten hours at 100 rows a second have 3.6 million rows.
LOG_BYTES = 1_000_000_000  # Of a binary log: an autopilot writes at most some 20 MB a minute.
LOG_ENTRIES = 200_000  # Of one kind of message: half an hour at 100 a second; above it, every second one is kept.
ROUTE_BYTES = 64 << 20  # Of a file of waypoints: a plan with a million of them.
COMPARISON_BYTES = 64 << 20  # Of a comparison report; its figures are in the head of the page.
METADATA_BYTES = 1_000_000  # Of a layer's metadata in QGIS's format.
SOURCES = 200  # Inputs of a run whose metadata are read; a run can have thousands of photos, without metadata.
STYLE_CHARACTERS = 16 << 20  # Of a layer's style; QGIS writes some thousand for these layers.

# Maps and images
MAP_PIXELS = 1_000_000_000_000  # A country at 1 cm; a pixel size that gives more is a mistake.
EDGE_PIXELS = 1 << 31  # GDAL and OpenCV count pixels along an edge in 32 bits.
WARPED_EDGE_PX = 32_766  # OpenCV warps and samples images with edges shorter than 2¹⁵.
FOCAL_LENGTH_PX = 1e9  # No camera has a longer one.
SIDE_CAR_BYTES = 20_000_000  # Of ``.aux.xml``, from which GDAL builds a tree: attribute tables have some megabytes.
DRAWN_PIXELS = 64_000_000  # Of one drawing of a layer: 8,000 × 8,000 pixels, some thousand tiles of a server.
DRAWING_S = 300.0  # For some twenty tiles; a slower server does not answer usefully.
ANSWER_BYTES = 20_000_000  # Of a server: a tile has 0.1 MB, a map of 1024 × 1024 pixels uncompressed 4 MB.
FRAMES = 100_000  # Images extracted from one video.
IMAGE_PIXELS = 400_000_000  # A query image is processed in memory.
IMAGE_BYTES = 4 * IMAGE_PIXELS  # Size of the largest image uncompressed, in four bands of 8 bits.
TAG_BYTES = 4_000_000  # Of all tags of a file: they may share bytes, and each of 65,535 could claim the whole file.
JPEG_SEGMENTS = 500  # Segments of a JPEG that are read: cameras write tags first.
XMP_BYTES = 500_000  # Of an XMP packet; those of cameras have 5,000.

# Networks
TILE_PX = 8192  # Edge: its three bands as floats are 800 MB, the network's results many times that.
VALUE_CHARACTERS = 100_000  # Of a value of a model's metadata: 255 classes with names of 255 characters each.
BRACKETS = 1000  # In such a value as a Python literal, because Python's parser recurses.
STANDARDIZATION = 1e30  # Of a mean or a deviation; float32 ends at 3e38.
CARD_CHARACTERS = 2000  # Of a sentence of a model card.
CARD_PLACES = 100  # Places that a model card names.
CLASS_BIAS_M = 1000.0  # A network with a larger class offset shows something else.

# Databases and onboard files
WINDOWS = 10_000_000  # Enough for a whole country.
LANDMARKS = 50_000_000  # Enough for a whole country.
OVERVIEW_PIXELS = 1 << 30  # Enough for a whole country.
VECTOR_LANDMARKS = 1000  # Landmarks of a topology vector.
VECTOR_ELEMENT = 1e6  # Elements of a topology vector are shares, a little above 1 for long thin landmarks.
AREA_M2 = 1e15  # Twice the surface of the Earth.
LOG_AREA = 50.0  # ln of an area: areas beyond it are out of range or overflow.
COUNTED = 1 << 31  # Landmarks of a window are a 32-bit number.
LEVELS = 255  # Onboard files store levels as bytes.
UNITS = 1e12  # Map units or square meters of a length or an area.
LENGTH = 1e9  # Map units of a window or a stride; no map is larger.
HEADER_BYTES = 1 << 20  # Of an onboard file's JSON header: 255 classes with names of 255 characters have 0.1 MB.
NPY_HEADER_BYTES = 1024  # Of an array's header in NumPy's format; plain arrays have 128.
STATE_BYTES = 256_000_000  # The state of a flight has some ten images of a few hundred pixels an edge.
LINK_LOG_SCALE = 10.0  # Pixel sizes of two images of a flight differ by at most 1 : 22,000.
HELD_ROWS = 50_000  # Of a growing table: some 30 MB. The oldest rows above it are dropped.
CACHE_BYTES = 16 << 30  # A database of 10⁷ landmarks and 10⁵ km² needs 5 GB. The least recently used files are removed.

# Work
SQUARES = 100_000  # Of an assessment; more take hours and show no more detail.
ROUTE_POINTS = 20_000  # Of a route; more take hours.
FLOWN_IMAGES = 20_000  # Of all simulated flights together; more take days.
FOOTPRINT_M = 100_000.0  # Width of the ground in an image; no aircraft flies high enough to see more.
SIMULATED_EDGE_PX = 2000  # Of a simulated image; a larger footprint gets larger pixels.
THREADS = 256  # More than any onboard computer has; each thread costs memory.
RISK = 0.5  # A position with a higher error probability is more likely wrong than right.
SYSTEMS = 255  # MAVLink numbers aircraft from 1 to this.
