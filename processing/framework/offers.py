"""Parameters that several algorithms have: one place each for key, title and what they accept."""

from __future__ import annotations

from ..compat import SOURCE_POLYGON
from ..translation import tr
from .declarations import (
    CLASS_FIELD_WIDGET,
    CLASS_NAME_WIDGET,
    CLASS_TABLE_WIDGET,
    DATABASE_WIDGET,
    MODEL_WIDGET,
    OPEN_WIDGET,
    Choice,
    FieldOf,
    File,
    FileOutput,
    MapExtent,
    Number,
    Parameter,
    RasterLayer,
    Switch,
    Text,
    VectorSource,
)

DATABASE, MODEL, LABELS, IMAGES = "DATABASE", "MODEL", "LABELS", "IMAGES"
INPUT, CLASS_FIELD, CLASS = "INPUT", "CLASS_FIELD", "CLASS"
PRIORITY_FIELD, CLASS_TABLE = "PRIORITY_FIELD", "CLASS_TABLE"
REFERENCE_CLASSES, REPORT, SEED = "REFERENCE_CLASSES", "REPORT", "SEED"
VALIDATION_FRACTION = "VALIDATION_FRACTION"
EXTENT, MASK, RESOLUTION = "EXTENT", "MASK", "RESOLUTION"
SUN_DIRECTION = "SUN_DIRECTION"
MISSED, INVENTED, MISNAMED, RAGGED = "MISSED", "INVENTED", "MISNAMED", "RAGGED"
BACKGROUND, DISPLACED, SHIFTED, LEANING = "BACKGROUND", "DISPLACED", "SHIFTED", "LEANING"
LENS, TILT = "LENS", "TILT"
OPEN_OUTPUT = "OPEN_OUTPUT"
NETWORK = "NETWORK"
COMPARISON = "COMPARISON"

NETWORK_FACTORS = (None, 0.5, 1.0, 2.0)
"""By option of NETWORK: multiplies what is assumed of a network; None leaves it to the numbers that are given."""

OF_NETWORKS = (MISSED, INVENTED, MISNAMED, RAGGED, BACKGROUND, SHIFTED)
"""The errors that are a network's; the others are the map's and the camera's."""


def database(text: str = "", optional: bool = False) -> File:
    """A reference database; ``text``: its help where another one is needed."""
    text = text or tr("A GeoPackage made by “Build reference database”.")
    kinds = tr("Reference databases (*.gpkg)")
    return File(DATABASE, tr("Reference database"), text, optional, filter=kinds, widget=DATABASE_WIDGET)


def label_map(text: str) -> RasterLayer:
    """A label map."""
    return RasterLayer(LABELS, tr("Label map"), text)


def class_table(text: str, optional: bool = True, advanced: bool = False) -> File:
    """A class table."""
    csv = tr("CSV files (*.csv)")
    return File(CLASS_TABLE, tr("Class table"), text, optional, advanced, filter=csv, widget=CLASS_TABLE_WIDGET)


def model(text: str, optional: bool = False) -> File:
    """A segmentation network."""
    return File(MODEL, tr("Model"), text, optional, filter=tr("ONNX models (*.onnx)"), widget=MODEL_WIDGET)


def open_output() -> Switch:
    """Whether a database is opened in QGIS when it is written; dialogs suggest it, scripts and batches don't."""
    title = tr("Open the database after running")
    text = tr("Adds the database’s layers to the project and chooses it in the dock.")
    # Optional: the model designer finds an error where one that must be given is left to its default.
    return Switch(OPEN_OUTPUT, title, text, True, True, False, OPEN_WIDGET)


def extent() -> MapExtent:
    """A part of what an image or a layer shows."""
    text = tr("The ground that is wanted; all that there is if left out. Map tiles and web maps need it, or a mask.")
    return MapExtent(EXTENT, tr("Extent"), text, optional=True)


def mask() -> VectorSource:
    """Polygons that only the ground within is wanted of."""
    text = tr("Polygons: ground outside of them is not looked at and has no label.")
    return VectorSource(MASK, tr("Mask"), text, optional=True, kinds=(SOURCE_POLYGON,))


def resolution(text: str) -> Number:
    """The size of the pixels that a network looks at."""
    return Number(RESOLUTION, tr("Resolution (cm per pixel)"), text, optional=True, advanced=True, minimum=0.1)


def reference_classes(text: str) -> Text:
    """Names or values of classes, separated by “;”."""
    return Text(REFERENCE_CLASSES, tr("Reference classes"), text, optional=True)


def report(text: str, by_default: bool = True) -> FileOutput:
    """A page to read and print."""
    return FileOutput(
        REPORT, tr("Report"), text, optional=True, by_default=by_default, filter=tr("HTML files (*.html)")
    )


def validation_fraction(optional: bool = False, advanced: bool = False) -> Number:
    """How much of the ground a network is tried on instead of trained."""
    text = tr("Share of the labeled ground that is set aside for validation; 0 for none.")
    title = tr("Validation fraction")
    return Number(VALIDATION_FRACTION, title, text, optional, advanced, default=0.2, minimum=0.0, maximum=0.9)


def seed(text: str = "", default: int = 1) -> Number:
    """What random numbers start from; ``text``: its help where another one is needed."""
    text = text or tr("Another number gives other trials, the same number the same.")
    return Number(SEED, tr("Seed"), text, advanced=True, default=default, minimum=0, is_integer=True)


def sun_direction(text: str) -> Number:
    """Where the sun stood."""
    return Number(
        SUN_DIRECTION, tr("Direction of the sun (°)"), text, optional=True, advanced=True, minimum=0.0, maximum=360.0
    )


def annotation() -> tuple[Parameter, ...]:
    """An annotation layer: its polygons, their classes, and what decides where they overlap."""
    return (
        VectorSource(
            INPUT,
            tr("Annotation layer"),
            tr("Polygons of land cover. They may overlap, be multipart, invalid or three-dimensional."),
            kinds=(SOURCE_POLYGON,),
        ),
        FieldOf(
            CLASS_FIELD,
            tr("Class field"),
            tr("Text or number field with the class of each polygon. Not needed if all are of one class."),
            optional=True,
            layer_key=INPUT,
            widget=CLASS_FIELD_WIDGET,
        ),
        Text(
            CLASS,
            tr("All polygons are"),
            tr("The class of every polygon, such as “building”. If you enter one, the class field is not used."),
            optional=True,
            widget=CLASS_NAME_WIDGET,
        ),
        FieldOf(
            PRIORITY_FIELD,
            tr("Priority field"),
            tr(
                "Number field: where polygons overlap, the one with the higher value lies on top. Without it the draw "
                "order of the class table counts, else later polygons lie on top."
            ),
            optional=True,
            layer_key=INPUT,
        ),
        class_table(
            tr(
                "CSV with the columns value, name, color, role and optionally draw_order, hsv_min, hsv_max. "
                "Every class value of the layer must be in it."
            )
        ),
    )


def network() -> Choice:
    """How poor labels are, in a word."""
    options = (tr("as the numbers say"), tr("good"), tr("usable"), tr("poor"))
    text = tr(
        "How well the network that makes labels of photos does. Usable is what the advanced parameters assume from the "
        "start: 20 % of the landmarks missed, as many invented, 5 % misnamed, edges off by 1 m. Good is half of that, "
        "poor twice as much. Errors of map and camera stay as the numbers say."
    )
    return Choice(NETWORK, tr("Network"), text, optional=True, default=0, options=options)


def comparison() -> File:
    """How poor labels are, as a comparison has measured it."""
    text = tr(
        "The report of “Compare label maps”: the landmarks missed, invented and misnamed, ragged edges, misnamed "
        "background and shifted classes that it found count instead of the network in a word and of these numbers. "
        "Errors of map and camera stay as the numbers say."
    )
    return File(COMPARISON, tr("Comparison report"), text, True, filter=tr("HTML files (*.html)"))


def noises() -> tuple[tuple[str, str, str], ...]:
    """(key, title, help) of each share of landmarks that noise spoils, and of how far it moves edges."""
    return (
        (MISSED, tr("Landmarks missed (%)"), tr("Share of the landmarks that are taken away.")),
        (
            INVENTED,
            tr("Landmarks invented (%)"),
            tr("Share of landmarks that are added, shaped like landmarks of other places of the map."),
        ),
        (MISNAMED, tr("Landmarks misnamed (%)"), tr("Share of the landmarks that get another class.")),
        (
            RAGGED,
            tr("Ragged edges (map units)"),
            tr("Standard deviation of how far edges are moved, alike over eight pixels."),
        ),
    )


def shared_errors() -> tuple[tuple[str, str, str], ...]:
    """(key, title, help) of the background's noise and of errors that all landmarks of an image share."""
    return (
        (
            BACKGROUND,
            tr("Background misnamed (%)"),
            tr("Share of the areas of other classes than those of landmarks that get another of these."),
        ),
        (
            DISPLACED,
            tr("Map displaced (map units)"),
            tr(
                "Standard deviation along each axis of what map and ground differ by, neighbors alike, as maps of two "
                "dates do. 0 where the images are cut from a map of another date already."
            ),
        ),
        (
            SHIFTED,
            tr("Classes shifted (map units)"),
            tr(
                "How far each class of landmarks is shown from where it is, as a whole, in any direction, as networks "
                "do."
            ),
        ),
        (
            LEANING,
            tr("Leaning roofs (%)"),
            tr(
                "How far landmarks lean away from the image’s center, in percent of their distance from it: their "
                "height over the camera’s."
            ),
        ),
        (
            LENS,
            tr("Lens distortion (%)"),
            tr("How much farther out or in than it should the ground in the image’s corners is shown."),
        ),
        (TILT, tr("Camera tilt (°)"), tr("How far the camera looks aside from straight down, in any direction.")),
    )
