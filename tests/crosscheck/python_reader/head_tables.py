# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""The head of a file: header, directory and the ten chunks as they lie there (docs/format.md, section 2)."""
import struct

from refused import Refused, demand
from xxh64 import xxh64

MAGIC = bytes((0x89, 0x4C, 0x49, 0x54, 0x48, 0x45, 0x1A, 0x0A))
VERSION_MAJOR = 0
HEADER_BYTES, ENTRY_BYTES = 64, 16
MAX_HEAD_BYTES, MAX_CHUNKS = 16 << 20, 64
# id: fields of a record, fewest and most records
CHUNKS = {
    b"INFO": ("<3ff 8BB3x 3I ff 3I3I", 1, 1),
    b"NODE": ("<IHH3fQ", 0, 65535),
    b"JOIN": ("<HH3B3B3fQ", 0, 65535),
    b"SCAL": ("<3f3f", 0, 16384),
    b"MATL": ("<I", 0, 4096),
    b"PART": ("<3I", 1, 4096),
    b"UVGR": ("<3f", 0, 4096 * 8),
    b"LEVL": ("<5IffI", 1, 64),
    b"PAGE": ("<IIQ5I", 1, 65535),
    b"NAME": ("<B", 0, MAX_HEAD_BYTES),
}


class Header:
    """The first 64 bytes (section Header)."""

    def __init__(self, data):
        demand(len(data) >= HEADER_BYTES, 1, "there are fewer than 64 bytes")
        demand(data[:8] == MAGIC, 2, "the magic differs")
        self.major, self.minor, self.head_bytes, self.file_bytes, self.checksum, self.chunk_count = struct.unpack_from(
            "<HHIQQI", data, 8)
        demand(self.major == VERSION_MAJOR, 3, f"the major version is {self.major}")
        in_range = HEADER_BYTES <= self.head_bytes <= MAX_HEAD_BYTES
        demand(in_range and self.head_bytes % 8 == 0, 4, "head_bytes is out of range")
        demand(len(data) >= self.head_bytes, 1, "the head is cut short")
        without_checksum = data[:24] + bytes(8) + data[32 : self.head_bytes]
        demand(xxh64(without_checksum) == self.checksum, 5, "the head's checksum differs")
        demand(not any(data[36:HEADER_BYTES]), 6, "reserved bytes of the header are not zero")
        fits = HEADER_BYTES + ENTRY_BYTES * self.chunk_count <= self.head_bytes
        demand(self.chunk_count <= MAX_CHUNKS and fits, 7, "the directory does not fit the head")


class Entry:
    """Where a chunk lies (section Directory entry)."""

    def __init__(self, data, index):
        fields = struct.unpack_from("<4sHHII", data, HEADER_BYTES + ENTRY_BYTES * index)
        self.id, self.flags, self.record_bytes, self.offset, self.record_count = fields
        sound = self.flags <= 1 and self.record_bytes > 0 and self.offset % 8 == 0
        demand(sound, 8, f"directory entry {index} is invalid")
        self.end = self.offset + self.record_bytes * self.record_count


def read_directory(data, header):
    """The entries by id."""
    entries = {}
    free = HEADER_BYTES + ENTRY_BYTES * header.chunk_count
    for index in range(header.chunk_count):
        entry = Entry(data, index)
        inside = free <= entry.offset and entry.end <= header.head_bytes
        demand(inside, 9, f"chunk {entry.id} is not inside the head, overlaps, or is out of order")
        demand(entry.id not in entries, 10, f"chunk {entry.id} occurs twice")
        demand(entry.id in CHUNKS or entry.flags & 1, 10, f"chunk {entry.id} is unknown and not optional")
        entries[entry.id] = entry
        demand(not any(data[free : entry.offset]), 9, "bytes between chunks are not zero")
        free = entry.end
    demand(not any(data[free : header.head_bytes]), 9, "bytes after the chunks are not zero")
    return entries


def read_chunks(data, entries):
    """The known chunks' records as tuples, by id."""
    chunks = {}
    for name, (layout, fewest, most) in CHUNKS.items():
        demand(name in entries, 11, f"chunk {name} is missing")
        entry = entries[name]
        size = struct.calcsize(layout)
        demand(entry.record_bytes >= size, 11, f"records of chunk {name} are too small")
        demand(name != b"NAME" or entry.record_bytes == 1, 11, "records of NAME are not bytes")
        demand(fewest <= entry.record_count <= most, 11, f"chunk {name} has {entry.record_count} records")
        chunks[name] = [
            struct.unpack_from(layout, data, entry.offset + entry.record_bytes * i) for i in range(entry.record_count)
        ]
    info = entries[b"INFO"]
    demand(not any(data[info.offset + 25 : info.offset + 28]), 13, "reserved bytes of INFO are not zero")
    return chunks


def read_names(records):
    """NAME as bytes; the strings in it are found by offset."""
    names = bytes(byte for byte, in records)
    demand(names and names[-1] == 0, 16, "NAME does not end with zero")
    try:
        names.decode("utf-8")
    except UnicodeDecodeError:
        raise Refused(16, "NAME is not UTF-8") from None
    return names


def name_at(names, offset, check):
    demand(offset < len(names), check, "a name is outside NAME")
    return names[offset : names.index(0, offset)].decode("utf-8")
