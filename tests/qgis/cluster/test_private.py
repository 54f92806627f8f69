"""Worker processes on this machine accept only the run that started them."""

import contextlib
import os
import socket
import ssl
import stat
import tempfile
import urllib.error
import urllib.request

import pytest

distributed = pytest.importorskip("distributed", reason="Dask is not here (tools/requirements-dev.txt)")
psutil = pytest.importorskip("psutil")


@pytest.fixture(scope="module")
def workers(tmp_path_factory):
    """Return (client, ports, folder) of two workers: listening ports, and the folder of temporary files."""
    from semref.cluster import engine

    folder = tmp_path_factory.mktemp("temporary")
    before = set(listening())
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(tempfile, "tempdir", str(folder))
        with engine.connect(None, 2, lambda _: None) as client:
            yield client, set(listening()) - before, folder
    assert list(folder.iterdir()) == []


def listening():
    """Return the (address, port) of each listening socket of this process and its children."""
    me = psutil.Process()
    for process in [me, *me.children(recursive=True)]:
        sockets = getattr(process, "net_connections", process.connections)
        yield from (tuple(one.laddr) for one in sockets(kind="inet") if one.status == psutil.CONN_LISTEN)


def test_nothing_listens_on_other_interfaces(workers):
    _, places, _ = workers
    assert len(places) >= 5
    assert {address for address, _ in places} == {"127.0.0.1"}


@pytest.mark.parametrize("scheme", ["tcp", "tls"])
def test_a_stranger_runs_no_code(workers, scheme):
    """A stranger has no certificate, or one of another run."""
    client, _, _ = workers
    address = f"{scheme}://{client.scheduler.address.partition('://')[2]}"
    security = distributed.Security.temporary() if scheme == "tls" else None
    with pytest.raises(OSError), distributed.Client(address, security=security, timeout=2) as other:
        pytest.fail(f"It ran there, as process {other.run_on_scheduler(os.getpid)}.")


def test_every_port_refuses_who_has_no_certificate_and_has_no_pages(workers):
    _, places, _ = workers
    context = ssl.create_default_context()
    context.check_hostname, context.verify_mode = False, ssl.CERT_NONE
    for _, port in sorted(places):
        answers = {answer(port, page) for page in ("status", "info/main/workers.html", "json/identity.json", "health")}
        assert answers in ({404}, {None})
        if answers == {None}:
            with socket.create_connection(("127.0.0.1", port), 5) as plain, contextlib.suppress(OSError):
                assert context.wrap_socket(plain).recv(1) == b""


def answer(port, page):
    """Return the status of a web page, or None from another kind of server."""
    try:
        with urllib.request.urlopen(f"http://127.0.0.1:{port}/{page}", timeout=5) as found:
            return found.status
    except urllib.error.HTTPError as error:
        return error.code
    except OSError:
        return None


@pytest.mark.slow
def test_files_of_the_workers_are_private(workers):
    client, _, folder = workers
    (private,) = folder.iterdir()
    assert stat.S_IMODE(private.stat().st_mode) == 0o700
    used = client.run(lambda dask_worker: dask_worker.local_directory).values()
    assert len(used) == 2 and all(str(private) in one for one in used)
