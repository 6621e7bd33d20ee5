# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""Which wedges a split's corners get (docs/format.md, section 4.5)."""
from page_streams import CLASS_CHOICES, CLASS_PICKS, MEMBER_CHOICES, MEMBER_PICKS, THIRD_CHOICES, THIRD_PICKS
from refused import demand
from ring import MAX_RING

MOST_CORNERS = 64


class Members:
    """The wedges of a class at one child, and which of them have corners."""

    def __init__(self, wedges):
        self.wedges = wedges
        self.met, self.first_met, self.last = 0, False, None

    def lack_corners(self):
        return len(self.wedges) > 0 and (not self.first_met or self.met + 1 < len(self.wedges))

    def guess_for_fan(self):
        """(member, whether it is sure)"""
        return (0, False) if self.last is None else (self.last, True)

    def guess_for_face(self, beside):
        """beside  the member of the fan's corner beside, None where there is none of the class"""
        if self.met + 1 < len(self.wedges):
            return self.met + 1, self.first_met
        if not self.first_met:
            return 0, True
        return (0, False) if beside is None else (beside, True)

    def pick(self, page, guess, sure):
        """The wedge that the next corner gets."""
        demand(len(self.wedges) > 0, 77, "a class has no wedge where a corner needs one")
        member = 0
        if len(self.wedges) > 1:
            others = [member for member in range(min(self.met + 2, len(self.wedges))) if member != guess]
            place = page.streams[MEMBER_PICKS if sure else MEMBER_CHOICES].value()
            demand(place <= len(others), 77, "a member's pick is out of range")
            member = [guess, *others][place]
        self.met = max(self.met, member)
        self.first_met = self.first_met or member == 0
        self.last = member
        return self.wedges[member]


class Beside:
    """The fan's corner beside one corner of a new face, after it has moved: its class, its member, its wedge at c."""

    def __init__(self, wedge_class, member, third):
        self.wedge_class, self.member, self.third = wedge_class, member, third

    def member_of(self, wedge_class):
        return self.member if self.wedge_class == wedge_class else None


NOTHING_BESIDE = Beside(None, None, None)


class ChoiceList:
    """Candidates, entries that lack corners, the rest."""

    def __init__(self, entries, lacking, proposed):
        """entries   the choices, ascending
        lacking   those of them that lack corners
        proposed  for a candidate: Y's, then X's; None where there is none"""
        self.candidates = []
        for entry in sorted(proposed, key=lambda entry: entry not in lacking):
            if entry in entries and entry not in self.candidates:
                self.candidates.append(entry)
        self.others_lack = [entry for entry in entries if entry in lacking and entry not in self.candidates]
        head = self.candidates + self.others_lack
        self.entries = head + [entry for entry in entries if entry not in head]

    def pick(self, page, picks, choices, sure):
        demand(self.entries, 77, "there is nothing to choose")
        if len(self.entries) == 1:
            return self.entries[0]
        place = page.streams[picks if sure else choices].value()
        demand(place < len(self.entries), 77, "a pick is out of range")
        return self.entries[place]


class Picks:
    """Moves the corners of a split and adds its faces."""

    def __init__(self, split):
        self.split, self.page, self.hierarchy = split, split.page, split.hierarchy
        self.fan, self.sides = split.fan, split.sides
        self.members = [[Members(wedges) for wedges in one.members] for one in split.classes]
        self.went = {}
        self.visited = 0

    def class_of(self, spoke):
        return self.fan.spokes[spoke].wedge - self.split.node.wedges.start

    def move_fan(self, order):
        """order  of the corners, as indices of spokes"""
        for at in order:
            corner, side = self.fan.spokes[at].corner, self.sides[at]
            members = self.members[self.class_of(at)][side]
            wedge = members.pick(self.page, *members.guess_for_fan())
            self.went[at] = members.last
            self.hierarchy.faces[corner // 3][corner % 3] = wedge
        for at, spoke in enumerate(self.fan.spokes):
            self.hierarchy.nodes[self.split.children[self.sides[at]]].corners.append(spoke.corner)
        self.split.node.corners = []

    def beside(self, side, c, is_next):
        """What lies beside the corner at `side`: the first corner there whose next (or previous) node is c."""
        if len(self.fan.spokes) > MAX_RING:
            return NOTHING_BESIDE
        for at, spoke in enumerate(self.fan.spokes):
            node, wedge = spoke.neighbours()[0 if is_next else 1]
            if self.sides[at] == side and node == c:
                return Beside(self.class_of(at), self.went[at], wedge)
        return NOTHING_BESIDE

    def add_face(self, face):
        nodes = self.hierarchy.nodes
        exists = face.c < len(nodes) and nodes[face.c].children is None
        demand(exists and face.c not in self.split.children, 78, "a new face's third node is not in the cut")
        at_y, at_x = self.beside(1 - face.first, face.c, True), self.beside(face.first, face.c, False)
        self.count_visits(len(self.members), len(nodes[face.c].wedges))
        index = self.pick_class(at_y, at_x)
        x, y = self.members[index][face.first], self.members[index][1 - face.first]
        first = x.pick(self.page, *x.guess_for_face(at_x.member_of(index)))
        last = y.pick(self.page, *y.guess_for_face(at_y.member_of(index)))
        wedges = [first, self.pick_third(face.c, index, at_y, at_x), last]
        demand(len({self.hierarchy.wedges[wedge].part for wedge in wedges}) == 1, 77, "a face would mix parts")
        self.hierarchy.add_face(wedges)

    def count_visits(self, *lists):
        self.visited += sum(length for length in lists if length > 1)

    def pick_class(self, at_y, at_x):
        entries = [index for index, (a, b) in enumerate(self.members) if a.wedges and b.wedges]
        lacking = [index for index in entries if any(members.lack_corners() for members in self.members[index])]
        choices = ChoiceList(entries, lacking, [at_y.wedge_class, at_x.wedge_class])
        return choices.pick(self.page, CLASS_PICKS, CLASS_CHOICES, len(choices.candidates) == 1)

    def pick_third(self, c, index, at_y, at_x):
        wedges, part = self.hierarchy.nodes[c].wedges, self.split.classes[index].wedge.part
        entries = [wedge for wedge in wedges if self.hierarchy.wedges[wedge].part == part]
        lacking = self.without_corners(c)
        proposed = [beside.third for beside in (at_y, at_x) if beside.wedge_class == index]
        choices = ChoiceList(entries, lacking, proposed)
        sure = len(choices.candidates) == 1 and not choices.others_lack
        return choices.pick(self.page, THIRD_PICKS, THIRD_CHOICES, sure)

    def without_corners(self, node):
        corners, wedges = self.hierarchy.nodes[node].corners, self.hierarchy.nodes[node].wedges
        if len(wedges) == 1 or len(corners) > MOST_CORNERS:
            return []
        used = {self.hierarchy.faces[corner // 3][corner % 3] for corner in corners}
        return [wedge for wedge in wedges[:MOST_CORNERS] if wedge not in used]
