import contextlib
import os
import socket
import ssl
import stat
import tempfile
import threading
import time
import urllib.error
import urllib.request

import pytest

from semref.core.errors import SemRefError

distributed = pytest.importorskip("distributed", reason="Dask is not here (tools/requirements-dev.txt)")
psutil = pytest.importorskip("psutil")


@pytest.fixture
def server():
    """`server(words)`: address of a server that answers with these words; with None it hangs up at once."""
    opened = []

    def serve(listener, words):
        while True:
            try:
                one, _ = listener.accept()
            except OSError:
                return
            if words is None:
                one.close()
                continue
            opened.append(one)
            one.sendall(words)

    def start(words):
        listener = socket.create_server(("127.0.0.1", 0))
        opened.append(listener)
        threading.Thread(target=serve, args=(listener, words), daemon=True).start()
        return f"tcp://127.0.0.1:{listener.getsockname()[1]}"

    yield start
    for one in opened:
        one.close()


@pytest.fixture
def connection(monkeypatch):
    from semref.cluster import engine

    monkeypatch.setattr(engine, "_REFUSED_FOR_S", 0.3)
    return engine


@pytest.fixture
def hasty(connection, monkeypatch):
    monkeypatch.setattr(connection, "CONNECTED_WITHIN_S", 1)
    return connection


def answer_of(connection, address):
    """Return the code and the reason of the message."""
    with pytest.raises(SemRefError) as caught:
        connection.require_scheduler(address)
    values = dict(caught.value.sentence.values)
    assert values["address"] == address
    return caught.value.sentence.template, values.get("reason", "")


NO_SCHEDULER = (
    "There is no scheduler at {address} ({reason}); start one, or have processes started on this machine: local:4."
)


@pytest.mark.parametrize("words", [b"HTTP/1.1 400 Bad Request\r\n\r\n", b"SSH-2.0-OpenSSH_9.2\r\n"])
def test_another_server_such_as_the_dashboard_is_recognized(connection, server, words):
    code, reason = answer_of(connection, server(words))
    assert code.startswith("The program at {address} is not a Dask scheduler") and reason == ""


def test_silent_servers_end_in_a_timeout_and_those_that_hang_up_are_no_schedulers(hasty, server):
    assert answer_of(hasty, server(b"")) == (NO_SCHEDULER, "no answer within 1 s")
    assert answer_of(hasty, server(None))[0] == NO_SCHEDULER


@pytest.mark.parametrize(
    ("address", "reason"),
    [
        ("tcp://127.0.0.1:1", "Connection refused"),
        ("tls://127.0.0.1:1", "Connection refused"),
        ("tcp://127.0.0.1", "missing port"),
        ("somewhere", "missing port"),
        ("http://127.0.0.1:1", "unknown address scheme"),
    ],
)
def test_a_wrong_or_closed_address_is_refused(connection, address, reason):
    code, said = answer_of(connection, address)
    assert code == NO_SCHEDULER and reason in said


def test_a_scheduler_that_is_just_being_started_is_waited_for(hasty, monkeypatch):
    """The port is closed at first and opens later."""
    monkeypatch.setattr(hasty, "_REFUSED_FOR_S", 30.0)
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    begun = []

    def late(_):
        if not begun:
            begun.append(socket.create_server(("127.0.0.1", port)))

    monkeypatch.setattr(time, "sleep", late)
    try:
        assert answer_of(hasty, f"tcp://127.0.0.1:{port}") == (NO_SCHEDULER, "no answer within 1 s")
    finally:
        begun[0].close()


def test_a_scheduler_is_found(connection):
    from distributed import LocalCluster

    with LocalCluster(n_workers=0, dashboard_address=None) as cluster:
        connection.require_scheduler(cluster.scheduler_address)


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
