#!/usr/bin/env python3
"""Executes the notebooks of docs/notebooks/ from the first cell to the last.

Usage: notebooks_test.py PACKAGE [--renew] [NAME...]

PACKAGE is the folder that holds the package poinsot; NAMEs are notebooks without the suffix (default: all). Each notebook runs in a
temporary folder and fails if a cell raises an exception or writes to stderr, if an output names a local path, or if the notebook
with its outputs is 300 kB or larger. --renew also stores the outputs in docs/notebooks/.

Exits with 77 (skipped) where nbclient, ipykernel or a library that the notebooks use is missing.
"""
import argparse
import importlib.util
import os
import pathlib
import sys
import tempfile

from pages import writes_pages

FOLDER = pathlib.Path(__file__).resolve().parents[3] / "docs" / "notebooks"
MOST_BYTES = 300_000
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


def faults(book, text, folder, package):
    for number, cell in enumerate(book.cells, 1):
        for output in cell.get("outputs", []):
            if output.get("name") == "stderr":
                yield f"cell {number} writes to stderr: {output['text'].strip()[:300]}"
    for path in {str(folder), str(package), str(FOLDER.parents[1]), os.path.expanduser("~") + os.sep}:
        if path in text:
            yield f"an output names the local path {path}"
    if len(text.encode("utf-8")) >= MOST_BYTES:
        yield f"{len(text.encode('utf-8'))} bytes with its outputs; {MOST_BYTES} are too many for a page: make its pictures smaller"


def tested(file, package, renew, has_pages):
    import nbformat
    from nbclient.exceptions import CellExecutionError

    with tempfile.TemporaryDirectory(prefix="poinsot-notebook-") as folder:
        try:
            book = executed(file, folder, has_pages)
        except CellExecutionError as error:
            return [str(error)[-3000:]]
        text = nbformat.writes(book) + "\n"
        found = list(faults(book, text, folder, package))
        if renew and not found:
            file.write_text(text, encoding="utf-8")
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
