"""Builds the Python package for pip (PEP 517), with CMake and what Debian has: nothing is fetched.

The package brings its own data and module along, below pastoso/share and pastoso/lib, so that it works in any
environment. CMAKE_ARGS may hold more options for CMake.
"""

import base64
import hashlib
import os
import re
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build" / "wheel"
# Of every file in an archive, so that the same source gives the same bytes.
MOMENT = (1980, 1, 1, 0, 0, 0)


def version() -> str:
    return re.search(r"project\(Pastoso VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


def project(key: str) -> str:
    """A text of the table [project]; Python before 3.11 has no reader of TOML."""
    return re.search(rf'^{key} = "(.*)"$', (ROOT / "pyproject.toml").read_text(), re.M).group(1)


def needed() -> list:
    """The list `dependencies` of that table."""
    listed = re.search(r"^dependencies = \[(.*)\]$", (ROOT / "pyproject.toml").read_text(), re.M).group(1)
    return re.findall(r'"(.*?)"', listed)


def metadata() -> str:
    needs = "".join(f"Requires-Dist: {package}\n" for package in needed())
    return (f"Metadata-Version: 2.1\nName: {project('name')}\nVersion: {version()}\nSummary: {project('description')}\n"
            f"License: GPL-3.0-or-later\nRequires-Python: {project('requires-python')}\n{needs}"
            f"Description-Content-Type: text/markdown\n\n{(ROOT / 'docs/python.md').read_text()}")


def run(*command: object) -> None:
    try:
        subprocess.run([str(word) for word in command], check=True)
    except FileNotFoundError:
        sys.exit(f"{command[0]} is missing; on Debian 12, packaging/install.sh installs what the build needs.")
    except subprocess.CalledProcessError as error:
        sys.exit(f"{command[0]} failed with status {error.returncode}; its message stands above.")


def build_package() -> Path:
    """Builds and installs into a folder of its own; returns the folder that holds pastoso/."""
    options = ["-DCMAKE_BUILD_TYPE=Release", "-DPASTOSO_BUILD_APP=OFF", "-DPASTOSO_BUILD_TESTS=OFF",
               "-DPASTOSO_BUILD_PYTHON=ON", f"-DPython3_EXECUTABLE={sys.executable}", "-DPASTOSO_PYTHON_FOLDER=python"]
    generator = ["-G", "Ninja"] if shutil.which("ninja") else []
    run("cmake", "-S", ROOT, "-B", BUILD, *generator, *options, *shlex.split(os.environ.get("CMAKE_ARGS", "")))
    jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL") or str(os.cpu_count())
    run("cmake", "--build", BUILD, "--parallel", jobs, "--target", "pastoso_python", "pastoso_images")
    prefix = BUILD / "package"
    shutil.rmtree(prefix, ignore_errors=True)
    # Of the programs' files only data and module: the programs themselves are not built.
    for part, component in ((".", "python"), ("resources", "cli"), ("engine/files", "cli")):
        run("cmake", "--install", BUILD / part, "--prefix", prefix, "--component", component, "--strip")
    for part in ("share/pastoso", "lib/pastoso"):
        shutil.move(prefix / part, prefix / "python" / "pastoso" / part)
    return prefix / "python"


def write_wheel(path: Path, files: dict) -> None:
    record = []
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as wheel:
        for name, content in sorted(files.items()):
            entry = zipfile.ZipInfo(name, MOMENT)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o755 if name.endswith(".so") else 0o644) << 16
            wheel.writestr(entry, content)
            if not name.endswith("RECORD"):
                digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
                record.append(f"{name},sha256={digest},{len(content)}\n")
        folder = f"{project('name')}-{version()}.dist-info"
        record.append(f"{folder}/RECORD,,\n")
        wheel.writestr(zipfile.ZipInfo(f"{folder}/RECORD", MOMENT), "".join(record))


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    tag = f"{python}-{python}-{platform}"
    package = build_package()
    files = {str(file.relative_to(package)): file.read_bytes() for file in package.rglob("*") if file.is_file()}
    folder = f"{project('name')}-{version()}.dist-info"
    files[f"{folder}/METADATA"] = metadata().encode()
    files[f"{folder}/WHEEL"] = (f"Wheel-Version: 1.0\nGenerator: pastoso\nRoot-Is-Purelib: false\nTag: {tag}\n").encode()
    name = f"{project('name')}-{version()}-{tag}.whl"
    write_wheel(Path(wheel_directory) / name, files)
    return name


def build_sdist(sdist_directory, config_settings=None):
    folder = f"{project('name')}-{version()}"
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-z"], check=True, capture_output=True).stdout
    with tarfile.open(Path(sdist_directory) / f"{folder}.tar.gz", "w:gz", format=tarfile.PAX_FORMAT) as archive:
        for name in filter(None, listed.decode().split("\0")):
            archive.add(ROOT / name, f"{folder}/{name}", recursive=False)
        information = BUILD / "PKG-INFO"
        information.parent.mkdir(parents=True, exist_ok=True)
        information.write_text(metadata())
        archive.add(information, f"{folder}/PKG-INFO")
    return f"{folder}.tar.gz"
