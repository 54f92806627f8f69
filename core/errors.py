"""Errors a user or their data can cause; each message is one sentence that says what to do."""


class SemRefError(Exception):
    """Base of every error that the user can mend; its text is shown to them as it is."""


class ClassTableError(SemRefError):
    """The class table is malformed, or the asked classes are not in it."""


class LabelMapError(SemRefError):
    """A label map or label image can't be used as one."""


class AnnotationError(SemRefError):
    """An annotation layer can't be turned into a label map."""


class WindowError(SemRefError):
    """Window size, stride or levels don't fit together or don't fit the map."""


class DatabaseError(SemRefError):
    """A reference database is missing, foreign, truncated or too new."""


class ParameterError(SemRefError):
    """A parameter has a value that can't be used."""


class ImageError(SemRefError):
    """A photo or orthophoto can't be read or segmented."""


class ModelError(SemRefError):
    """A segmentation model is broken, says too little about itself, or doesn't fit what it is used for."""


class ComponentError(SemRefError):
    """A Python package that SemRef needs can't be installed or removed."""
