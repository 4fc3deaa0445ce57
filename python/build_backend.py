# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""What pip calls (PEP 517): builds with CMake and packs the core, the plugins, the configs and the models beside the modules.

With GESTALT_BUILD a build tree is used, and brought up to date; otherwise a build of its own is made and thrown away.
"""

import base64
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

SOURCE = pathlib.Path(__file__).parent.parent
# Its values are written as in JSON; Python 3.10 has no tomllib.
PROJECT = {key: json.loads(value) for key, value in
           re.findall(r"^(\S+) = (.+)$", (SOURCE / "pyproject.toml").read_text().split("[project]")[1], re.MULTILINE)}
MODULES = pathlib.Path("lib", "python3", "dist-packages", "gestalt")


def version():
    return re.search(r"project\(\s*\w+\s+VERSION\s+([\d.]+)", (SOURCE / "CMakeLists.txt").read_text())[1]


def cmake(*words):
    subprocess.run(["cmake", *map(str, words)], check=True, stdout=sys.stderr)


# The schema is made by the command with all plugins; the codecs are loaded when a file needs them.
TARGETS = ("config_schema", "gestalt_python", "gestalt_image_codecs")
COMPONENTS = ("runtime", "python")


def configure(build):
    """A build tree with the modules of this interpreter."""
    options = ["-S", SOURCE, "-B", build, "-DGESTALT_PYTHON=ON", f"-DPython_EXECUTABLE={os.path.realpath(sys.executable)}"]
    if not (build / "CMakeCache.txt").exists():
        options += ["-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_UNITY_BUILD=ON"]  # as scripts/demo builds
    try:
        cmake(*options)
    except (OSError, subprocess.CalledProcessError) as error:
        raise SystemExit(
            "gestalt cannot be configured; the lines above say what is missing. On Debian 12, "
            "scripts/install_dependencies --python installs all that is needed"
        ) from error


def install(build, prefix):
    """Builds what the package needs and installs it."""
    configure(build)
    cmake("--build", build, "--target", *TARGETS)
    for component in COMPONENTS:
        cmake("--install", build, "--prefix", prefix, "--component", component)


def contents(prefix):
    """Files of the wheel by their names in it."""
    for file in sorted((prefix / MODULES).iterdir()):
        yield f"gestalt/{file.name}", file
    for folder in (prefix / "lib", prefix / "share"):
        for file in sorted(folder.rglob("*")):
            inside = file.relative_to(prefix)
            # What is loaded is the library's SONAME; zip files hold no links.
            development = file.suffix == ".so" and file.is_symlink()
            if file.is_file() and inside.parts[:2] != ("lib", "python3") and not development:
                yield f"gestalt/{inside}", file


def metadata():
    lines = ["Metadata-Version: 2.1", f"Name: {PROJECT['name']}", f"Version: {version()}",
             f"Summary: {PROJECT['description']}", f"Requires-Python: {PROJECT['requires-python']}",
             "License: BSD-3-Clause"]
    return "\n".join(lines + [f"Requires-Dist: {name}" for name in PROJECT["dependencies"]]) + "\n"


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """So that pip does not build everything to learn the name."""
    information = f"{PROJECT['name']}-{version()}.dist-info"
    folder = pathlib.Path(metadata_directory, information)
    folder.mkdir()
    (folder / "METADATA").write_text(metadata())
    return information


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    interpreter = f"cp{sys.version_info.major}{sys.version_info.minor}"
    tag = f"{interpreter}-{interpreter}-{re.sub('[-.]', '_', sysconfig.get_platform())}"
    name = f"{PROJECT['name']}-{version()}"
    information = f"{name}.dist-info"
    record = []

    def add(wheel, inside, data):
        wheel.writestr(zipfile.ZipInfo(inside), data, zipfile.ZIP_DEFLATED)
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        record.append(f"{inside},sha256={digest},{len(data)}")

    with tempfile.TemporaryDirectory() as work:
        build = pathlib.Path(os.environ.get("GESTALT_BUILD") or pathlib.Path(work, "build"))
        prefix = pathlib.Path(work, "prefix")
        install(build, prefix)
        with zipfile.ZipFile(pathlib.Path(wheel_directory, f"{name}-{tag}.whl"), "w") as wheel:
            for inside, file in contents(prefix):
                add(wheel, inside, file.read_bytes())
            add(wheel, f"{information}/METADATA", metadata().encode())
            add(wheel, f"{information}/WHEEL",
                f"Wheel-Version: 1.0\nGenerator: gestalt\nRoot-Is-Purelib: false\nTag: {tag}\n".encode())
            record.append(f"{information}/RECORD,,")
            wheel.writestr(f"{information}/RECORD", "\n".join(record) + "\n")
    return f"{name}-{tag}.whl"


def build_sdist(sdist_directory, config_settings=None):
    raise NotImplementedError("there is no source distribution of gestalt; install from a checkout")
