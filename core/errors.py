"""Errors that a user or their data can cause. The message says what is wrong, with the value, and what to do."""

from __future__ import annotations

from .sentences import Sentence, english


class SemRefError(Exception):
    """Base of all errors that the user can fix.

    The text is English; ``processing/messages`` shows it in the user's language.

    >>> str(LabelMapError("{path} has no pixels.", path="a.tif"))
    'a.tif has no pixels.'
    """

    def __init__(self, message: str | Sentence, /, **values: object) -> None:
        """Make the error.

        Args:
            message: The template, or a complete sentence.
            values: Values of the template's placeholders.
        """
        self.sentence = message if isinstance(message, Sentence) else Sentence(message, **values)
        super().__init__(self.sentence)

    def __str__(self) -> str:
        """Return the message in English."""
        return english(self.sentence)


class ClassTableError(SemRefError):
    """The class table is malformed, or lacks a requested class."""


class LabelMapError(SemRefError):
    """Labels can't be used: a value, the grid or the size of a label map."""


class AnnotationError(SemRefError):
    """A land-cover layer can't become a label map."""


class WindowError(SemRefError):
    """Window size, stride and levels do not fit together or do not fit the map."""


class DatabaseError(SemRefError):
    """A reference database is missing, foreign, truncated or too new."""


class DatabaseInUseError(DatabaseError):
    """Another program is writing the database; the caller can try again soon."""


class UnwritableError(SemRefError):
    """A file can't be written at the chosen path, whatever its content."""


class ParameterError(SemRefError):
    """A parameter has an unusable value."""


class ImageError(SemRefError):
    """An image file can't be read, or a photo can't be segmented."""


class ModelError(SemRefError):
    """A segmentation model is broken, lacks necessary metadata, or does not fit its use."""


class TrainingError(SemRefError):
    """The given data or settings can't train a network."""


class ComponentError(SemRefError):
    """A Python package that SemRef needs can't be installed or removed."""


def reason_of(error: BaseException) -> str:
    """Return the first line of an error of the system or of another library, for use inside a sentence."""
    text = getattr(error, "strerror", None) or str(error) or type(error).__name__
    return text.strip().partition("\n")[0].rstrip(".")
