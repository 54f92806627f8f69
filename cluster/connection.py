"""Check that a scheduler answers. Dask itself retries a closed port for long and waits forever for a silent one."""

from __future__ import annotations

import asyncio
import contextlib
import socket
import time

from distributed.comm import connect
from distributed.comm.addressing import parse_address, parse_host_port
from distributed.security import Security

from ..core.errors import SemRefError, reason_of

CONNECTED_WITHIN_S = 15

_REFUSED_FOR_S = 3.0
"""How long to retry while a scheduler, or a tunnel to it, starts and refuses connections."""

_ASKED_AGAIN_AFTER_S = 0.2


def require_scheduler(address: str) -> None:
    """Raise SemRefError if no scheduler answers at an address."""
    try:
        _require_listening(address)
        asyncio.run(_greet(address))
    except asyncio.TimeoutError:
        reason = f"no answer within {CONNECTED_WITHIN_S} s"
        raise no_scheduler(address, reason) from None
    except (OSError, ValueError) as error:
        raise no_scheduler(address, reason_of(error)) from None
    except (MemoryError, RuntimeError, TypeError, KeyError, AttributeError):
        # Answers of other programs are misread as message sizes and types.
        raise SemRefError(
            "The program at {address} is not a Dask scheduler, or has another version. Enter the address that the "
            "scheduler prints, not the address of its dashboard.",
            address=address,
        ) from None


def no_scheduler(address: str, reason: str) -> SemRefError:
    """Return the error for an address without a scheduler."""
    return SemRefError(
        "There is no scheduler at {address} ({reason}); start one, or have processes started on this machine: local:4.",
        address=address,
        reason=reason,
    )


def _require_listening(address: str) -> None:
    scheme, place = parse_address(address)
    if scheme not in ("tcp", "tls"):
        return
    until = time.monotonic() + _REFUSED_FOR_S
    while True:
        try:
            with contextlib.closing(socket.create_connection(parse_host_port(place), CONNECTED_WITHIN_S)):
                return
        except ConnectionRefusedError:
            if time.monotonic() > until:
                raise
        time.sleep(_ASKED_AGAIN_AFTER_S)


async def _greet(address: str) -> None:
    """Connect as the client will, and close."""
    given = Security().get_connection_args("client")
    comm = await asyncio.wait_for(connect(address, timeout=CONNECTED_WITHIN_S, **given), CONNECTED_WITHIN_S)
    await comm.close()
