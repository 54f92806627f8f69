"""onnxruntime's sessions: the only file that uses it."""

from __future__ import annotations

import contextlib
import io
import os
import re
from types import ModuleType
from typing import TYPE_CHECKING, Callable

import cv2

from ..errors import ModelError
from ..sentences import Sentence
from .devices import CPU, CUDA, DIRECTML
from .onnx_file import header_of, smallest_model

if TYPE_CHECKING:
    from onnxruntime import InferenceSession

_IR_VERSION_OF_ALL, _OPSET_OF_ALL, _HIGHEST_ASKED = 4, 11, 100
"""Versions that every onnxruntime knows, and one that none knows."""

_LONGEST_MESSAGE = 1000
"""Characters of a message of onnxruntime that are looked at; names inside a model may be of any length."""


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
    """Return what running a network may raise."""
    return (*_failures(), MemoryError, cv2.error)


def _failures() -> tuple[type[BaseException], ...]:
    """Return the exceptions of onnxruntime, which have no base of their own."""
    from onnxruntime.capi import onnxruntime_pybind11_state as state

    names = (
        "EPFail",
        "EngineError",
        "Fail",
        "InvalidArgument",
        "InvalidGraph",
        "InvalidProtobuf",
        "ModelLoaded",
        "NoModel",
        "NoSuchFile",
        "NotImplemented",
        "RuntimeException",
    )
    return (*(getattr(state, name) for name in names if hasattr(state, name)), RuntimeError, ValueError)


def available_providers() -> list[str]:
    """Return the providers that this onnxruntime has. Raises ModelError where it is missing."""
    return list(_onnxruntime().get_available_providers())


def open_session(path: str, threads: int, provider: str) -> InferenceSession:
    """Open a network on one provider, or on the CPU; a provider that does not start is no silent other one.

    Args:
        threads: Of the CPU.
        provider: onnxruntime's name of what shall run it.

    Raises:
        ModelError: The file can't be used, or the provider not be started.
    """
    onnxruntime = _onnxruntime()
    if not os.path.isfile(path):
        raise ModelError("{path} does not exist; choose a model file (.onnx).", path=path)
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = threads
    # A thread that spins while it waits takes the core from reading and blending.
    options.add_session_config_entry("session.intra_op.allow_spinning", "0")
    # Errors are raised; onnxruntime would write them to a console that QGIS users don't have, too.
    options.log_severity_level = 4
    onnxruntime.set_default_logger_severity(4)
    if provider == DIRECTML.provider:
        # It takes neither (onnxruntime's page on it).
        options.enable_mem_pattern = False
        options.execution_mode = onnxruntime.ExecutionMode.ORT_SEQUENTIAL
    said = _load_libraries(onnxruntime) if provider == CUDA.provider else ""
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
            reason=_left_out(said),
        )
    return session


def _left_out(said: str) -> str | Sentence:
    """Why a provider was left out, as far as that is known."""
    lines = [line for line in said.splitlines() if line.startswith("Failed to load")]
    return reason_of(lines[0]) if lines else Sentence("its driver or its libraries could not be loaded")


def _load_libraries(onnxruntime: ModuleType) -> str:
    """Load CUDA's libraries from Python packages where they lie there; what onnxruntime prints on it."""
    printed = io.StringIO()
    if hasattr(onnxruntime, "preload_dlls"):
        with contextlib.redirect_stdout(printed), contextlib.suppress(RuntimeError, OSError):
            onnxruntime.preload_dlls(directory="")
    return printed.getvalue()


def _why_not_opened(path: str, error: BaseException, version: str) -> Sentence:
    """One sentence for why onnxruntime refused a file; by what is in the file, for messages change with releases."""
    header = header_of(path)
    if header is None:
        return Sentence(
            "{path} is not an ONNX model, or it is damaged or cut short; copy or export it again.", path=path
        )
    known = _newest_known(header.ir_version, lambda ir_version: smallest_model(ir_version, _OPSET_OF_ALL))
    if known < header.ir_version:
        return Sentence(
            "{path} is in ONNX format {found} (IR version), but onnxruntime {version} reads up to {known}; install a "
            "newer onnxruntime or export the model with an older ir_version.",
            path=path,
            found=header.ir_version,
            version=version,
            known=known,
        )
    known = _newest_known(header.opset, lambda opset: smallest_model(_IR_VERSION_OF_ALL, opset))
    if known < header.opset:
        return Sentence(
            "{path} uses ONNX operators of version {found} (opset), but onnxruntime {version} knows up to {known}; "
            "install a newer onnxruntime or export the model with an older opset.",
            path=path,
            found=header.opset,
            version=version,
            known=known,
        )
    missing = header.missing_weights(path)
    if missing:
        return Sentence(
            "{path} keeps its weights in another file that is missing or cut short; put it beside the model under its "
            "old name ({reason}).",
            path=path,
            reason=missing,
        )
    return Sentence(
        "{path} can't be run by onnxruntime {version}: {reason}.", path=path, version=version, reason=reason_of(error)
    )


def _newest_known(asked: int, model: Callable[[int], bytes]) -> int:
    """Return the highest version up to the one asked for that onnxruntime opens a model of."""
    for tried in range(min(asked, _HIGHEST_ASKED), 0, -1):
        if _opens(model(tried)):
            return asked if tried == min(asked, _HIGHEST_ASKED) < _HIGHEST_ASKED else tried
    return 0


def _opens(model: bytes) -> bool:
    onnxruntime = _onnxruntime()
    from onnxruntime.capi import onnxruntime_pybind11_state as state

    options = onnxruntime.SessionOptions()
    options.log_severity_level = 4
    try:
        onnxruntime.InferenceSession(model, options, providers=[CPU.provider])
    except state.NotImplemented:
        # The version is known, but this build lacks the one operator.
        return True
    except _failures():
        return False
    return True


def reason_of(error: object) -> str:
    """Return the last part of onnxruntime's message, without its error code and source files, as part of a sentence."""
    text = re.sub(r"\[ONNXRuntimeError\] : \d+ : [A-Z_]+ : ", "", " ".join(str(error)[:_LONGEST_MESSAGE].split()))
    text = re.sub(r"\S*/onnxruntime/\S+:\d+ [^\n]*?\) ", "", text)
    return re.sub(r"\.\s+(?=[A-Z])", "; ", text)[:300].rstrip(". ")
