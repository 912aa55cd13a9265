#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
import io
import pathlib
import tempfile
import unittest

import numpy
import report_fixture  # sets the path
from PIL import Image
from report import pictures


def pixels(png):
    return numpy.asarray(Image.open(io.BytesIO(png)).convert("RGB"))


class MapImageTest(unittest.TestCase):
    MAP = pictures.MapImage(numpy.array([[0, 0, 0, 0], [0, 2, 1, 0], [0, 1, 1, 0]], numpy.uint8),
                            resolution_m=0.5, x_m=-1.0, y_m=2.0)

    def test_known_box_is_in_metres(self):
        self.assertEqual(self.MAP.known_box(), (-0.5, 2.0, 0.5, 3.0))

    def test_common_box_holds_all_maps(self):
        other = pictures.MapImage(numpy.array([[1]], numpy.uint8), 0.5, 3.0, 0.0)
        self.assertEqual(pictures.common_box([self.MAP, other]), (-0.5, 0.0, 3.5, 3.0))

    def test_window_is_unknown_outside_of_the_map(self):
        window = self.MAP.window((-0.5, 1.5, 1.5, 3.0))
        self.assertEqual(window.tolist(), [[2, 1, 0, 0], [1, 1, 0, 0], [0, 0, 0, 0]])

    def test_window_can_lie_off_the_map(self):
        self.assertFalse(self.MAP.window((10.0, 10.0, 11.0, 11.0)).any())

    def test_map_without_known_cells_has_no_box(self):
        self.assertIsNone(pictures.common_box([pictures.MapImage(
            numpy.zeros((2, 2), numpy.uint8), 0.5, 0.0, 0.0)]))


class ReadMapTest(unittest.TestCase):
    def test_reads_what_map_server_reads(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "map.yaml"
            Image.fromarray(numpy.array([[205, 254, 0]], numpy.uint8)).save(
                file.with_name("picture.pgm"))
            file.write_text("image: picture.pgm\nresolution: 0.1\norigin: [1.5, -2, 0]\n"
                            "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n")
            found = pictures.read_map(file)
        self.assertEqual(found.cells.tolist(), [[0, 1, 2]])
        self.assertEqual((found.resolution_m, found.x_m, found.y_m), (0.1, 1.5, -2))


class PngTest(unittest.TestCase):
    def test_small_map_is_drawn_cell_by_cell(self):
        found = pixels(pictures.map_png(numpy.array([[0, 1, 2]], numpy.uint8)))
        self.assertEqual(found.tolist(), [[[205] * 3, [255] * 3, [0] * 3]])

    def test_no_wall_is_lost_in_a_large_map(self):
        cells = numpy.ones((400, 2000), numpy.uint8)
        cells[:, 777] = 2
        found = pixels(pictures.map_png(cells))
        self.assertLessEqual(found.shape[1], pictures.WIDTH)
        self.assertTrue(((found == 0).all(axis=2).sum(axis=1) == 1).all())

    def test_error_picture_keeps_its_marks_and_loses_its_legend(self):
        drawn = numpy.full((800, 1800, 3), 255, numpy.uint8)
        drawn[400, 900] = (0, 115, 179)  # one missing element
        drawn[760:] = (214, 94, 0)  # the legend
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "e.png"
            Image.fromarray(drawn).save(file)
            found = pixels(pictures.error_png(file))
        self.assertEqual((found == (0, 115, 179)).all(axis=2).sum(), 1)
        self.assertEqual((found == (214, 94, 0)).all(axis=2).sum(), 0)

    def test_same_map_same_bytes(self):
        cells = numpy.random.default_rng(1).integers(0, 3, (90, 80)).astype(numpy.uint8)
        self.assertEqual(pictures.map_png(cells), pictures.map_png(cells.copy()))


if __name__ == "__main__":
    unittest.main()
