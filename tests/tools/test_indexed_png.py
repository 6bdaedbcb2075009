"""Pictures for the documentation keep their colors when they are made small."""

import os
import struct
import sys
import tempfile
import unittest
import zlib

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(os.path.dirname(HERE), "screenshots"))

import indexed_png  # noqa: E402

WIDTH, HEIGHT = 40, 24
FILTERS = 5


def few_colors(x, y):
    return ((x % 3) * 100, 40 if y < 12 else 200, 7)


def gradient(x, y):
    return (x * 6, y * 10, (x + y) * 3)


def write(path, color_of, channels):
    """A PNG in which each row has the next kind of filter."""
    lines, above = b"", bytes(WIDTH * channels)
    for y in range(HEIGHT):
        line = b"".join(bytes([*color_of(x, y), 128])[:channels] for x in range(WIDTH))
        kind = y % FILTERS
        lines += bytes([kind])
        for i, value in enumerate(line):
            left = line[i - channels] if i >= channels else 0
            corner = above[i - channels] if i >= channels else 0
            guess = {0: 0, 2: above[i]}.get(kind, indexed_png.predicted(kind, left, above[i], corner))
            lines += bytes([(value - guess) & 255])
        above = line
    with open(path, "wb") as file:
        file.write(indexed_png.SIGNATURE)
        header = struct.pack(">IIBBBBB", WIDTH, HEIGHT, 8, 2 if channels == 3 else 6, 0, 0, 0)
        for kind, body in ((b"IHDR", header), (b"IDAT", zlib.compress(lines)), (b"IEND", b"")):
            file.write(indexed_png.chunk(kind, body))


def read_indexed(path):
    """Rows of colors of what shrink() wrote."""
    with open(path, "rb") as file:
        data = file.read()
    place, parts = len(indexed_png.SIGNATURE), {}
    while place < len(data):
        length, kind = struct.unpack_from(">I4s", data, place)
        parts[kind] = data[place + 8:place + 8 + length]
        place += 12 + length
    palette = [tuple(parts[b"PLTE"][i:i + 3]) for i in range(0, len(parts[b"PLTE"]), 3)]
    indices = zlib.decompress(parts[b"IDAT"])
    return [[palette[i] for i in indices[y * (WIDTH + 1) + 1:(y + 1) * (WIDTH + 1)]] for y in range(HEIGHT)]


class IndexedPngTest(unittest.TestCase):
    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.addCleanup(self._folder.cleanup)
        self.path = os.path.join(self._folder.name, "picture.png")

    def test_all_filters_are_read(self):
        for channels in (3, 4):
            write(self.path, gradient, channels)
            width, height, rows = indexed_png.read(self.path)
            self.assertEqual((width, height), (WIDTH, HEIGHT))
            self.assertEqual(rows, [[gradient(x, y) for x in range(WIDTH)] for y in range(HEIGHT)])

    def test_few_colors_stay_exact(self):
        write(self.path, few_colors, 3)
        indexed_png.shrink(self.path)
        self.assertEqual(read_indexed(self.path), [[few_colors(x, y) for x in range(WIDTH)] for y in range(HEIGHT)])

    def test_many_colors_stay_near(self):
        write(self.path, gradient, 4)
        indexed_png.shrink(self.path)
        rows = read_indexed(self.path)
        self.assertLessEqual(len({color for row in rows for color in row}), 256)
        worst = max(abs(a - b) for y, row in enumerate(rows) for x, color in enumerate(row)
                    for a, b in zip(color, gradient(x, y)))
        self.assertLessEqual(worst, 20)

    def test_other_files_are_refused(self):
        with open(self.path, "wb") as file:
            file.write(b"GIF89a")
        with self.assertRaisesRegex(ValueError, "is no PNG"):
            indexed_png.read(self.path)
