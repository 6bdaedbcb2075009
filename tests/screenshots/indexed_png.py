"""Makes a picture small enough for the repository: a PNG of 256 colors instead of one of 24 bits a pixel."""

import collections
import struct
import zlib

SIGNATURE = b"\x89PNG\r\n\x1a\n"
COLORS = 256
# Channels of the two kinds that the engine writes, by the PNG's color type.
CHANNELS = {2: 3, 6: 4}


def shrink(path):
    """Writes the file anew with a palette; alpha is dropped."""
    width, height, rows = read(path)
    counts = collections.Counter()
    for row in rows:
        counts.update(row)
    palette, index = choose_palette(counts)
    lines = bytearray()
    for row in rows:
        lines.append(0)
        lines += bytes(index[color] for color in row)
    with open(path, "wb") as file:
        file.write(SIGNATURE)
        file.write(chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 3, 0, 0, 0)))
        file.write(chunk(b"PLTE", b"".join(bytes(color) for color in palette)))
        file.write(chunk(b"IDAT", zlib.compress(bytes(lines), 9)))
        file.write(chunk(b"IEND", b""))


def read(path):
    """Width, height, and rows of (red, green, blue) of a PNG as the engine writes it."""
    with open(path, "rb") as file:
        data = file.read()
    if not data.startswith(SIGNATURE):
        raise ValueError(f"{path} is no PNG")
    place, packed = len(SIGNATURE), b""
    while place < len(data):
        length, kind = struct.unpack_from(">I4s", data, place)
        body = data[place + 8:place + 8 + length]
        if kind == b"IHDR":
            width, height, depth, color_type, _, _, interlaced = struct.unpack(">IIBBBBB", body)
        elif kind == b"IDAT":
            packed += body
        place += 12 + length
    if depth != 8 or interlaced or color_type not in CHANNELS:
        raise ValueError(f"{path} is not one of the engine's PNGs: depth {depth}, color type {color_type}")
    channels = CHANNELS[color_type]
    lines = unfilter(zlib.decompress(packed), width * channels, height, channels)
    return width, height, [list(zip(line[0::channels], line[1::channels], line[2::channels])) for line in lines]


def unfilter(data, length, height, step):
    """The bytes of each row, given how each differs from its neighbors."""
    lines = []
    above = bytearray(length)
    for y in range(height):
        start = y * (length + 1)
        kind, line = data[start], bytearray(data[start + 1:start + 1 + length])
        if kind == 2:
            line = bytearray((a + b) & 255 for a, b in zip(line, above))
        elif kind:
            for i in range(length):
                left = line[i - step] if i >= step else 0
                corner = above[i - step] if i >= step else 0
                line[i] = (line[i] + predicted(kind, left, above[i], corner)) & 255
        lines.append(line)
        above = line
    return lines


def predicted(kind, left, above, corner):
    """What a filter of PNG expects of a byte."""
    if kind == 1:
        return left
    if kind == 3:
        return (left + above) // 2
    guess = left + above - corner
    distances = (abs(guess - left), abs(guess - above), abs(guess - corner))
    return (left, above, corner)[distances.index(min(distances))]


def choose_palette(counts):
    """At most 256 colors, and which of them stands for each of the counted ones: median cut."""
    boxes = [(*spread(list(counts), counts), list(counts))]
    while len(boxes) < COLORS:
        box = max(boxes, key=lambda measured: measured[0])
        width, channel, colors = box
        if width == 0:
            break
        boxes.remove(box)
        colors.sort(key=lambda color: color[channel])
        middle = split(colors, channel, counts)
        boxes += [(*spread(half, counts), half) for half in (colors[:middle], colors[middle:])]
    palette, index = [], {}
    for _, _, colors in boxes:
        total = sum(counts[color] for color in colors)
        palette.append(tuple(round(sum(color[c] * counts[color] for color in colors) / total) for c in range(3)))
        index.update(dict.fromkeys(colors, len(palette) - 1))
    return palette, index


def spread(colors, counts):
    """How much a box needs to be divided, and along which channel. Thin lines have few pixels and still matter."""
    ranges = [max(color[c] for color in colors) - min(color[c] for color in colors) for c in range(3)]
    weight = sum(counts[color] for color in colors) ** 0.45
    return max(ranges) * weight, ranges.index(max(ranges))


def split(colors, channel, counts):
    """Where to divide a sorted box: at the middle of its weights, yet within it."""
    half = sum(counts[color] ** 0.5 for color in colors) / 2
    seen = 0.0
    for i, color in enumerate(colors):
        seen += counts[color] ** 0.5
        if seen >= half:
            middle = max(1, min(i, len(colors) - 1))
            break
    while middle < len(colors) - 1 and colors[middle][channel] == colors[middle - 1][channel]:
        middle += 1
    return middle


def chunk(kind, body):
    """One part of a PNG."""
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
