"""What ACE prints, and trees in its notation compared up to the names of variables."""

import re
from dataclasses import dataclass

TEST, LEAF = re.compile(r"(.*?)\s*\?\s*$"), re.compile(r"\[(\w+)\]\s*\[([\d.]+)/([\d.]+)\]")
BRANCH = re.compile(r"\+--(yes|no):\s*")
TOKEN = re.compile(r"'[^']*'|\w+|[^\w\s]")


@dataclass(frozen=True)
class Printed:
    """A tree: the tokens of a test and two trees, or a class with how many of how many are of it."""

    test: tuple[str, ...] = ()
    yes: "Printed | None" = None
    no: "Printed | None" = None
    leaf: tuple[str, float, float] | None = None


def tree_of(text):
    """The tree in a text in ACE's compact notation, whatever stands before it."""
    lines = [line.rstrip() for line in text.splitlines() if line.strip()]
    start = next(i for i, line in enumerate(lines) if TEST.match(line) or LEAF.match(line))
    unread = [BRANCH.split(line)[-1].strip(" |") for line in lines[start:]]

    def read():
        line = unread.pop(0)
        if found := LEAF.match(line):
            return Printed(leaf=(found[1], float(found[2]), float(found[3])))
        return Printed(tuple(TOKEN.findall(TEST.match(line)[1])), read(), read())

    return read()


def same(ours, theirs, names):
    """Whether two trees are the same but for the names of variables: `names` are those that are known above them. What
    follows a failed test knows none of its own."""
    if ours.leaf or theirs.leaf:
        return ours.leaf == theirs.leaf
    if len(ours.test) != len(theirs.test):
        return False
    below = dict(names)
    for own, other in zip(ours.test, theirs.test, strict=True):
        if own[0].isupper():
            if below.setdefault(own, other) != other:
                return False
        elif own != other:
            return False
    if len(set(below.values())) < len(below):
        return False
    return same(ours.yes, theirs.yes, below) and same(ours.no, theirs.no, names)


def value(text, name):
    """The number that ACE prints behind a name."""
    return float(re.search(rf"^{name} : ([\d.]+)", text, re.M)[1])
