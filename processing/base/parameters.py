"""QGIS's own parameters with help and widgets, and those that several algorithms share."""

from __future__ import annotations

from qgis.core import (
    QgsProcessingParameterBoolean,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterEnum,
    QgsProcessingParameterExtent,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterField,
    QgsProcessingParameterFile,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterLayer,
    QgsProcessingParameterString,
)

from ..compat import DOUBLE, INTEGER, SOURCE_POLYGON
from ..translation import tr

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


def with_help(
    parameter: QgsProcessingParameterDefinition, text: str, advanced: bool = False, widget: str = ""
) -> QgsProcessingParameterDefinition:
    """Return the parameter with its help.

    Args:
        parameter: It is changed.
        text: One or two sentences, in the user's language.
        advanced: Whether dialogs fold it away.
        widget: A class of ``ui/fields/dialog_widgets.py`` that dialogs show it as; QGIS's own widget if empty.
    """
    parameter.setHelp(text)
    if advanced:
        parameter.setFlags(parameter.flags() | QgsProcessingParameterDefinition.FlagAdvanced)
    if widget:
        package = __name__.rpartition(".processing.")[0]
        parameter.setMetadata({"widget_wrapper": {"class": f"{package}.ui.fields.dialog_widgets.{widget}"}})
    return parameter


def database(text: str = "", optional: bool = False) -> QgsProcessingParameterDefinition:
    """A reference database; ``text``: its help where another one is needed."""
    text = text or tr("A GeoPackage made by “Build reference database”.")
    kinds = tr("Reference databases (*.gpkg)")
    return with_help(
        QgsProcessingParameterFile(DATABASE, tr("Reference database"), fileFilter=kinds, optional=optional),
        text,
        widget="DatabaseWidget",
    )


def label_map(text: str, optional: bool = False) -> QgsProcessingParameterDefinition:
    """A label map."""
    return with_help(QgsProcessingParameterRasterLayer(LABELS, tr("Label map"), optional=optional), text)


def class_table(text: str, optional: bool = True, advanced: bool = False) -> QgsProcessingParameterDefinition:
    """A class table."""
    csv = tr("CSV files (*.csv)")
    return with_help(
        QgsProcessingParameterFile(CLASS_TABLE, tr("Class table"), fileFilter=csv, optional=optional),
        text,
        advanced=advanced,
        widget="ClassTableWidget",
    )


def model(text: str, optional: bool = False) -> QgsProcessingParameterDefinition:
    """A segmentation network."""
    return with_help(
        QgsProcessingParameterFile(MODEL, tr("Model"), fileFilter=tr("ONNX models (*.onnx)"), optional=optional),
        text,
        widget="ModelWidget",
    )


def open_output() -> QgsProcessingParameterDefinition:
    """Whether a database is opened in QGIS when it is written; dialogs suggest it, scripts and batches don't."""
    title = tr("Open the database after running")
    text = tr("Adds the database’s layers to the project and chooses it in the dock.")
    # Optional: the model designer finds an error where one that must be given is left to its default.
    return with_help(
        QgsProcessingParameterBoolean(OPEN_OUTPUT, title, defaultValue=False, optional=True),
        text,
        advanced=True,
        widget="OpenWidget",
    )


def extent() -> QgsProcessingParameterDefinition:
    """A part of what an image or a layer shows."""
    text = tr("The ground that is wanted; all that there is if left out. Map tiles and web maps need it, or a mask.")
    return with_help(QgsProcessingParameterExtent(EXTENT, tr("Extent"), optional=True), text)


def mask() -> QgsProcessingParameterDefinition:
    """Polygons that only the ground within is wanted of."""
    text = tr("Polygons: ground outside of them is not looked at and has no label.")
    return with_help(QgsProcessingParameterFeatureSource(MASK, tr("Mask"), types=[SOURCE_POLYGON], optional=True), text)


def resolution(text: str, advanced: bool = True) -> QgsProcessingParameterDefinition:
    """The size of the pixels that a network looks at."""
    return with_help(
        QgsProcessingParameterNumber(
            RESOLUTION, tr("Resolution (cm per pixel)"), type=DOUBLE, optional=True, minValue=0.1
        ),
        text,
        advanced=advanced,
    )


def reference_classes(text: str) -> QgsProcessingParameterDefinition:
    """Names or values of classes, separated by “;”."""
    return with_help(QgsProcessingParameterString(REFERENCE_CLASSES, tr("Reference classes"), optional=True), text)


def report(text: str, by_default: bool = True) -> QgsProcessingParameterDefinition:
    """A page to read and print."""
    return with_help(
        QgsProcessingParameterFileDestination(
            REPORT, tr("Report"), fileFilter=tr("HTML files (*.html)"), optional=True, createByDefault=by_default
        ),
        text,
    )


def validation_fraction(optional: bool = False, advanced: bool = False) -> QgsProcessingParameterDefinition:
    """How much of the ground a network is tried on instead of trained."""
    text = tr("Share of the labeled ground that is set aside for validation; 0 for none.")
    title = tr("Validation fraction")
    return with_help(
        QgsProcessingParameterNumber(
            VALIDATION_FRACTION, title, type=DOUBLE, defaultValue=0.2, optional=optional, minValue=0.0, maxValue=0.9
        ),
        text,
        advanced=advanced,
    )


def seed(text: str = "", default: int = 1) -> QgsProcessingParameterDefinition:
    """What random numbers start from; ``text``: its help where another one is needed."""
    text = text or tr("Another number gives other trials, the same number the same.")
    return with_help(
        QgsProcessingParameterNumber(SEED, tr("Seed"), type=INTEGER, defaultValue=default, minValue=0),
        text,
        advanced=True,
    )


def sun_direction(text: str) -> QgsProcessingParameterDefinition:
    """Where the sun stood."""
    return with_help(
        QgsProcessingParameterNumber(
            SUN_DIRECTION, tr("Direction of the sun (°)"), type=DOUBLE, optional=True, minValue=0.0, maxValue=360.0
        ),
        text,
        advanced=True,
    )


def annotation(optional: bool = False) -> tuple[QgsProcessingParameterDefinition, ...]:
    """An annotation layer: its polygons, their classes, and what decides where they overlap."""
    return (
        with_help(
            QgsProcessingParameterFeatureSource(
                INPUT, tr("Annotation layer"), types=[SOURCE_POLYGON], optional=optional
            ),
            tr("Polygons of land cover. They may overlap, be multipart, invalid or three-dimensional."),
        ),
        with_help(
            QgsProcessingParameterField(CLASS_FIELD, tr("Class field"), parentLayerParameterName=INPUT, optional=True),
            tr("Text or number field with the class of each polygon. Not needed if all are of one class."),
            widget="ClassFieldWidget",
        ),
        with_help(
            QgsProcessingParameterString(CLASS, tr("All polygons are"), optional=True),
            tr("The class of every polygon, such as “building”. If you enter one, the class field is not used."),
            widget="ClassNameWidget",
        ),
        with_help(
            QgsProcessingParameterField(
                PRIORITY_FIELD, tr("Priority field"), parentLayerParameterName=INPUT, optional=True
            ),
            tr(
                "Number field: where polygons overlap, the one with the higher value lies on top. Without it the draw "
                "order of the class table counts, else later polygons lie on top."
            ),
        ),
        class_table(
            tr(
                "CSV with the columns value, name, color, role and optionally draw_order, hsv_min, hsv_max. "
                "Every class value of the layer must be in it."
            )
        ),
    )


def network() -> QgsProcessingParameterDefinition:
    """How poor labels are, in a word."""
    options = (tr("as the numbers say"), tr("good"), tr("usable"), tr("poor"))
    text = tr(
        "How well the network that makes labels of photos does. Usable is what the advanced parameters assume from the "
        "start: 20 % of the landmarks missed, as many invented, 5 % misnamed, edges off by 1 m. Good is half of that, "
        "poor twice as much. Errors of map and camera stay as the numbers say."
    )
    return with_help(
        QgsProcessingParameterEnum(NETWORK, tr("Network"), options=options, defaultValue=0, optional=True), text
    )


def comparison() -> QgsProcessingParameterDefinition:
    """How poor labels are, as a comparison has measured it."""
    text = tr(
        "The report of “Compare label maps”: the landmarks missed, invented and misnamed, ragged edges, misnamed "
        "background and shifted classes that it found count instead of the network in a word and of these numbers. "
        "Errors of map and camera stay as the numbers say."
    )
    return with_help(
        QgsProcessingParameterFile(
            COMPARISON, tr("Comparison report"), fileFilter=tr("HTML files (*.html)"), optional=True
        ),
        text,
    )


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
