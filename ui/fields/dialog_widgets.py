"""Widgets of SemRef's parameters in the dialogs of Processing: single runs, batches and the model designer.

QGIS makes them by the name of their class, which ``processing.framework.declarations.WIDGETS`` has while there are
windows. It calls a class with (parameter, dialog, row, column) and takes what comes for the widget's wrapper.
"""

from __future__ import annotations

from functools import partial
from typing import Callable

from qgis.core import (
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
    QgsProcessingParameters,
    QgsProject,
    QgsVectorLayer,
)
from qgis.gui import (
    QgsAbstractProcessingParameterWidgetWrapper,
    QgsDoubleSpinBox,
    QgsFieldComboBox,
    QgsFileWidget,
    QgsGui,
    QgsProcessingGui,
    QgsProcessingMapLayerComboBox,
)
from qgis.PyQt import sip
from qgis.PyQt.QtWidgets import QLabel, QVBoxLayout, QWidget

from ...processing.framework import offers
from ...processing.framework.declarations import (
    CLASS_FIELD_WIDGET,
    CLASS_NAME_WIDGET,
    CLASS_TABLE_WIDGET,
    DATABASE_WIDGET,
    MODEL_WIDGET,
    OPEN_WIDGET,
    PHOTO_WIDGET,
    TIME_LIMIT_WIDGET,
    WIDGETS,
)
from ..class_table.edit_button import EditButton
from ..layer_files import photo_layer
from ..widgets.layouts import narrow
from .class_name_box import ClassNameBox
from .epochs import TRAINING_VALUES, epochs_text
from .guessed import class_field_of, class_of_all
from .known import DATABASE, MODEL, chosen
from .known_button import KnownButton

_BATCH, _MODELER = "BatchAlgorithmDialog", "ModelerParametersDialog"
"""Processing's own dialogs, by which it tells them apart itself."""


def offer_widgets() -> None:
    """From now on dialogs have these widgets."""
    WIDGETS.update(
        {
            DATABASE_WIDGET: f"{__name__}.DatabaseWidget",
            MODEL_WIDGET: f"{__name__}.ModelWidget",
            OPEN_WIDGET: f"{__name__}.OpenWidget",
            CLASS_TABLE_WIDGET: f"{__name__}.ClassTableWidget",
            CLASS_FIELD_WIDGET: f"{__name__}.ClassFieldWidget",
            CLASS_NAME_WIDGET: f"{__name__}.ClassNameWidget",
            PHOTO_WIDGET: f"{__name__}.PhotoWidget",
            TIME_LIMIT_WIDGET: f"{__name__}.TimeLimitWidget",
        }
    )


def withdraw_widgets() -> None:
    """From now on dialogs have QGIS's own widgets."""
    WIDGETS.clear()


class DatabaseWidget:
    """A file box that offers the databases at hand; a dialog begins with the one that the dock has."""

    KIND = DATABASE

    def __new__(cls, parameter: QgsProcessingParameterDefinition, dialog, row: int = 0, column: int = 0):
        name = type(dialog).__name__
        if name == _MODELER:
            wrapper = _of_designer(parameter, dialog)
            wrapper.known = [KnownButton(box, cls.KIND) for box in wrapper.findChildren(QgsFileWidget)]
        else:
            if name != _BATCH and not parameter.flags() & QgsProcessingParameterDefinition.FlagOptional:
                parameter.setGuiDefaultValueOverride(chosen(cls.KIND))
            wrapper = _FileWrapper(parameter, _type_of(name), partial(KnownButton, kind=cls.KIND))
        wrapper.setDialog(dialog)
        return wrapper


class ModelWidget(DatabaseWidget):
    """A file box that offers the models at hand."""

    KIND = MODEL


class ClassTableWidget:
    """A file box with a button that shows the class table in a window, to be edited."""

    def __new__(cls, parameter: QgsProcessingParameterDefinition, dialog, row: int = 0, column: int = 0):
        name = type(dialog).__name__
        if name == _MODELER:
            wrapper = _of_designer(parameter, dialog)
        else:
            wrapper = _FileWrapper(parameter, _type_of(name), EditButton)
        wrapper.setDialog(dialog)
        return wrapper


class ClassFieldWidget:
    """A box of the layer's fields that begins with the one that tells classes, not with the first one."""

    @staticmethod
    def made(parameter: QgsProcessingParameterDefinition, kind_of_dialog):
        """The wrapper outside of the model designer."""
        return _ClassFieldWrapper(parameter, kind_of_dialog)

    def __new__(cls, parameter: QgsProcessingParameterDefinition, dialog, row: int = 0, column: int = 0):
        name = type(dialog).__name__
        wrapper = _of_designer(parameter, dialog) if name == _MODELER else cls.made(parameter, _type_of(name))
        wrapper.setDialog(dialog)
        return wrapper


class ClassNameWidget(ClassFieldWidget):
    """A box for the class of all polygons, which a layer of buildings begins with."""

    @staticmethod
    def made(parameter: QgsProcessingParameterDefinition, kind_of_dialog):
        """The wrapper outside of the model designer."""
        return _ClassNameWrapper(parameter, kind_of_dialog)


class PhotoWidget(ClassFieldWidget):
    """A box of rasters that begins with the project's only photo, otherwise empty: QGIS would take the first raster."""

    @staticmethod
    def made(parameter: QgsProcessingParameterDefinition, kind_of_dialog):
        """The wrapper outside of the model designer."""
        photo = photo_layer(QgsProject.instance())
        if photo is not None and kind_of_dialog == QgsProcessingGui.Standard:
            parameter.setGuiDefaultValueOverride(photo.id())
        return _PhotoWrapper(parameter, kind_of_dialog)


class TimeLimitWidget(ClassFieldWidget):
    """A box of minutes that shows how many epochs of training fit in."""

    @staticmethod
    def made(parameter: QgsProcessingParameterDefinition, kind_of_dialog):
        """The wrapper outside of the model designer."""
        return _TimeLimitWrapper(parameter, kind_of_dialog)


class OpenWidget:
    """A box that is ticked in the dialog of a single run, where somebody sees what is opened."""

    def __new__(cls, parameter: QgsProcessingParameterDefinition, dialog, row: int = 0, column: int = 0):
        name = type(dialog).__name__
        if name == _MODELER:
            wrapper = _of_designer(parameter, dialog)
        else:
            if name != _BATCH:
                parameter.setGuiDefaultValueOverride(True)
            wrapper = QgsGui.processingGuiRegistry().createParameterWidgetWrapper(parameter, _type_of(name))
        wrapper.setDialog(dialog)
        return wrapper


class _FileWrapper(QgsAbstractProcessingParameterWidgetWrapper):
    """QGIS's file box with a button more."""

    def __init__(
        self, parameter: QgsProcessingParameterDefinition, kind_of_dialog, button: Callable[[QgsFileWidget], QWidget]
    ) -> None:
        super().__init__(parameter, kind_of_dialog)
        self._button = button

    def createWidget(self):
        box = QgsFileWidget()
        box.setToolTip(self.parameterDefinition().toolTip())
        box.setDialogTitle(self.parameterDefinition().description())
        box.setFilter(self.parameterDefinition().createFileFilter())
        box.fileChanged.connect(self._tell)
        self.known = self._button(box)
        # QGIS takes the box over without keeping Python's half of it, which its destructor looks for: the connection
        # keeps that half until the box is gone.
        box.destroyed.connect(lambda *_, half=box: None)
        return box

    def setWidgetValue(self, value, context):
        self.wrappedWidget().setFilePath("" if value is None else str(value))

    def widgetValue(self):
        return self.wrappedWidget().filePath()

    def _tell(self, *_path) -> None:
        self.widgetValueHasChanged.emit(self)


class _Wrapper(QgsAbstractProcessingParameterWidgetWrapper):
    """What wrappers of own boxes share."""

    def _kept(self, box: QWidget) -> QWidget:
        box.setToolTip(self.parameterDefinition().toolTip())
        # As for the box of a file: the connection keeps Python's half of it until the box is gone.
        box.destroyed.connect(lambda *_, half=box: None)
        return box

    def _tell(self, *_value) -> None:
        self.widgetValueHasChanged.emit(self)


class _LayerWrapper(_Wrapper):
    """A box that follows the annotation layer of its dialog; a value that is given afterwards stays."""

    _layer: QgsVectorLayer | None = None

    def postInitialize(self, wrappers):
        super().postInitialize(wrappers)
        for wrapper in wrappers:
            if wrapper.parameterDefinition().name() == offers.INPUT:
                wrapper.widgetValueHasChanged.connect(self._use_layer_of)
                self._use_layer_of(wrapper)

    def _use_layer_of(self, wrapper) -> None:
        definition, value = wrapper.parameterDefinition(), wrapper.parameterValue()
        # A layer that is a file alone lives as long as its context.
        context = QgsProcessingContext()
        context.setProject(QgsProject.instance())
        layer = QgsProcessingParameters.parameterAsVectorLayer(definition, {definition.name(): value}, context)
        if layer is None or not _same(layer, self._layer):
            self._context, self._layer = context, layer
            self.show_layer(layer)

    def show_layer(self, layer: QgsVectorLayer | None) -> None:
        """Shows what the layer begins with."""
        raise NotImplementedError


class _ClassFieldWrapper(_LayerWrapper):
    """QGIS's box of fields."""

    def createWidget(self):
        box = QgsFieldComboBox()
        box.setAllowEmptyFieldName(True)
        box.fieldChanged.connect(self._tell)
        return self._kept(box)

    def show_layer(self, layer):
        self._box().setLayer(layer)
        self._box().setField("" if layer is None else class_field_of(layer))

    def _box(self) -> QgsFieldComboBox:
        """The widget, which QGIS gives back as a box of any texts."""
        return sip.cast(self.wrappedWidget(), QgsFieldComboBox)

    def setWidgetValue(self, value, context):
        self._box().setField("" if value is None else str(value))

    def widgetValue(self):
        return self._box().currentField() or None


class _ClassNameWrapper(_LayerWrapper):
    """A box that offers “building” and takes any name; while it has one, the box of fields is disabled."""

    _fields: QWidget | None = None

    def createWidget(self):
        box = ClassNameBox()
        box.currentTextChanged.connect(self._tell)
        return self._kept(box)

    def postInitialize(self, wrappers):
        for wrapper in wrappers:
            if wrapper.parameterDefinition().name() == offers.CLASS_FIELD:
                self._fields = wrapper.wrappedWidget()
        super().postInitialize(wrappers)
        self._tell()

    def show_layer(self, layer):
        self.wrappedWidget().setCurrentText("" if layer is None else class_of_all(layer))

    def setWidgetValue(self, value, context):
        self.wrappedWidget().setCurrentText("" if value is None else str(value))

    def widgetValue(self):
        return self.wrappedWidget().currentText().strip() or None

    def _tell(self, *_value) -> None:
        if self._fields is not None:
            self._fields.setEnabled(self.widgetValue() is None)
        super()._tell()


class _PhotoWrapper(_Wrapper):
    """QGIS's box of rasters and files, which may be empty."""

    def createWidget(self):
        # The box of an optional layer has an empty entry, and begins with it.
        optional = self.parameterDefinition().clone()
        optional.setFlags(optional.flags() | QgsProcessingParameterDefinition.FlagOptional)
        box = QgsProcessingMapLayerComboBox(optional, self.type())
        box.valueChanged.connect(self._tell)
        return self._kept(box)

    def _box(self) -> QgsProcessingMapLayerComboBox:
        return sip.cast(self.wrappedWidget(), QgsProcessingMapLayerComboBox)

    def setWidgetContext(self, context):
        super().setWidgetContext(context)
        if self.wrappedWidget() is not None:
            self._box().setWidgetContext(context)

    def setWidgetValue(self, value, context):
        self._box().setValue(value, context)

    def widgetValue(self):
        return self._box().value()


class _TimeLimitWrapper(_Wrapper):
    """A box of minutes above a line that follows the other values of the dialog."""

    def createWidget(self):
        widget = QWidget()
        self._minutes = QgsDoubleSpinBox()
        self._minutes.setRange(0, 100_000)
        self._minutes.setValue(self.parameterDefinition().defaultValue())
        self._minutes.setClearValue(self.parameterDefinition().defaultValue())
        self._minutes.valueChanged.connect(self._tell)
        self._line = QLabel()
        self._line.setWordWrap(True)
        self._line.setObjectName("SemRefEpochs")
        layout = narrow(QVBoxLayout(widget), 0)
        layout.addWidget(self._minutes)
        layout.addWidget(self._line)
        self._others = []
        return self._kept(widget)

    def postInitialize(self, wrappers):
        super().postInitialize(wrappers)
        self._others = [wrapper for wrapper in wrappers if wrapper is not self]
        for wrapper in self._others:
            if wrapper.parameterDefinition().name() in TRAINING_VALUES:
                wrapper.widgetValueHasChanged.connect(self._show)
        self._show()

    def setWidgetValue(self, value, context):
        self._minutes.setValue(0.0 if value in (None, "") else float(value))

    def widgetValue(self):
        return self._minutes.value()

    def _tell(self, *_value) -> None:
        super()._tell()
        self._show()

    def _show(self, *_value) -> None:
        values = {one.parameterDefinition().name(): one.parameterValue() for one in self._others}
        self._line.setText(epochs_text(self._minutes.value(), values))


def _same(layer: QgsVectorLayer, before: QgsVectorLayer | None) -> bool:
    """Whether both are one; what is a file alone is opened anew whenever a dialog's value is told."""
    if before is None or QgsProject.instance().mapLayer(layer.id()) is not None:
        return before is not None and before.id() == layer.id()
    return before.source() == layer.source()


def _of_designer(parameter: QgsProcessingParameterDefinition, dialog):
    """QGIS's own widget: beside the value it offers the model's inputs and what its steps write."""
    registry = QgsGui.processingGuiRegistry()
    return registry.createModelerParameterWidget(dialog.model, dialog.childId, parameter, dialog.context)


def _type_of(dialog: str):
    return QgsProcessingGui.Batch if dialog == _BATCH else QgsProcessingGui.Standard
