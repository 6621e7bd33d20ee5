# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""All pages of a file, decoded in order, and the triangles of every level (docs/format.md, sections 3 to 5)."""
from base_page import decode_base
from hierarchy import Hierarchy
from lithe_file import LitheFile
from page_streams import PageStreams
from refused import demand
from split_page import SplitPages


class DecodedFile:
    """file       the head, a LitheFile
    hierarchy  nodes and wedges of all levels, and the finest level's faces
    faces      per level: the wedges of its faces, by face id
    hidden     per level: the faces of it that are not drawn"""

    def __init__(self, data, level_count=None):
        """level_count  how many levels to decode, from the coarsest on; None for all"""
        self.file = LitheFile(data)
        self.levels = self.file.levels[:level_count]
        self.hierarchy = Hierarchy(self.file.info, len(self.file.parts), len(self.file.joints))
        self.faces, self.hidden = [], []
        self.split_pages = SplitPages(self.file, self.hierarchy)
        for index in range(self.levels[-1].page_end):
            self.decode_page(index)

    def decode_page(self, index):
        entry = self.file.pages[index]
        before = self.file.pages[index - 1] if index else None
        page = PageStreams(self.file.page_bytes(index), self.file.info, entry, before)
        if index == 0:
            decode_base(page, self.hierarchy, entry)
            self.keep_faces()
        else:
            for _ in self.split_pages.decode(page, entry):
                self.keep_faces()
        page.demand_end()
        demand(self.hierarchy.counts() == entry.counts(), 82, "the counts after a page are not the table's")
        self.hidden += page.hidden_faces([self.file.levels[level] for level in entry.ending])

    def keep_faces(self):
        self.faces.append([tuple(wedges) for wedges in self.hierarchy.faces])

    def triangles(self, level):
        """The level's triangles as wedges, part by part, within a part by face id."""
        drawn = [wedges for face, wedges in enumerate(self.faces[level]) if face not in self.hidden[level]]
        return sorted(drawn, key=lambda wedges: self.hierarchy.wedges[wedges[0]].part)
