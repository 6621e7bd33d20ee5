# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""A page with other values in its streams: written anew without entropy coding, so that only what is said changes."""
from draco_cloud import MAX_PLAIN_BYTES, PREDICTION_NONE
from page_streams import PARAMETER_BYTES, PageStreams, base_attributes, split_attributes

LARGEST = (1 << 18) - 10


def varint(value):
    result = bytearray()
    while value > 127:
        result.append(value & 127 | 128)
        value >>= 7
    result.append(value)
    return bytes(result)


def plain_stream(rows, attributes):
    """A stream of uncompressed values."""
    result, first = bytearray(), 0
    for components, signed in attributes:
        result += bytes((PREDICTION_NONE, 0, MAX_PLAIN_BYTES))
        for row in rows:
            for value in row[first : first + components]:
                symbol = 2 * value ^ value >> 63 if signed else value
                result += symbol.to_bytes(MAX_PLAIN_BYTES, "little")
        first += components
    return bytes(result)


class OpenPage:
    """A page of a sound file. `rows`, per stream, may be changed before `bytes` is called."""

    def __init__(self, original, index):
        self.original, self.index = original, index
        pages = original.file.pages
        self.data = original.file.page_bytes(index)
        info, before = original.file.info, pages[index - 1] if index else None
        streams = PageStreams(self.data, info, pages[index], before)
        self.attributes = split_attributes() if index else base_attributes(info)
        self.rows = [[list(row) for row in stream.rows] for stream in streams.streams]
        end = streams.rest.at
        self.low_sizes = [bits.size for bits in streams.low]
        self.low, self.tail = self.data[end - sum(self.low_sizes) : end], self.data[end:]

    def is_signed(self, stream, place):
        kinds = [signed for components, signed in self.attributes[stream] for _ in range(components)]
        return kinds[place]

    def bytes(self):
        coded = [plain_stream(rows, kinds) if rows else b"" for rows, kinds in zip(self.rows, self.attributes)]
        table = b"".join(varint(len(rows)) + (varint(len(stream)) if rows else b"")
                         for rows, stream in zip(self.rows, coded))
        fixed = self.data[: 1 + PARAMETER_BYTES]
        return fixed + table + b"".join(map(varint, self.low_sizes)) + b"".join(coded) + self.low + self.tail

    def change(self, source):
        """Gives a value of some stream another one, near or far; returns what was done."""
        stream = source.choice([stream for stream, rows in enumerate(self.rows) if rows])
        row = source.randrange(len(self.rows[stream]))
        place = source.randrange(len(self.rows[stream][row]))
        old = self.rows[stream][row][place]
        new = source.choice((old + 1, old - 1, 0, old + source.randrange(-9, 10), source.randrange(64),
                             source.randrange(-LARGEST, LARGEST)))
        self.rows[stream][row][place] = new if self.is_signed(stream, place) else abs(new)
        return f"page {self.index}, stream {stream}, record {row}, entry {place}: {old} changed to {new}"


def values_changed(original, count, source):
    """`count` files (what was done, bytes) of which a value was changed."""
    for _ in range(count):
        page = OpenPage(original, source.randrange(len(original.file.pages)))
        done = page.change(source)
        yield done, original.with_page(page.index, page.bytes())
