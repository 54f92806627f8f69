"""Whether a scheduler answers: Dask alone asks a closed port for long, and waits for a mute one for ever."""

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
"""How long a scheduler, or a tunnel to it, that is just being started may refuse."""

_ASKED_AGAIN_AFTER_S = 0.2


def require_scheduler(address: str) -> None:
    """Raises SemRefError where no scheduler answers.

    Args:
        address: As the user gives it.
    """
    try:
        _require_listening(address)
        asyncio.run(_greeted(address))
    except asyncio.TimeoutError:
        reason = f"no answer within {CONNECTED_WITHIN_S} s"
        raise no_scheduler(address, reason) from None
    except (OSError, ValueError) as error:
        raise no_scheduler(address, reason_of(error)) from None
    except (MemoryError, RuntimeError, TypeError, KeyError, AttributeError):
        # What others say is read as numbers of bytes, or as anything else.
        raise SemRefError(
            "What answers at {address} is no scheduler of Dask, or one of another version; give the address that the "
            "scheduler prints, not its dashboard's.",
            address=address,
        ) from None


def no_scheduler(address: str, reason: str) -> SemRefError:
    """The error for an address where no scheduler answers."""
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


async def _greeted(address: str) -> None:
    """Changes greetings, as the client will."""
    given = Security().get_connection_args("client")
    comm = await asyncio.wait_for(connect(address, timeout=CONNECTED_WITHIN_S, **given), CONNECTED_WITHIN_S)
    await comm.close()
