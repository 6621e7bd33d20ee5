# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""XXH64 with seed 0, the checksum of heads and pages (docs/format.md, sections Header and PAGE; for XXH64 itself the
specification of xxHash)."""
import struct

MASK = 0xFFFFFFFFFFFFFFFF
PRIME_1, PRIME_2, PRIME_3 = 0x9E3779B185EBCA87, 0xC2B2AE3D27D4EB4F, 0x165667B19E3779F9
PRIME_4, PRIME_5 = 0x85EBCA77C2B2AE63, 0x27D4EB2F165667C5


def rotate(value, count):
    return ((value << count) | (value >> (64 - count))) & MASK


def mix(accumulator, lane):
    return rotate((accumulator + lane * PRIME_2) & MASK, 31) * PRIME_1 & MASK


def stripes_hash(data):
    """The part of the hash that takes 32 bytes at a time; returns it and how many bytes it has taken."""
    lanes = [(PRIME_1 + PRIME_2) & MASK, PRIME_2, 0, -PRIME_1 & MASK]
    taken = len(data) // 32 * 32
    for stripe in struct.iter_unpack("<4Q", data[:taken]):
        lanes = [mix(lane, word) for lane, word in zip(lanes, stripe)]
    result = sum(rotate(lane, count) for lane, count in zip(lanes, (1, 7, 12, 18))) & MASK
    for lane in lanes:
        result = ((result ^ mix(0, lane)) * PRIME_1 + PRIME_4) & MASK
    return result, taken


def xxh64(data):
    """The hash of a bytes object."""
    result, at = stripes_hash(data) if len(data) >= 32 else (PRIME_5, 0)
    result = (result + len(data)) & MASK
    for at in range(at, len(data) - 7, 8):
        result = (rotate(result ^ mix(0, int.from_bytes(data[at : at + 8], "little")), 27) * PRIME_1 + PRIME_4) & MASK
    rest = data[len(data) & ~7 :]
    if len(rest) >= 4:
        word = int.from_bytes(rest[:4], "little")
        result = (rotate(result ^ (word * PRIME_1 & MASK), 23) * PRIME_2 + PRIME_3) & MASK
        rest = rest[4:]
    for byte in rest:
        result = rotate(result ^ (byte * PRIME_5 & MASK), 11) * PRIME_1 & MASK
    result = (result ^ (result >> 33)) * PRIME_2 & MASK
    result = (result ^ (result >> 29)) * PRIME_3 & MASK
    return result ^ (result >> 32)
