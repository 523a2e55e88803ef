#!/usr/bin/env python3
"""Runs the examples of docs/python.md and of the package's docstrings.

Usage: doctests_test.py PACKAGE, the folder that holds the package poinsot. The examples write their files into a temporary folder.
"""
import doctest
import importlib
import os
import pathlib
import pkgutil
import sys
import tempfile

from pages import writes_pages

PAGE = pathlib.Path(__file__).resolve().parents[3] / "docs" / "python.md"


class WithoutPages(doctest.DocTestParser):
    """Leaves out the examples that write or show a page."""

    def get_examples(self, string, name="<string>"):
        return [example for example in super().get_examples(string, name) if not self.shows_a_page(example)]

    def parse(self, string, name="<string>"):
        return [part for part in super().parse(string, name)
                if not (isinstance(part, doctest.Example) and self.shows_a_page(part))]

    @staticmethod
    def shows_a_page(example):
        return ".page(" in example.source or example.source.strip() == "page"


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.path.insert(0, str(pathlib.Path(sys.argv[1]).resolve()))
    import poinsot

    results = {}
    with tempfile.TemporaryDirectory(prefix="poinsot-doctests-") as folder:
        os.chdir(folder)
        parser = doctest.DocTestParser() if writes_pages() else WithoutPages()
        results[PAGE.name] = doctest.testfile(str(PAGE), module_relative=False, optionflags=doctest.ELLIPSIS, encoding="utf-8", parser=parser)
        for module in pkgutil.iter_modules(poinsot.__path__, "poinsot."):
            if module.name == "poinsot._poinsot":
                continue
            results[module.name] = doctest.testmod(importlib.import_module(module.name), optionflags=doctest.ELLIPSIS)
        os.chdir("/")
    for name, (n_failed, n_tried) in results.items():
        print(f"{name}: {n_tried} examples, {n_failed} failed")
    n_tried = sum(result.attempted for result in results.values())
    return 1 if any(result.failed for result in results.values()) or results[PAGE.name].attempted == 0 or n_tried == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
