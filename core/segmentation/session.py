"""Sessions of onnxruntime; no other file imports it."""

from __future__ import annotations

import contextlib
import io
import os
import re
from types import ModuleType
from typing import TYPE_CHECKING

import cv2

from ..errors import ModelError
from ..sentences import Sentence
from .devices import CPU, CUDA, DIRECTML
from .onnx_file import header_of, no_model_file, no_onnx_model

if TYPE_CHECKING:
    from onnxruntime import InferenceSession

_LONGEST_MESSAGE = 1000
"""Characters of a message of onnxruntime that are processed; names inside a model may have any length."""


def _onnxruntime() -> ModuleType:
    try:
        import onnxruntime
    except ImportError as error:
        raise ModelError(
            "Segmentation needs the Python package onnxruntime ({reason}); install it for QGIS's Python, for example "
            "with “python3 -m pip install onnxruntime”.",
            reason=str(error),
        ) from None
    return onnxruntime


def failures_of_a_run() -> tuple[type[BaseException], ...]:
    """Return the exceptions that running a network may raise."""
    return (*_failures(), MemoryError, cv2.error)


def _failures() -> tuple[type[BaseException], ...]:
    """Return the exceptions of onnxruntime, which have no common base class."""
    from onnxruntime.capi import onnxruntime_pybind11_state as state

    kinds = [kind for kind in vars(state).values() if isinstance(kind, type) and issubclass(kind, Exception)]
    return (*kinds, RuntimeError, ValueError)


def available_providers() -> list[str]:
    """Return the providers of this onnxruntime. Raises ModelError if it is missing."""
    return list(_onnxruntime().get_available_providers())


def open_session(path: str, threads: int, provider: str) -> InferenceSession:
    """Open a network on one provider or on the CPU, without a silent fallback to another provider.

    Raises:
        ModelError: The file can't be used, or the provider does not start.
    """
    onnxruntime = _onnxruntime()
    if not os.path.isfile(path):
        raise ModelError(no_model_file(path))
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = threads
    # A thread that spins while it waits slows down reading and blending.
    options.add_session_config_entry("session.intra_op.allow_spinning", "0")
    # Errors are raised; onnxruntime would also write them to a console, which QGIS users do not have.
    options.log_severity_level = 4
    onnxruntime.set_default_logger_severity(4)
    if provider == DIRECTML.provider:
        # DirectML supports neither (onnxruntime's documentation).
        options.enable_mem_pattern = False
        options.execution_mode = onnxruntime.ExecutionMode.ORT_SEQUENTIAL
    printed = _load_libraries(onnxruntime) if provider == CUDA.provider else ""
    providers = [provider] if provider == CPU.provider else [provider, CPU.provider]
    try:
        session = onnxruntime.InferenceSession(path, options, providers=providers)
    except _failures() as error:
        raise ModelError(_why_not_opened(path, error, onnxruntime.__version__)) from error
    session.disable_fallback()
    if session.get_providers()[:1] != [provider]:
        raise ModelError(
            "{path} can't be run by onnxruntime {version}: {reason}.",
            path=path,
            version=onnxruntime.__version__,
            reason=_left_out(printed),
        )
    return session


def _left_out(printed: str) -> str | Sentence:
    """Return why a provider was left out, if known."""
    lines = [line for line in printed.splitlines() if line.startswith("Failed to load")]
    return reason_of(lines[0]) if lines else Sentence("its driver or its libraries could not be loaded")


def _load_libraries(onnxruntime: ModuleType) -> str:
    """Load CUDA's libraries from Python packages, if present; return what onnxruntime prints."""
    printed = io.StringIO()
    if hasattr(onnxruntime, "preload_dlls"):
        with contextlib.redirect_stdout(printed), contextlib.suppress(RuntimeError, OSError):
            onnxruntime.preload_dlls(directory="")
    return printed.getvalue()


def _why_not_opened(path: str, error: BaseException, version: str) -> Sentence:
    """Return why onnxruntime refused a file, from the file's content, because messages change with releases."""
    header = header_of(path)
    if header is None:
        return no_onnx_model(path)
    missing = header.missing_weights(path)
    if missing:
        return Sentence(
            "The weights of {path} are in another file, which is missing or incomplete. Copy it next to the model "
            "under its original name ({reason}).",
            path=path,
            reason=missing,
        )
    return Sentence(
        "{path} can't be run by onnxruntime {version}: {reason}.", path=path, version=version, reason=reason_of(error)
    )


def reason_of(error: object) -> str:
    """Return the last part of onnxruntime's message, without error code and source files, for use inside a sentence."""
    text = re.sub(r"\[ONNXRuntimeError\] : \d+ : [A-Z_]+ : ", "", " ".join(str(error)[:_LONGEST_MESSAGE].split()))
    text = re.sub(r"\S*/onnxruntime/\S+:\d+ [^\n]*?\) ", "", text)
    return re.sub(r"\.\s+(?=[A-Z])", "; ", text)[:300].rstrip(". ")
