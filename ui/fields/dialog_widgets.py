"""Widgets of SemRef's parameters in the dialogs of Processing: single runs, batches and the model designer.

QGIS imports a class by the name in ``processing/base/parameters.py`` and calls it with (parameter, dialog, row,
column). The result is the wrapper of the widget.
"""

from __future__ import annotations

from qgis.core import (
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
    QgsProcessingParameters,
    QgsProject,
    QgsVectorLayer,
)
from qgis.gui import (
    QgsAbstractProcessingParameterWidgetWrapper,
    QgsFieldComboBox,
    QgsFileWidget,
    QgsGui,
    QgsProcessingGui,
    QgsProcessingMapLayerComboBox,
)
from qgis.PyQt import sip
from qgis.PyQt.QtWidgets import QWidget

from ...processing.base import parameters
from ...processing.layers.guess_fields import class_field_of, class_of_all, priority_field_of
from ..class_table import add_edit_button
from ..layer_files import photo_layer
from ..project_state import DATABASE_SETTING, MODEL_SETTING, remembered_file
from ..widgets.controls import ClassNameBox

_BATCH, _MODELER = "BatchAlgorithmDialog", "ModelerParametersDialog"
"""Class names of Processing's dialogs, which Processing itself uses to distinguish them."""


class _Widget(QgsAbstractProcessingParameterWidgetWrapper):
    """Widget in a dialog. The model designer uses QGIS's own widget, which also offers inputs and earlier steps."""

    def __new__(cls, parameter: QgsProcessingParameterDefinition, dialog, row: int = 0, column: int = 0):
        if type(dialog).__name__ != _MODELER:
            return super().__new__(cls)
        registry = QgsGui.processingGuiRegistry()
        wrapper = registry.createModelerParameterWidget(dialog.model, dialog.childId, parameter, dialog.context)
        wrapper.setDialog(dialog)
        return wrapper

    def __init__(self, parameter: QgsProcessingParameterDefinition, dialog, row: int = 0, column: int = 0) -> None:
        super().__init__(parameter, _type_of(dialog))
        self.setDialog(dialog)

    def _prepare(self, box: QWidget) -> QWidget:
        box.setToolTip(self.parameterDefinition().toolTip())
        # QGIS owns the box, but the Python object must live as long, because the destructor uses it: this connection
        # keeps it.
        box.destroyed.connect(lambda half=box: None)
        return box

    def _report(self, *_value) -> None:
        self.widgetValueHasChanged.emit(self)


class ClassTableWidget(_Widget):
    """File box with a button that opens the class table in an editor."""

    def createWidget(self):
        box = QgsFileWidget()
        box.setDialogTitle(self.parameterDefinition().description())
        box.setFilter(self.parameterDefinition().createFileFilter())
        box.fileChanged.connect(self._report)
        add_edit_button(box)
        return self._prepare(box)

    def setWidgetValue(self, value, context):
        self.wrappedWidget().setFilePath("" if value is None else str(value))

    def widgetValue(self):
        return self.wrappedWidget().filePath()


class _OwnWidget(_Widget):
    """QGIS's own widget, which starts with a value of SemRef in the dialog of a single run."""

    def __new__(cls, parameter: QgsProcessingParameterDefinition, dialog, row: int = 0, column: int = 0):
        if type(dialog).__name__ == _MODELER:
            return super().__new__(cls, parameter, dialog)
        if type(dialog).__name__ != _BATCH:
            parameter.setGuiDefaultValueOverride(cls.first(parameter))
        wrapper = QgsGui.processingGuiRegistry().createParameterWidgetWrapper(parameter, _type_of(dialog))
        wrapper.setDialog(dialog)
        return wrapper

    @classmethod
    def first(cls, parameter: QgsProcessingParameterDefinition):
        raise NotImplementedError


class DatabaseWidget(_OwnWidget):
    """File box that starts with the database of the dock, unless it is optional."""

    SETTING = DATABASE_SETTING

    @classmethod
    def first(cls, parameter):
        is_optional = parameter.flags() & QgsProcessingParameterDefinition.FlagOptional
        return None if is_optional else remembered_file(cls.SETTING)


class ModelWidget(DatabaseWidget):
    """File box that starts with the model of the dock, unless it is optional."""

    SETTING = MODEL_SETTING


class OpenWidget(_OwnWidget):
    """Check box that is checked, because the user sees the opened result."""

    @classmethod
    def first(cls, parameter):
        return True


class _LayerWidget(_Widget):
    """Box that follows the land-cover layer of its dialog; a value that is set afterwards stays."""

    _layer: QgsVectorLayer | None = None

    def postInitialize(self, wrappers):
        super().postInitialize(wrappers)
        for wrapper in wrappers:
            if wrapper.parameterDefinition().name() == parameters.INPUT:
                wrapper.widgetValueHasChanged.connect(self._use_layer_of)
                self._use_layer_of(wrapper)

    def _use_layer_of(self, wrapper) -> None:
        definition, value = wrapper.parameterDefinition(), wrapper.parameterValue()
        # A layer outside the project lives as long as its context.
        context = QgsProcessingContext()
        context.setProject(QgsProject.instance())
        layer = QgsProcessingParameters.parameterAsVectorLayer(definition, {definition.name(): value}, context)
        if layer is None or not _same(layer, self._layer):
            self._context, self._layer = context, layer
            self.show_layer(layer)

    def show_layer(self, layer: QgsVectorLayer | None) -> None:
        raise NotImplementedError


class ClassFieldWidget(_LayerWidget):
    """Box of the layer's fields that starts with the class field, not with the first field."""

    GUESS = staticmethod(class_field_of)

    def createWidget(self):
        box = QgsFieldComboBox()
        box.setAllowEmptyFieldName(True)
        box.fieldChanged.connect(self._report)
        return self._prepare(box)

    def show_layer(self, layer):
        self._box().setLayer(layer)
        self._box().setField("" if layer is None else self.GUESS(layer))

    def _box(self) -> QgsFieldComboBox:
        """Return the widget, which QGIS returns as a QComboBox."""
        return sip.cast(self.wrappedWidget(), QgsFieldComboBox)

    def setWidgetValue(self, value, context):
        self._box().setField("" if value is None else str(value))

    def widgetValue(self):
        return self._box().currentField() or None


class PriorityFieldWidget(ClassFieldWidget):
    """Box of the layer's fields that starts with a field of priorities, or empty."""

    GUESS = staticmethod(priority_field_of)


class ClassNameWidget(_LayerWidget):
    """Box for the class of all polygons. A layer of buildings has one; a class disables the box of the field."""

    _fields: QWidget | None = None

    def createWidget(self):
        box = ClassNameBox()
        box.currentTextChanged.connect(self._report)
        return self._prepare(box)

    def postInitialize(self, wrappers):
        for wrapper in wrappers:
            if wrapper.parameterDefinition().name() == parameters.CLASS_FIELD:
                self._fields = wrapper.wrappedWidget()
        super().postInitialize(wrappers)
        self._report()

    def show_layer(self, layer):
        self.wrappedWidget().setCurrentText("" if layer is None else class_of_all(layer))

    def setWidgetValue(self, value, context):
        self.wrappedWidget().setCurrentText("" if value is None else str(value))

    def widgetValue(self):
        return self.wrappedWidget().currentText().strip() or None

    def _report(self, *_value) -> None:
        if self._fields is not None:
            self._fields.setEnabled(self.widgetValue() is None)
        super()._report()


class PhotoWidget(_Widget):
    """Box of rasters that starts with the project's only photo or empty; QGIS would take the first raster."""

    def __init__(self, parameter: QgsProcessingParameterDefinition, dialog, row: int = 0, column: int = 0) -> None:
        photo = photo_layer(QgsProject.instance())
        if photo is not None and _type_of(dialog) == QgsProcessingGui.Standard:
            parameter.setGuiDefaultValueOverride(photo.id())
        super().__init__(parameter, dialog)

    def createWidget(self):
        # The box of an optional layer starts with an empty entry.
        optional = self.parameterDefinition().clone()
        optional.setFlags(optional.flags() | QgsProcessingParameterDefinition.FlagOptional)
        box = QgsProcessingMapLayerComboBox(optional, self.type())
        box.valueChanged.connect(self._report)
        return self._prepare(box)

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


def _same(layer: QgsVectorLayer, before: QgsVectorLayer | None) -> bool:
    """Return whether both are the same layer. A file that is not in the project is opened again for each value."""
    if before is None or QgsProject.instance().mapLayer(layer.id()) is not None:
        return before is not None and before.id() == layer.id()
    return before.source() == layer.source()


def _type_of(dialog):
    return QgsProcessingGui.Batch if type(dialog).__name__ == _BATCH else QgsProcessingGui.Standard
