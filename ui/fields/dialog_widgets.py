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
    QgsFieldComboBox,
    QgsFileWidget,
    QgsGui,
    QgsProcessingGui,
)
from qgis.PyQt import sip
from qgis.PyQt.QtWidgets import QWidget

from ...processing.framework.declarations import (
    CLASS_FIELD_WIDGET,
    CLASS_TABLE_WIDGET,
    DATABASE_WIDGET,
    MODEL_WIDGET,
    OPEN_WIDGET,
    WIDGETS,
)
from ..class_table.edit_button import EditButton
from .guessed import class_field_of
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

    def __new__(cls, parameter: QgsProcessingParameterDefinition, dialog, row: int = 0, column: int = 0):
        name = type(dialog).__name__
        is_model = name == _MODELER
        wrapper = _of_designer(parameter, dialog) if is_model else _ClassFieldWrapper(parameter, _type_of(name))
        wrapper.setDialog(dialog)
        return wrapper


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


class _ClassFieldWrapper(QgsAbstractProcessingParameterWidgetWrapper):
    """QGIS's box of fields, which follows the layer of the dialog; whoever gives a field afterwards is heeded."""

    def createWidget(self):
        box = QgsFieldComboBox()
        box.setToolTip(self.parameterDefinition().toolTip())
        box.fieldChanged.connect(self._tell)
        # As for the box of a file: the connection keeps Python's half of it until the box is gone.
        box.destroyed.connect(lambda *_, half=box: None)
        return box

    def postInitialize(self, wrappers):
        super().postInitialize(wrappers)
        for wrapper in wrappers:
            if wrapper.parameterDefinition().name() == self.parameterDefinition().parentLayerParameterName():
                wrapper.widgetValueHasChanged.connect(self._use_layer_of)
                self._use_layer_of(wrapper)

    def _use_layer_of(self, wrapper) -> None:
        definition, value = wrapper.parameterDefinition(), wrapper.parameterValue()
        # A layer that is a file alone lives as long as its context.
        context = QgsProcessingContext()
        context.setProject(QgsProject.instance())
        layer = QgsProcessingParameters.parameterAsVectorLayer(definition, {definition.name(): value}, context)
        box = self._box()
        if layer is not None and _same(layer, box.layer()):
            return
        self._context = context
        box.setLayer(layer)
        guessed = class_field_of(layer) if layer is not None else ""
        if guessed:
            box.setField(guessed)

    def _box(self) -> QgsFieldComboBox:
        """The widget, which QGIS gives back as a box of any texts."""
        return sip.cast(self.wrappedWidget(), QgsFieldComboBox)

    def setWidgetValue(self, value, context):
        self._box().setField("" if value is None else str(value))

    def widgetValue(self):
        return self._box().currentField() or None

    def _tell(self, *_field) -> None:
        self.widgetValueHasChanged.emit(self)


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
