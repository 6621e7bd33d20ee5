# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""Files that are not what they were: cut short, or with a bit turned, and their checksums repaired or not."""
import random
import struct

from head_tables import HEADER_BYTES, Header, read_directory
from lithe_file import LitheFile
from xxh64 import xxh64

CHECKSUM_AT = 24
PAGE_CHECKSUM_AT = 8


class Original:
    """A sound file, and where its parts lie."""

    def __init__(self, data):
        self.data = data
        self.file = LitheFile(data)
        self.head_bytes = self.file.header.head_bytes
        self.page_table = read_directory(data, Header(data))[b"PAGE"]

    def cuts(self):
        """(size, check) of shortened files: the check that must refuse them."""
        for size in (0, 1, HEADER_BYTES - 1, HEADER_BYTES, self.head_bytes // 2, self.head_bytes - 1):
            yield size, 1
        for page in self.file.pages:
            yield page.offset, 60
            yield page.offset + page.size - 1, 60

    def check_of_byte(self, at):
        """The checks that may refuse a file whose byte `at` has another value, its checksums being as they were."""
        if at < 8:
            return {2}
        if at < 10:
            return {3}
        if 12 <= at < 16:
            return {1, 4, 5}
        return {5} if at < self.head_bytes else {61}

    def flipped(self, at, bit):
        data = bytearray(self.data)
        data[at] ^= 1 << bit
        return data

    def repaired(self, data):
        """The same with checksums that fit."""
        for index, page in enumerate(self.file.pages):
            at = self.page_table.offset + index * self.page_table.record_bytes + PAGE_CHECKSUM_AT
            struct.pack_into("<Q", data, at, xxh64(bytes(data[page.offset : page.offset + page.size])))
        struct.pack_into("<Q", data, CHECKSUM_AT, 0)
        struct.pack_into("<Q", data, CHECKSUM_AT, xxh64(bytes(data[: self.head_bytes])))
        return bytes(data)

    def places(self, count, seed):
        """`count` bits of the file, half of them in the head and half in the pages, as (byte, bit)."""
        source = random.Random(seed)
        for turn in range(count):
            low, high = (0, self.head_bytes) if turn % 2 else (self.head_bytes, len(self.data))
            yield source.randrange(low, high), source.randrange(8)
