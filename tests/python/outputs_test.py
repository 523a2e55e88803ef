#!/usr/bin/env python3
"""What a notebook shows and stores for each value of the package.

Usage: outputs_test.py PACKAGE, the folder that holds the package poinsot.
"""
import contextlib
import io
import os
import pathlib
import re
import struct
import sys
import tempfile
import unittest
import unittest.mock

import numpy as np

if __name__ == "__main__":
    sys.path.insert(0, str(pathlib.Path(sys.argv.pop(1)).resolve()))

import poinsot
from poinsot import pictures

SMALL = {"film.size": [320, 180]}


def size_of_png(png):
    return struct.unpack(">II", png[16:24])


class Outputs(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder.name)

    def test_scene_shows_itself_at_its_size_and_at_most_960_pixels_wide(self):
        self.assertEqual(size_of_png(poinsot.Scene("generic", SMALL)._repr_png_()), (320, 180))
        self.assertEqual(size_of_png(poinsot.Scene("generic", {"film.size": [3840, 2160]})._repr_png_()), (960, 540))

    def test_still_shows_the_bytes_of_its_file(self):
        still = poinsot.Scene("generic", SMALL).still(1.0)
        still.save("still.png")
        self.assertEqual(pathlib.Path("still.png").read_bytes(), still._repr_png_())
        self.assertEqual(np.asarray(still).shape, (180, 320, 4))

    def test_short_film_is_stored_and_long_film_is_linked(self):
        film = poinsot.Scene("generic", SMALL).render("a film.mp4", frames=(0, 2), progress=False)
        self.assertIn('src="data:video/mp4;base64,', film._repr_html_())
        with unittest.mock.patch.object(pictures, "most_inline_bytes", 100):
            self.assertIn('src="a%20film.mp4"', film._repr_html_())
        os.remove("a film.mp4")
        self.assertIsNone(film._repr_html_())

    def test_page_with_a_path_stores_its_poster_and_a_link_alone(self):
        scene = poinsot.Scene("generic", SMALL)
        try:
            page = scene.page("a & b.html")
        except poinsot.EnvironmentError as error:
            self.skipTest(str(error))
        shown = page._repr_html_()
        self.assertLess(len(shown), 100_000)
        self.assertIn('<a href="a%20%26%20b.html"><img src="data:image/png;base64,', shown)
        self.assertNotIn("<script", shown)
        self.assertEqual(pathlib.Path("a & b.html").read_text(encoding="utf-8"), page.html)

    def test_page_without_a_path_starts_in_a_sandbox_and_holds_its_text_as_data(self):
        try:
            page = poinsot.Scene("generic", {**SMALL, "title": "</script><b>"}).page()
        except poinsot.EnvironmentError as error:
            self.skipTest(str(error))
        shown = page._repr_html_()
        self.assertIn("setAttribute('sandbox','allow-scripts')", shown)
        # One script element, whose text is JSON without a "<" that could end it.
        held = re.findall(r'<script type="application/json">(.*?)</script>', shown)
        self.assertEqual(len(held), 1)
        self.assertNotIn("<", held[0])
        self.assertTrue(shown.endswith("</script></div>"))

    def test_render_shows_its_progress_as_text_where_tqdm_is_missing(self):
        said = io.StringIO()
        with unittest.mock.patch.dict(sys.modules, {"tqdm": None, "tqdm.auto": None}), contextlib.redirect_stderr(said):
            poinsot.Scene("generic", SMALL).render("film.mp4", frames=(0, 2))
        self.assertIn("generic: 100 %", said.getvalue())


if __name__ == "__main__":
    unittest.main()
