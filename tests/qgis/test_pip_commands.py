import os
import sys

import pytest
from packaging.requirements import Requirement
from qgis.PyQt.QtNetwork import QNetworkProxy

from semref.processing.packages import components
from semref.processing.packages import install as component_install
from semref.processing.packages.components import CRYPTOGRAPHY, DASK, ONNXRUNTIME, OPENCV, PILLOW, SHAPELY


def test_the_folder_and_opencv_fit_the_versions_of_python_and_numpy():
    assert components.components_key((3, 11, 2), "1.24.2") == "cp311-numpy1.24"
    assert components.components_key((3, 13, 5), "2.2.4") == "cp313-numpy2.2"
    assert OPENCV.requirement("1.24.2") == "opencv-python-headless>=4.5,<4.12"
    assert OPENCV.requirement("2.2.4") == "opencv-python-headless>=4.10,<5.1"


@pytest.mark.parametrize("package", [OPENCV, PILLOW, SHAPELY, ONNXRUNTIME, DASK, CRYPTOGRAPHY])
@pytest.mark.parametrize("numpy_version", ["1.24.2", "2.4.6"])
def test_pip_takes_no_version_that_was_not_tested(package, numpy_version):
    limits = package.requirement(numpy_version).partition(package.pip_name)[2].split(",")
    assert [limit[0] for limit in limits] == [">", "<"]


@pytest.mark.parametrize("package", [OPENCV, PILLOW, SHAPELY, ONNXRUNTIME])
@pytest.mark.parametrize("numpy_version", ["1.24.2", "2.4.6"])
def test_what_comes_from_an_index_is_pinned_to_tested_versions_with_hashes(package, numpy_version):
    lines = package.pinned(numpy_version)
    assert lines
    for line in lines:
        version = line.partition("==")[2].split()[0]
        assert Requirement(package.requirement(numpy_version)).specifier.contains(version)
        assert line.count(" --hash=sha256:") >= 4 and 'python_version < "3.9"' not in line


def test_pip_gets_no_dependencies_no_sources_and_no_index_of_ours():
    online = component_install.pip_arguments(["a<2"], "there", "")
    assert {"--no-deps", "--only-binary=:all:", "--no-input"} <= set(online)
    assert not [argument for argument in online if "index" in argument or "http" in argument]
    offline = component_install.pip_arguments(["a<2"], "there", "wheels")
    assert offline[-4:] == ["--no-index", "--find-links", "wheels", "a<2"]


HTTP, SOCKS = QNetworkProxy.ProxyType.HttpProxy, QNetworkProxy.ProxyType.Socks5Proxy


@pytest.mark.parametrize(
    "proxy, url",
    [
        ([QNetworkProxy.ProxyType.NoProxy], ""),
        ([HTTP], ""),
        ([HTTP, "host", 3128], "http://host:3128"),
        ([HTTP, "host", 3128, "me", "p@ss:/w"], "http://me:p%40ss:%2Fw@host:3128"),  # pragma: allowlist secret
        ([SOCKS, "host", 1080], "socks5://host:1080"),
    ],
    ids=["none", "no host", "http", "with password", "socks"],
)
def test_the_proxy_is_that_of_qgis(proxy, url):
    assert component_install.proxy_url(QNetworkProxy(*proxy)) == url


@pytest.mark.parametrize(
    "output, words",
    [
        ("", "pip could not install a<2"),
        ("WARNING: Retrying (Retry(total=4 …))\nERROR: No matching distribution found for a<2", "cannot be reached"),
        ("ProxyError('Cannot connect to proxy.')", "cannot be reached"),
        ("CERTIFICATE_VERIFY_FAILED", "cannot be reached"),
        ("ERROR: Missing dependencies for SOCKS support.", "cannot be reached"),
        ("OSError: [Errno 28] No space left on device", "disk is full"),
        ("ERROR: No matching distribution found for a<2", "The package index contains no a<2"),
        (
            "ERROR: THESE PACKAGES DO NOT MATCH THE HASHES FROM THE REQUIREMENTS FILE. …",
            "sent a different file for a<2",
        ),
        ("one\nERROR: something else.\n\n", "pip could not install a<2: something else."),
    ],
)
def test_every_failure_of_pip_is_one_sentence(qgis_app, output, words):
    sentence = str(component_install.why_pip_failed("a<2", output, ""))
    assert words in sentence and sentence.endswith(".") and "\n" not in sentence


def test_python_is_looked_for_where_qgis_has_it():
    linux = component_install.python_candidates("/usr/bin/python3", "/usr", (3, 11), False)
    assert linux == ["/usr/bin/python3.11", "/usr/bin/python3", "/usr/bin/bin/python3.11", "/usr/bin/bin/python3"]
    pyenv = component_install.python_candidates("/home/me/.pyenv/shims/python3", "/usr", (3, 11), False)
    assert pyenv[0] == "/usr/bin/python3.11" and pyenv[-1] == "/home/me/.pyenv/shims/python3"
    bundle = "/Applications/QGIS.app/Contents/MacOS"
    mac = component_install.python_candidates(f"{bundle}/QGIS", "/other", (3, 9), False)
    assert f"{bundle}/bin/python3.9" in mac and f"{bundle}/QGIS" not in mac
    prefix = "C:/OSGeo4W/apps/Python312"
    windows = component_install.python_candidates("C:/OSGeo4W/bin/qgis-bin.exe", prefix, (3, 12), True)
    assert windows[0] == os.path.join(prefix, "python.exe")


def test_pip_is_that_of_the_running_python_and_may_install_beside_the_distribution_s(tmp_path, monkeypatch):
    (tmp_path / "bin").mkdir()
    (tmp_path / "bin" / "python3").touch()
    (tmp_path / "EXTERNALLY-MANAGED").touch()
    monkeypatch.setattr(sys, "prefix", str(tmp_path))
    monkeypatch.setattr(sys, "base_prefix", str(tmp_path))
    monkeypatch.setattr(components.sysconfig, "get_path", lambda name: str(tmp_path))
    pip = f"{tmp_path}/bin/python3 -m pip install --no-deps"
    start = f"{pip} --user --break-system-packages "
    assert components.install_command([OPENCV]).startswith(start)
    (tmp_path / "EXTERNALLY-MANAGED").unlink()
    assert components.install_command([OPENCV]).startswith(f'{pip} "opencv-python-headless')
