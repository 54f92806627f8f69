"""Errors a user or their data can cause; each says one sentence: what is wrong, with the value, and what to do."""

from __future__ import annotations

from .sentences import Sentence, english


class SemRefError(Exception):
    """Base of every error that the user can fix.

    Its text is English; ``processing/messages`` says the same in the user's language.

    >>> str(LabelMapError("{path} has no pixels.", path="a.tif"))
    'a.tif has no pixels.'

    Attributes:
        sentence: What is said to the user.
    """

    def __init__(self, said: str | Sentence, /, **values: object) -> None:
        """Makes the error.

        Args:
            said: The template, or a sentence that was made already.
            values: The values that the template names.
        """
        self.sentence = said if isinstance(said, Sentence) else Sentence(said, **values)
        super().__init__(self.sentence)

    def __str__(self) -> str:
        """The sentence in English."""
        return english(self.sentence)


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


class DatabaseInUseError(DatabaseError):
    """Another program is writing the database; it will be done soon."""


class UnwritableError(SemRefError):
    """A file can't be written where the user wants it, whatever is in it."""


class ParameterError(SemRefError):
    """A parameter has a value that can't be used."""


class ImageError(SemRefError):
    """A photo or orthophoto can't be read or segmented."""


class ModelError(SemRefError):
    """A segmentation model is broken, says too little about itself, or doesn't fit what it is used for."""


class TrainingError(SemRefError):
    """A network can't be trained with what is given."""


class ComponentError(SemRefError):
    """A Python package that SemRef needs can't be installed or removed."""


def reason_of(error: BaseException) -> str:
    """Return the first line of an error of the system or of another library, as part of a sentence."""
    text = getattr(error, "strerror", None) or str(error) or type(error).__name__
    return text.strip().partition("\n")[0].rstrip(".")
