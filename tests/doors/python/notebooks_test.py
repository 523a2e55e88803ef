#!/usr/bin/env python3
"""Executes the notebooks of docs/notebooks/ from the first cell to the last.

Usage: notebooks_test.py PACKAGE [--renew] [NAME...]

PACKAGE is the folder that holds the package poinsot; NAMEs are notebooks without the suffix (default: all). Each notebook runs in a
temporary folder and fails if a cell raises an exception or writes to stderr, or if an output names a local path. --renew also stores the
outputs in docs/notebooks/, without pictures, films and pages: git would keep each of their versions. A stored notebook that has one, or
that is 40 kB or larger, fails.

Exits with 77 (skipped) where nbclient, ipykernel or a library that the notebooks use is missing.
"""
import argparse
import copy
import importlib.util
import os
import pathlib
import sys
import tempfile

from pages import writes_pages

FOLDER = pathlib.Path(__file__).resolve().parents[3] / "docs" / "notebooks"
MOST_BYTES = 40_000
NEEDED = ("nbformat", "nbclient", "ipykernel", "numpy", "scipy", "pandas", "matplotlib")


def executed(file, folder, has_pages):
    """The notebook with its outputs; without the module for browsers, without its cells that write pages."""
    import nbformat
    from nbclient import NotebookClient

    book = nbformat.read(file, as_version=4)
    if not has_pages:
        book.cells = [cell for cell in book.cells if ".page(" not in cell.source]
    NotebookClient(book, timeout=600, kernel_name="python3", record_timing=False,
                   resources={"metadata": {"path": folder}}).execute()
    # The kernel adds its version, which differs from machine to machine.
    book.metadata["language_info"] = {"name": "python"}
    return book


def is_drawn(kind, value):
    """Whether an output of this kind is a picture, a film or a page; tables of pandas are HTML, too."""
    return kind.startswith("image/") or (kind == "text/html" and not "".join(value).lstrip().startswith("<div>"))


def without_pictures(book):
    """The notebook as it is stored."""
    stored = copy.deepcopy(book)
    for cell in stored.cells:
        for output in cell.get("outputs", []):
            for kind in [kind for kind, value in output.get("data", {}).items() if is_drawn(kind, value)]:
                del output["data"][kind]
        cell_outputs = [output for output in cell.get("outputs", []) if "data" not in output or output["data"]]
        if "outputs" in cell:
            cell["outputs"] = cell_outputs
    return stored


def faults(book, text, folder, package):
    for number, cell in enumerate(book.cells, 1):
        for output in cell.get("outputs", []):
            if output.get("name") == "stderr":
                yield f"cell {number} writes to stderr: {output['text'].strip()[:300]}"
    for path in {str(folder), str(package), str(FOLDER.parents[1]), os.path.expanduser("~") + os.sep}:
        if path in text:
            yield f"an output names the local path {path}"


def tested(file, package, renew, has_pages):
    import nbformat
    from nbclient.exceptions import CellExecutionError

    with tempfile.TemporaryDirectory(prefix="poinsot-notebook-") as folder:
        try:
            book = executed(file, folder, has_pages)
        except CellExecutionError as error:
            return [str(error)[-3000:]]
        found = list(faults(book, nbformat.writes(book), folder, package))
        if renew and not found:
            file.write_text(nbformat.writes(without_pictures(book)) + "\n", encoding="utf-8")
    stored = nbformat.read(file, as_version=4)
    if stored != without_pictures(stored):
        found.append("it is stored with pictures; run this with --renew")
    if file.stat().st_size >= MOST_BYTES:
        found.append(f"it is stored in {file.stat().st_size} bytes, and {MOST_BYTES} are too many")
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("package", type=pathlib.Path)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--renew", action="store_true")
    options = parser.parse_intermixed_args()
    missing = [name for name in NEEDED if importlib.util.find_spec(name) is None]
    if missing:
        print("not installed:", ", ".join(missing))
        return 77
    package = options.package.resolve()
    sys.path.insert(0, str(package))
    with tempfile.TemporaryDirectory(prefix="poinsot-jupyter-") as folder:
        os.environ.update(PYTHONPATH=str(package), JUPYTER_RUNTIME_DIR=folder, IPYTHONDIR=folder, PYDEVD_DISABLE_FILE_VALIDATION="1")
        files = [FOLDER / f"{name}.ipynb" for name in options.names] or sorted(FOLDER.glob("*.ipynb"))
        n_faults = 0
        has_pages = writes_pages()
        if options.renew and not has_pages:
            sys.exit("--renew needs a package with the module for browsers: sh .ci/setup page")
        for file in files:
            found = tested(file, package, options.renew, has_pages)
            n_faults += len(found)
            print(file.stem, "passed" if not found else "FAILED", flush=True)
            for fault in found:
                print(f"  {fault}")
    return 1 if n_faults or not files else 0


if __name__ == "__main__":
    sys.exit(main())
