# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""The pages after page 0: which nodes are split, level by level (docs/format.md, section 4)."""
from page_streams import FLAGS_NEW, FLAGS_OLD
from refused import demand
from split import Split

MAX_VISITED_CORNERS = 1 << 26


class SplitPages:
    """Goes through the levels; where a page ends before its level does, the next page goes on from there."""

    def __init__(self, lithe_file, hierarchy):
        self.file, self.hierarchy = lithe_file, hierarchy
        self.level, self.at = 1, 0

    def decode(self, page, entry):
        """page   PageStreams
        entry  its record of PAGE
        yields each level that ends with the page, when the hierarchy is at it"""
        self.visited_corners = 0
        while True:
            ends_here = self.level in entry.ending
            self.visit(page, entry, ends_here)
            if not ends_here:
                return
            self.demand_counts(self.file.levels[self.level])
            yield self.level
            self.level, self.at = self.level + 1, 0
            if self.level - 1 == entry.ending[-1]:
                return

    def visit(self, page, entry, to_the_end):
        first_new = self.file.levels[self.level - 1].node_count
        nodes = self.hierarchy.nodes
        while self.at < len(nodes) and (to_the_end or len(nodes) < entry.node_count):
            if nodes[self.at].children is None:
                flag = page.streams[FLAGS_OLD if self.at < first_new else FLAGS_NEW].value()
                demand(flag <= 1, 71, "a flag is neither 0 nor 1")
                if flag:
                    self.split(page, entry)
            self.at += 1
        demand(to_the_end or len(nodes) == entry.node_count, 71, "a page ends before its nodes are there")

    def split(self, page, entry):
        demand(len(self.hierarchy.nodes) + 2 <= entry.node_count, 71, "there are more splits than the page's nodes")
        split = Split(self.hierarchy, page, self.at, entry)
        self.visited_corners += len(split.fan.spokes)
        demand(self.visited_corners <= MAX_VISITED_CORNERS, 81, "a page visits too many corners")
        split.carry_out()
        self.visited_corners += split.picks.visited
        demand(self.visited_corners <= MAX_VISITED_CORNERS, 81, "a page visits too many corners")

    def demand_counts(self, level):
        counts = level.node_count, level.wedge_count, level.face_count
        demand(self.hierarchy.counts() == counts, 82, "the counts after a level are not the table's")
