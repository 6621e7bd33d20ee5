# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""Why a file is not read: the checks of docs/format.md, section Reader checks."""


class Refused(Exception):
    """A check failed. `check` is its number in docs/format.md."""

    def __init__(self, check, sentence):
        super().__init__(f"check {check}: {sentence}")
        self.check = check


def demand(condition, check, sentence):
    """Refuses the file unless `condition` holds."""
    if not condition:
        raise Refused(check, sentence)
