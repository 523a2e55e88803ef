"""Builds wheels and source archives of the Python package, for pip (PEP 517) and for CMake.

It needs nothing but Python, CMake and the C++ libraries of the project, so that pip builds without
a network.

    pip install .                                             builds a wheel for this machine
    python3 src/doors/python/poinsot_build.py wheel BUILD FOLDER …  from a build; self-contained (CMake's --target wheel)
    python3 src/doors/python/poinsot_build.py metadata FOLDER       writes the .dist-info of an installed package
"""

from __future__ import annotations

import base64
import gzip
import hashlib
import io
import os
import re
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile
from pathlib import Path

root = Path(__file__).resolve().parents[3]

# What a self-contained wheel takes from the machine, as manylinux wheels do.
of_the_machine = re.compile(
    r"(ld-linux.*|libc|libm|libmvec|libpthread|libdl|librt|libresolv|libutil|libanl|libstdc\+\+|libgcc_s|libpython.*)\.so.*"
)
fonts = ["latinmodern-math", "lmsans10-regular", "lmsans10-bold", "lmsans10-oblique", "lmroman10-regular",
         "lmroman10-bold", "lmroman10-italic"]


def project() -> dict:
    """The table [project] of pyproject.toml."""
    text = (root / "pyproject.toml").read_text(encoding="utf-8")
    try:
        import tomllib

        return tomllib.loads(text)["project"]
    except ImportError:  # Python 3.9 and 3.10: the few lines that are needed here
        table = text[text.index("[project]"):].split("\n[", 1)[0]
        found: dict = dict(re.findall(r'^([a-z-]+) = "(.*)"$', table, re.MULTILINE))
        found["dependencies"] = re.findall(r'"([^"]+)"', re.search(r"^dependencies = \[(.*)\]", table, re.MULTILINE)[1])
        extras = text[text.index("[project.optional-dependencies]"):].split("\n[", 1)[0]
        found["optional-dependencies"] = {
            name: re.findall(r'"([^"]+)"', packages)
            for name, packages in re.findall(r"^([a-z-]+) = \[(.*)\]", extras, re.MULTILINE)
        }
        return found


def metadata() -> str:
    about = project()
    lines = ["Metadata-Version: 2.1", f"Name: {about['name']}", f"Version: {about['version']}",
             f"Summary: {about['description']}", f"Requires-Python: {about['requires-python']}", "License-File: LICENSE"]
    lines += [f"Requires-Dist: {one}" for one in about["dependencies"]]
    for extra, packages in about.get("optional-dependencies", {}).items():
        lines.append(f"Provides-Extra: {extra}")
        lines += [f'Requires-Dist: {one}; extra == "{extra}"' for one in packages]
    lines.append("Description-Content-Type: text/markdown")
    return "\n".join(lines) + "\n\n" + (root / "README.md").read_text(encoding="utf-8")


def info_files() -> dict:
    """The files of the .dist-info, but for WHEEL and RECORD."""
    return {
        "METADATA": metadata().encode("utf-8"),
        "LICENSE": (root / "LICENSE").read_bytes(),
        "entry_points.txt": b"[pytest11]\npoinsot = poinsot.pytest_plugin\n",
        "top_level.txt": b"poinsot\n",
    }


def built(config_settings: dict | None) -> Path:
    """Builds the package by CMake; returns the build folder."""
    settings = config_settings or {}
    build = Path(settings.get("build-dir", root / "build" / "python"))
    generator = ["-G", "Ninja"] if shutil.which("ninja") else []
    options = [f"-D{key}={value}" for key, value in settings.items() if key != "build-dir"]
    # pip's own environment hides the distribution's Python packages, which the build's tools need.
    environment = {key: value for key, value in os.environ.items() if not key.startswith("PYTHON")}
    subprocess.run(["cmake", "-S", root, "-B", build, *generator, "-DCMAKE_BUILD_TYPE=Release", "-DBUILD_TESTING=OFF",
                    "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_UNITY_BUILD_BATCH_SIZE=24", "-DPOINSOT_PYTHON=ON", "-DPOINSOT_PAGE=auto",
                    f"-DPython_EXECUTABLE={sys.executable}", *options], check=True, env=environment)
    subprocess.run(["cmake", "--build", build, "--target", "poinsot_python", "--parallel"], check=True,
                   env=environment)
    return build


def package_files(build: Path) -> dict:
    """The files of the package. Of the build folder only the module of this Python: the rest may be older."""
    source = root / "src" / "doors" / "python" / "poinsot"
    module = build / "python" / "poinsot" / ("_poinsot" + sysconfig.get_config_var("EXT_SUFFIX"))
    files = [module, *(path for path in source.iterdir() if path.suffix in (".py", ".pyi") or path.name == "py.typed")]
    found = {f"poinsot/{path.name}": path.read_bytes() for path in files}
    for path in (root / "scenes").rglob("*"):
        if path.is_file() and "__pycache__" not in path.parts:
            found["poinsot/scenes/" + path.relative_to(root / "scenes").as_posix()] = path.read_bytes()
    return dict(sorted(found.items()))


def python_tag() -> str:
    return f"cp{sys.version_info[0]}{sys.version_info[1]}"


def write_wheel(folder: Path, platform: str, files: dict) -> str:
    """Writes a wheel; its bytes depend on the files alone. Returns its name."""
    about = project()
    base = f"{about['name']}-{about['version']}"
    tag = f"{python_tag()}-{python_tag()}-{platform}"
    info = f"{base}.dist-info"
    contents = dict(files)
    contents.update({f"{info}/{name}": data for name, data in info_files().items()})
    contents[f"{info}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: poinsot\nRoot-Is-Purelib: false\nTag: {tag}\n".encode()
    record = []
    for name, data in contents.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        record.append(f"{name},sha256={digest},{len(data)}")
    contents[f"{info}/RECORD"] = ("\n".join(record) + f"\n{info}/RECORD,,\n").encode()
    name = f"{base}-{tag}.whl"
    folder.mkdir(parents=True, exist_ok=True)
    part = folder / (name + ".part")
    with zipfile.ZipFile(part, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, data in contents.items():
            entry = zipfile.ZipInfo(path)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o755 if ".so" in Path(path).name else 0o644) << 16
            archive.writestr(entry, data)
    part.replace(folder / name)
    return name


# What pip calls.


def get_requires_for_build_wheel(config_settings=None) -> list:
    return []


def get_requires_for_build_sdist(config_settings=None) -> list:
    return []


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None) -> str:
    return write_metadata(Path(metadata_directory)).name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None) -> str:
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    return write_wheel(Path(wheel_directory), platform, package_files(built(config_settings)))


def build_sdist(sdist_directory, config_settings=None) -> str:
    about = project()
    base = f"{about['name']}-{about['version']}"
    names = subprocess.run(["git", "-C", root, "ls-files", "-z"], capture_output=True, text=True, check=True).stdout
    name = f"{base}.tar.gz"
    target = Path(sdist_directory) / name
    with gzip.GzipFile(target, "wb", mtime=0) as packed, tarfile.open(fileobj=packed, mode="w", format=tarfile.PAX_FORMAT) as archive:
        def add(path: str, data: bytes, mode: int) -> None:
            entry = tarfile.TarInfo(f"{base}/{path}")
            entry.size = len(data)
            entry.mode = mode
            archive.addfile(entry, io.BytesIO(data))

        add("PKG-INFO", metadata().encode("utf-8"), 0o644)
        for path in sorted(filter(None, names.split("\0"))):
            file = root / path
            if file.is_file():
                add(path, file.read_bytes(), 0o755 if os.access(file, os.X_OK) else 0o644)
    return name


# What CMake calls.


def libraries_of(files: list) -> dict:
    """Name → file of every library that these need, but for those of the machine."""
    found = {}
    for file in files:
        listed = subprocess.run(["ldd", file], capture_output=True, text=True, check=True).stdout
        for name, where in re.findall(r"^\s*(\S+) => (\S+)", listed, re.MULTILINE):
            if where == "not":
                raise SystemExit(f"{file}: {name} is missing")
            if not of_the_machine.fullmatch(name):
                found[name] = Path(where)
    return found


def file_of_library(name: str) -> Path:
    known = subprocess.run(["/sbin/ldconfig", "-p"], capture_output=True, text=True, check=True).stdout
    found = re.search(rf"^\s{re.escape(name)} \(.*?\) => (\S+)$", known, re.MULTILINE)
    if not found:
        raise SystemExit(f"{name} is not installed; a self-contained wheel needs it")
    return Path(found[1])


def packages_of(files: list) -> list:
    """The Debian packages of these files, for their licences."""
    packages = set()
    for file in files:
        real = Path(file).resolve()
        for path in (real, Path(str(real).replace("/usr/lib/", "/lib/", 1))):
            answer = subprocess.run(["dpkg-query", "-S", path], capture_output=True, text=True)
            if answer.returncode == 0:
                packages.add(answer.stdout.split(":")[0])
                break
        else:
            raise SystemExit(f"no package is known of {file}, and so no licence")
    return sorted(packages)


def newest_glibc(files: dict) -> tuple:
    """The newest version of glibc that any of the files asks for."""
    versions = {(2, 17)}
    for name, data in files.items():
        if ".so" in Path(name).name:
            versions |= {tuple(map(int, found)) for found in re.findall(rb"GLIBC_(\d+)\.(\d+)", data)}
    return max(versions)


def changed(file: Path, program: list) -> bytes:
    """The bytes of a file that a program has changed in place."""
    with tempfile.TemporaryDirectory() as folder:
        copy = shutil.copy(file.resolve(), folder)
        subprocess.run([*program, copy], check=True)
        return Path(copy).read_bytes()


def self_contained_wheel(build: Path, folder: Path, opened: list) -> str:
    """A wheel with all libraries except glibc's and libstdc++, the fonts, and the licences of all of them."""
    if not shutil.which("patchelf"):
        raise SystemExit("a self-contained wheel needs patchelf; install it")
    files = package_files(build)
    module = next(name for name in files if name.startswith("poinsot/_poinsot."))
    starts = [file_of_library(name) for name in opened]
    libraries = libraries_of([build / "python" / module, *starts])
    libraries.update(zip(opened, starts))
    files[module] = changed(build / "python" / module, ["strip", "--strip-unneeded"])
    for name, file in sorted(libraries.items()):
        # They find each other in their own folder.
        files[f"poinsot/lib/{name}"] = changed(file, ["patchelf", "--set-rpath", "$ORIGIN"])
    listed = subprocess.run(["dpkg-query", "-L", "fonts-lmodern"], capture_output=True, text=True, check=True).stdout
    for name in fonts:
        path = re.search(rf"^\S+/{name}\.otf$", listed, re.MULTILINE)
        if not path:
            raise SystemExit(f"{name}.otf is not in fonts-lmodern")
        files[f"poinsot/fonts/{name}.otf"] = Path(path[0]).read_bytes()
    headers = ["libboost-dev", "libeigen3-dev", "libglm-dev", "libtomlplusplus-dev", "pybind11-dev", "python3-glad"]
    for package in sorted({*packages_of(list(libraries.values())), "fonts-lmodern", *headers}):
        files[f"poinsot/licences/{package}"] = Path(f"/usr/share/doc/{package}/copyright").resolve().read_bytes()
    major, minor = newest_glibc(files)
    machine = os.uname().machine
    name = write_wheel(folder, f"manylinux_{major}_{minor}_{machine}", files)
    size = (folder / name).stat().st_size
    print(f"{name}: {size / 1e6:.0f} MB, {len(libraries)} libraries")
    return name


def write_metadata(folder: Path) -> Path:
    """The .dist-info of a package, without WHEEL and RECORD; as a distribution installs it."""
    about = project()
    info = folder / f"{about['name']}-{about['version']}.dist-info"
    info.mkdir(parents=True, exist_ok=True)
    for name, data in info_files().items():
        (info / name).write_bytes(data)
    return info


if __name__ == "__main__":
    what, *arguments = sys.argv[1:]
    if what == "wheel":
        self_contained_wheel(Path(arguments[0]), Path(arguments[1]), arguments[2:])
    elif what == "metadata":
        write_metadata(Path(arguments[0]))
    else:
        raise SystemExit("poinsot_build.py wheel BUILD FOLDER LIBRARY… | metadata FOLDER")
