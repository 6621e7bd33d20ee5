# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""One stream of a page: a Draco point cloud of integer attributes, without its beginning (docs/format.md, section The
cloud of a stream; for rANS Draco's own specification, section Rans Decoding).

Everything that is wrong with a cloud is check 65.
"""
from refused import demand

PREDICTION_NONE = 0xFE
TAGGED, RAW = 0, 1
TAG_BITS = 5
MAX_SYMBOL_BITS = 18
MAX_TAG = 19
MAX_PLAIN_BYTES = 3


def expect(condition, sentence):
    demand(condition, 65, sentence)


class Bytes:
    """A position in bytes that are read front to back."""

    def __init__(self, data):
        self.data, self.at = data, 0

    def take(self, count):
        expect(count <= len(self.data) - self.at, "a stream is cut short")
        self.at += count
        return self.data[self.at - count : self.at]

    def integer(self, size):
        return int.from_bytes(self.take(size), "little")

    def varint(self):
        value, shift = 0, 0
        while True:
            byte = self.integer(1)
            value |= (byte & 127) << shift
            shift += 7
            if byte < 128:
                expect(value < 1 << 32, "a varint of a stream is too large")
                return value
            expect(shift < 35, "a varint of a stream is too long")


class RansReader:
    """Symbols of one rANS coded sequence: its table, its size and its bytes, which are read backwards."""

    def __init__(self, source, symbol_bits, max_symbols, count):
        self.precision_bits = min(20, max(12, 3 * symbol_bits // 2))
        self.base = 4 << self.precision_bits
        self.build_table(read_probabilities(source, max_symbols), count)
        self.bytes = source.take(source.varint())
        self.start()

    def build_table(self, probabilities, count):
        expect(sum(map(bool, probabilities)) <= count, "a stream lists more symbols than it has")
        expect(sum(probabilities) == 1 << self.precision_bits, "the probabilities of a stream do not sum to one")
        self.slots = []
        self.symbols = []
        for symbol, probability in enumerate(probabilities):
            self.symbols.append((probability, len(self.slots)))
            self.slots.extend([symbol] * probability)

    def start(self):
        expect(len(self.bytes) > 0, "a stream has no coded bytes")
        size = (self.bytes[-1] >> 6) + 1
        expect(size <= len(self.bytes), "the coder's state is cut short")
        self.at = len(self.bytes) - size
        state = int.from_bytes(self.bytes[self.at :], "little") & ((1 << (8 * size - 2)) - 1)
        self.state = state + self.base
        expect(self.state < self.base * 256, "the coder's state is out of range")

    def symbol(self):
        slot = self.state & ((1 << self.precision_bits) - 1)
        symbol = self.slots[slot]
        probability, first_slot = self.symbols[symbol]
        self.state = (self.state >> self.precision_bits) * probability + slot - first_slot
        while self.state < self.base and self.at > 0:
            self.at -= 1
            self.state = self.state * 256 + self.bytes[self.at]
        return symbol

    def symbols_to_the_end(self, count):
        """All of them: then the state is the one that a writer begins with, and no byte is left."""
        symbols = [self.symbol() for _ in range(count)]
        expect(self.state == self.base and self.at == 0, "a stream does not end where its writer began")
        return symbols


def read_probabilities(source, max_symbols):
    """A table of probabilities: two bits say how many further bytes an entry has, or that a run of zeros follows."""
    count = source.varint()
    expect(1 <= count <= max_symbols, "a stream states too many symbols or none")
    probabilities = []
    while len(probabilities) < count:
        first = source.integer(1)
        if first & 3 == 3:
            probabilities.extend([0] * ((first >> 2) + 1))
        else:
            probabilities.append(first >> 2 | source.integer(first & 3) << 6)
            expect(probabilities[-1] > 0, "a probability is zero outside a run of zeros")
    expect(len(probabilities) == count and probabilities[-1] > 0, "a table does not end with a symbol that occurs")
    return probabilities


def tagged_symbols(source, records, components):
    """Each record's number of bits is rANS coded; the values follow, lowest bit first, in whole bytes at the end."""
    sizes = RansReader(source, TAG_BITS, MAX_TAG + 1, records).symbols_to_the_end(records)
    total = sum(sizes) * components
    pool = source.integer((total + 7) // 8)
    symbols = []
    for size in sizes:
        for _ in range(components):
            symbols.append(pool & ((1 << size) - 1))
            pool >>= size
    expect(pool == 0, "bits follow the values")
    return symbols


def raw_symbols(source, count):
    """Every value is a rANS symbol."""
    bits = source.integer(1)
    expect(1 <= bits <= MAX_SYMBOL_BITS, "a stream's symbols have a size that Draco does not know")
    return RansReader(source, bits, 1 << MAX_SYMBOL_BITS, count).symbols_to_the_end(count)


def read_symbols(source, records, components):
    """The values of one attribute before zigzag."""
    expect(source.integer(1) == PREDICTION_NONE, "an attribute is predicted")
    compressed = source.integer(1)
    expect(compressed <= 1, "an attribute's coding is unknown")
    if not compressed:
        size = source.integer(1)
        expect(1 <= size <= MAX_PLAIN_BYTES, "plain values have a size that does not exist")
        return [source.integer(size) for _ in range(records * components)]
    scheme = source.integer(1)
    expect(scheme in (TAGGED, RAW), "an attribute's symbol scheme is unknown")
    if scheme == TAGGED:
        return tagged_symbols(source, records, components)
    return raw_symbols(source, records * components)


def to_value(symbol, signed):
    """A signed value is the cloud's, an unsigned one what the cloud's value was before its zigzag was undone."""
    if not signed:
        expect(symbol < 1 << 19, "an unsigned value is too large")
        return symbol
    value = symbol >> 1 ^ -(symbol & 1)
    expect(-(1 << 18) <= value < 1 << 18, "a signed value is too large")
    return value


def read_cloud(data, records, attributes):
    """The values of a stream, record by record.

    attributes  a list of (components, signed)
    returns     a list of `records` flat lists, the attributes' components one after another
    """
    source = Bytes(data)
    rows = [[] for _ in range(records)]
    for components, signed in attributes:
        symbols = read_symbols(source, records, components)
        for at, row in enumerate(rows):
            row.extend(to_value(symbol, signed) for symbol in symbols[at * components : (at + 1) * components])
    expect(source.at == len(data), "bytes follow a stream's values")
    return rows
