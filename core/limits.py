"""Limits of what SemRef reads and computes, each with its reason: files of strangers are data.

Use as limits.<name>. What an algorithm does better with is no limit and stays beside it.
"""

from __future__ import annotations

# Texts
NAME_CHARACTERS = 255  # Of a name, a version or a hash: what file systems and OGR's fields hold as well.
TEXT_CHARACTERS = 100_000  # Of any other text, such as a CRS; the longest of EPSG's has 30,000.
NUMBER_DIGITS = 64  # Of a whole number in JSON: Python needs quadratic time for longer ones.
JSON_CHARACTERS = 64 << 20  # The block hashes of a map of 900,000 × 900,000 pixels, or a plan of 10⁶ waypoints.
JSON_DEPTH = 32  # Lists in lists; SemRef's own have three, QGroundControl's plans eight.
LINE_CHARACTERS = 10_000  # Of a table of classes, rules, cameras or motion; csv itself stops at 131,072 a field.
LINE_BYTES = 4 * LINE_CHARACTERS  # A character has four bytes at most.
RULES = 10_000  # Of a table that classifies OpenStreetMap's features.
TABLE_BYTES = 64_000_000  # Of a table or a text log: ten hours at 100 rows a second have 3.6 million rows.
LOG_BYTES = 1_000_000_000  # Of a binary log: an autopilot's card writes some 20 MB a minute at most.
LOG_ENTRIES = 200_000  # Of a kind of messages: half an hour at 100 a second; of more every second one is kept.
ROUTE_BYTES = 64 << 20  # Of a file of waypoints: a plan of a million of them.
COMPARISON_BYTES = 64 << 20  # Of a report of a comparison, whose figures are in its head.
METADATA_BYTES = 1_000_000  # Of a layer's metadata in QGIS's form.
SOURCES = 200  # Inputs of a run whose metadata are read: photos, of which there are thousands, have none.
STYLE_CHARACTERS = 16 << 20  # Of a layer's style; QGIS's own for these layers have some thousand.

# Maps and images
MAP_PIXELS = 1_000_000_000_000  # Beyond this a pixel size is taken for a mistake: a country at 1 cm.
EDGE_PIXELS = 1 << 31  # Pixels along an edge of a map are 32-bit numbers in GDAL and OpenCV.
WARPED_EDGE_PX = 32_766  # OpenCV warps and samples images with edges shorter than 2¹⁵.
FOCAL_LENGTH_PX = 1e9  # A camera with a longer one sees nothing.
SIDE_CAR_BYTES = 20_000_000  # Of ``.aux.xml``, of which GDAL builds a tree: attribute tables take some megabytes.
DRAWN_PIXELS = 64_000_000  # Of one drawing of a layer: 8,000 × 8,000 pixels, some thousand tiles of a server.
DRAWING_S = 300.0  # For some twenty tiles; a server that takes longer sends nothing of use.
ANSWER_BYTES = 20_000_000  # Of a server: a tile has 0.1 MB, a map of 1024 × 1024 pixels uncompressed 4 MB.
FRAMES = 100_000  # Images that are written of one video.
IMAGE_PIXELS = 400_000_000  # A query image is held in memory.
IMAGE_BYTES = 4 * IMAGE_PIXELS  # What the largest image has uncompressed, in four bands of 8 bits.
TAG_BYTES = 4_000_000  # Of all tags of a file: they may share bytes, 65,535 could claim the whole file each.
JPEG_SEGMENTS = 500  # Of a JPEG that are looked at: cameras write tags first.
XMP_BYTES = 500_000  # Of an XMP packet that are kept; those of cameras have 5,000.

# Networks
TILE_PX = 8192  # Edge: its three bands as floats are 800 MB, the network's results many times that.
VALUE_CHARACTERS = 100_000  # Of a value of a model's metadata: 255 classes with names of 255 characters each.
BRACKETS = 1000  # In such a value as a Python literal, whose parser recurses.
STANDARDIZATION = 1e30  # Of a mean or a deviation; float32 ends at 3e38.
CARD_CHARACTERS = 2000  # Of a sentence of a model's card.
CARD_PLACES = 100  # That a model's card names.
CLASS_BIAS_M = 1000.0  # A network that is farther off sees something else.

# Databases and onboard files
WINDOWS = 10_000_000  # The whole of a country fits.
LANDMARKS = 50_000_000  # The whole of a country fits.
OVERVIEW_PIXELS = 1 << 30  # The whole of a country fits.
VECTOR_LANDMARKS = 1000  # That a topology vector may hold.
VECTOR_ELEMENT = 1e6  # Elements of a topology vector are shares, some way beyond 1 for long thin landmarks.
AREA_M2 = 1e15  # Twice the surface of the Earth.
LOG_AREA = 50.0  # ln of an area: beyond it areas leave their range, or overflow.
COUNTED = 1 << 31  # Landmarks of a window are a 32-bit number.
LEVELS = 255  # Levels are bytes on board.
UNITS = 1e12  # Map units or square meters of a length or an area.
LENGTH = 1e9  # Map units of a window or a stride; no map is larger.
HEADER_BYTES = 1 << 20  # Of an onboard file's header in JSON: 255 classes with names of 255 characters have 0.1 MB.
NPY_HEADER_BYTES = 1024  # Of an array's header in NumPy's format; plain arrays have 128.
STATE_BYTES = 256_000_000  # A flight's state has some ten images at a few hundred pixels an edge.
STATE_NUMBER = 1e12  # No number of a state is larger: meters, their squares, logarithms, pixels.
LINK_LOG_SCALE = 10.0  # No two images of a flight differ more in the size of their pixels than 1 : 22,000.
HELD_ROWS = 50_000  # Of a growing table: some 30 MB. Of a longer one the oldest are forgotten.
CACHE_BYTES = 16 << 30  # A database of 10⁷ landmarks and 10⁵ km² needs 5 GB. The files used last remain.

# Work
SQUARES = 100_000  # Of an assessment; more take hours and show no more.
ROUTE_POINTS = 20_000  # Of a route; more take hours.
FLOWN_IMAGES = 20_000  # Of all simulated flights together; more take days.
SIMULATED_EDGE_PX = 2000  # Of a simulated image; a larger footprint is shown with larger pixels.
THREADS = 256  # More than any computer on board has; each costs memory before it does anything.
RISK = 0.5  # A place that is more likely wrong than right is no fix.
SYSTEMS = 255  # MAVLink counts aircraft from 1 to this.
