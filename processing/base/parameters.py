"""Parameters that several algorithms share, and a helper that adds help to QGIS's own parameters."""

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
PYTHON = "PYTHON"
COMPARISON = "COMPARISON"


def with_help(
    parameter: QgsProcessingParameterDefinition, text: str, advanced: bool = False, widget: str = ""
) -> QgsProcessingParameterDefinition:
    """Add help to a parameter and return it.

    Args:
        parameter: It is changed.
        text: Help of at most 60 words.
        advanced: Whether dialogs fold it away.
        widget: A class of ``ui/fields/dialog_widgets.py`` that shows it in dialogs; QGIS's own widget if empty.
    """
    parameter.setHelp(text)
    kinds = parameter.fileFilter() if isinstance(parameter, QgsProcessingParameterFile) else ""
    if kinds and "(*)" not in kinds:
        # QGIS refuses other names, even “.CSV”, without a reason. The readers look at the content.
        parameter.setFileFilter(f"{kinds};;{tr('All files (*)')}")
    if advanced:
        parameter.setFlags(parameter.flags() | QgsProcessingParameterDefinition.FlagAdvanced)
    if widget:
        package = __name__.rpartition(".processing.")[0]
        parameter.setMetadata({"widget_wrapper": {"class": f"{package}.ui.fields.dialog_widgets.{widget}"}})
    return parameter


def database(text: str = "", optional: bool = False) -> QgsProcessingParameterDefinition:
    """Return the reference database; ``text`` replaces its help."""
    kinds = tr("Reference databases (*.gpkg)")
    return with_help(
        QgsProcessingParameterFile(DATABASE, "Reference database", fileFilter=kinds, optional=optional),
        text if text else "A GeoPackage made by “Build reference database”.",
        widget="DatabaseWidget",
    )


def label_map(text: str, optional: bool = False) -> QgsProcessingParameterDefinition:
    return with_help(QgsProcessingParameterRasterLayer(LABELS, "Label map", optional=optional), text)


def class_table(text: str, optional: bool = True, advanced: bool = False) -> QgsProcessingParameterDefinition:
    csv = tr("CSV files (*.csv)")
    return with_help(
        QgsProcessingParameterFile(CLASS_TABLE, "Class table", fileFilter=csv, optional=optional),
        text,
        advanced=advanced,
        widget="ClassTableWidget",
    )


def model(text: str, optional: bool = False) -> QgsProcessingParameterDefinition:
    return with_help(
        QgsProcessingParameterFile(MODEL, "Model", fileFilter=tr("ONNX models (*.onnx)"), optional=optional),
        text,
        widget="ModelWidget",
    )


def open_output() -> QgsProcessingParameterDefinition:
    """Return the switch that opens a new database in QGIS: on by default in dialogs only."""
    title = tr("Open the database after running")
    # Optional, because the model designer reports an error for a mandatory parameter that has its default.
    return with_help(
        QgsProcessingParameterBoolean(OPEN_OUTPUT, title, defaultValue=False, optional=True),
        "Adds the layers of the database to the project and selects the database in the dock.",
        advanced=True,
        widget="OpenWidget",
    )


def extent() -> QgsProcessingParameterDefinition:
    return with_help(
        QgsProcessingParameterExtent(EXTENT, "Extent", optional=True),
        "Area to process; the whole image or layer if not set. Map tiles and web maps need an extent or a mask.",
    )


def mask() -> QgsProcessingParameterDefinition:
    return with_help(
        QgsProcessingParameterFeatureSource(MASK, "Mask", types=[SOURCE_POLYGON], optional=True),
        "Polygons that limit the area to process. Pixels outside the polygons get no label.",
    )


def resolution(text: str, advanced: bool = True) -> QgsProcessingParameterDefinition:
    return with_help(
        QgsProcessingParameterNumber(RESOLUTION, "Resolution (cm per pixel)", DOUBLE, optional=True, minValue=0.1),
        text,
        advanced=advanced,
    )


def python_of_training() -> QgsProcessingParameterDefinition:
    return with_help(
        QgsProcessingParameterFile(
            PYTHON, "Python of the training environment", fileFilter=tr("Programs (*)"), optional=True
        ),
        "Python with torch. If not set, the Python of the SemRef options is used, or the training environment that "
        "SemRef installed.",
        advanced=True,
    )


def reference_classes(text: str) -> QgsProcessingParameterDefinition:
    """Return the classes that are landmarks: names or values, separated by “;”."""
    return with_help(QgsProcessingParameterString(REFERENCE_CLASSES, "Reference classes", optional=True), text)


def report(text: str, by_default: bool = True) -> QgsProcessingParameterDefinition:
    return with_help(
        QgsProcessingParameterFileDestination(
            REPORT, "Report", fileFilter=tr("HTML files (*.html)"), optional=True, createByDefault=by_default
        ),
        text,
    )


def validation_fraction(optional: bool = False, advanced: bool = False) -> QgsProcessingParameterDefinition:
    """Return the share of the labeled ground that is set aside to test a model."""
    title = tr("Validation fraction")
    return with_help(
        QgsProcessingParameterNumber(
            VALIDATION_FRACTION, title, DOUBLE, 0.2, optional=optional, minValue=0.0, maxValue=0.9
        ),
        "Share of the labeled ground that is set aside to test the model, for example 0.2. 0 sets nothing aside.",
        advanced=advanced,
    )


def seed(default: int = 1) -> QgsProcessingParameterDefinition:
    return with_help(
        QgsProcessingParameterNumber(SEED, "Seed", INTEGER, default, minValue=0),
        "Start value of the random numbers. The same number gives the same trials again.",
        advanced=True,
    )


def sun_direction(text: str) -> QgsProcessingParameterDefinition:
    return with_help(
        QgsProcessingParameterNumber(
            SUN_DIRECTION, "Direction of the sun (°)", DOUBLE, optional=True, minValue=0.0, maxValue=360.0
        ),
        text,
        advanced=True,
    )


def annotation(optional: bool = False) -> tuple[QgsProcessingParameterDefinition, ...]:
    """Return the land-cover layer, its class fields and its class table."""
    return (
        with_help(
            QgsProcessingParameterFeatureSource(INPUT, "Land-cover layer", types=[SOURCE_POLYGON], optional=optional),
            "Polygon layer with land-cover classes. Polygons may overlap, and may be multipart, invalid or "
            "three-dimensional.",
        ),
        with_help(
            QgsProcessingParameterField(CLASS_FIELD, "Class field", parentLayerParameterName=INPUT, optional=True),
            "Text or number field with the class of each polygon. Not needed if all polygons have the same class.",
            widget="ClassFieldWidget",
        ),
        with_help(
            QgsProcessingParameterString(CLASS, "All polygons are", optional=True),
            "Class of all polygons, for example “building”. If you enter a class here, the class field is not used.",
            widget="ClassNameWidget",
        ),
        with_help(
            QgsProcessingParameterField(
                PRIORITY_FIELD, "Priority field", parentLayerParameterName=INPUT, optional=True
            ),
            "Number field. Where polygons overlap, the polygon with the higher value is on top. Without this "
            "field the draw order of the class table decides, otherwise the later polygon is on top.",
            widget="PriorityFieldWidget",
        ),
        class_table(
            tr(
                "CSV file with the columns value, name, color, role and optionally draw_order, hsv_min, hsv_max. It "
                "must contain every class of the layer."
            )
        ),
    )


def network() -> QgsProcessingParameterDefinition:
    """Return the choice that sets all label errors of a model at once."""
    options = (tr("use the values below"), tr("good"), tr("usable"), tr("poor"))
    return with_help(
        QgsProcessingParameterEnum(NETWORK, "Label quality", options=options, defaultValue=0, optional=True),
        "Quality of the labels that the model makes of photos. “usable” means 20 % missed landmarks, 20 % spurious "
        "landmarks, 5 % mislabeled landmarks and a boundary jitter of 1 m. “good” means half of these errors, “poor” "
        "twice as much. Errors of the map and the camera are not changed.",
    )


def comparison() -> QgsProcessingParameterDefinition:
    """Return the report of “Compare label maps” that replaces the assumed errors."""
    return with_help(
        QgsProcessingParameterFile(
            COMPARISON, "Comparison report", fileFilter=tr("HTML files (*.html)"), optional=True
        ),
        "Report of “Compare label maps”. Its measured values replace the label quality and the values of these "
        "parameters: missed, spurious and mislabeled landmarks, boundary jitter, mislabeled background and class "
        "offset. Errors of the map and the camera are not changed.",
    )


def noises() -> tuple[tuple[str, str, str], ...]:
    """Return (key, title, help) of each share of wrong landmarks, and of the boundary jitter."""
    return (
        (MISSED, tr("Missed landmarks (%)"), tr("Share of the landmarks that are removed from the simulated labels.")),
        (
            INVENTED,
            tr("Spurious landmarks (%)"),
            tr(
                "Share of landmarks that are added to the simulated labels. They have the shapes of landmarks "
                "elsewhere on the map."
            ),
        ),
        (MISNAMED, tr("Mislabeled landmarks (%)"), tr("Share of the landmarks that get a wrong class.")),
        (
            RAGGED,
            tr("Boundary jitter (m)"),
            tr(
                "Standard deviation of the shift of landmark boundaries. Boundaries within eight pixels shift together."
            ),
        ),
    )


def shared_errors() -> tuple[tuple[str, str, str], ...]:
    """Return (key, title, help) of the background's error, and of errors that all landmarks of an image share."""
    return (
        (
            BACKGROUND,
            tr("Mislabeled background (%)"),
            tr("Share of the background area that gets the class of other background."),
        ),
        (
            DISPLACED,
            tr("Map displacement (m)"),
            tr(
                "Standard deviation, along each axis, of the difference between map and ground, as between maps of "
                "two dates. Neighboring landmarks are displaced together. Set 0 if the images are cut from a map of "
                "another date."
            ),
        ),
        (
            SHIFTED,
            tr("Class offset (m)"),
            tr(
                "Distance by which the model shows each class of landmarks off its true position. The direction is "
                "random for each class."
            ),
        ),
        (
            LEANING,
            tr("Building lean (%)"),
            tr(
                "Apparent lean of landmarks away from the image center, in percent of their distance from it. It is "
                "the height of the landmark divided by the height of the camera."
            ),
        ),
        (
            LENS,
            tr("Lens distortion (%)"),
            tr("Shift of the ground in the corners of the image, outward or inward, in percent."),
        ),
        (
            TILT,
            tr("Camera tilt (°)"),
            tr("Angle between the direction of the camera and straight down, in any direction."),
        ),
    )
