# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""Files that are not what they were: cut short, or with a bit turned, and their checksums repaired or not."""
import struct

from head_tables import HEADER_BYTES, Header, read_directory
from lithe_file import LitheFile
from xxh64 import xxh64

FILE_BYTES_AT, CHECKSUM_AT = 16, 24
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

    def page_entry(self, index):
        return self.page_table.offset + index * self.page_table.record_bytes

    def repaired(self, data):
        """The same with checksums that fit."""
        for index, page in enumerate(self.file.pages):
            now = data[page.offset : page.offset + page.size]
            struct.pack_into("<Q", data, self.page_entry(index) + PAGE_CHECKSUM_AT, xxh64(bytes(now)))
        return self.with_head_checksum(data)

    def with_page(self, index, page):
        """The file with another page in the place of page `index`, its size and checksums right."""
        before = self.file.pages[index]
        data = bytearray(self.data[: before.offset] + page + self.data[before.offset + before.size :])
        struct.pack_into("<Q", data, FILE_BYTES_AT, len(data))
        struct.pack_into("<I", data, self.page_entry(index), len(page))
        struct.pack_into("<Q", data, self.page_entry(index) + PAGE_CHECKSUM_AT, xxh64(page))
        return self.with_head_checksum(data)

    def with_head_checksum(self, data):
        struct.pack_into("<Q", data, CHECKSUM_AT, 0)
        struct.pack_into("<Q", data, CHECKSUM_AT, xxh64(bytes(data[: self.head_bytes])))
        return bytes(data)

    def bits_turned(self, count, source):
        """`count` repaired files (what was done, bytes), half of them with a bit turned in the head, half in a page."""
        for turn in range(count):
            low, high = (0, self.head_bytes) if turn % 2 else (self.head_bytes, len(self.data))
            at, bit = source.randrange(low, high), source.randrange(8)
            yield f"bit {bit} of byte {at} turned", self.repaired(self.flipped(at, bit))
