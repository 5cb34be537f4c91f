"""The distance between two sets of parts: an optimal matching of the parts under edit distance.

A part is a sequence of symbols. Two parts differ by their Levenshtein distance d; parts are matched one to one, and
one that is left over costs d to the empty part, which is its length. The sum over a cheapest matching is a metric
(Ramon and Bruynooghe 2001). Most of the work is done for many pairs of sets at once, in NumPy.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import accumulate

import numpy as np

from nppg.errors import NppgError

Part = tuple[int, ...]

_TABLE = 4096  # numbers of parts whose distances are tabulated
_BATCH = 16384  # pairs of sets that are looked at together
_SINGLES = 6  # so many pairs of sets are looked at one by one
_SUBSETS = 6  # a matching with no more than so many parts on one side is found by going through their subsets


class PartSets:
    """Numbers sets of parts and compares them. Numbers count from 0, in the order in which sets are met.

    The parts are numbered, too. The second of two equal parts of one set has a number of its own, so that a multiset
    of parts is a set of numbers; number 0 is an empty part, which fills up the rows of `_members`.
    """

    def __init__(self) -> None:
        try:
            from scipy.optimize import linear_sum_assignment
        except ImportError:
            message = "the distance between states needs scipy, which is not installed: pip install nppg[rrl]"
            raise NppgError(message) from None
        self._assignment = linear_sum_assignment
        self._parts: dict[tuple[Part, int], int] = {((), -1): 0}
        self._symbols = np.zeros((1, 0), np.int32)  # of each part, filled up
        self._lengths = np.zeros(1, np.int32)
        self._gains = np.zeros((_TABLE, _TABLE), np.int16)  # what matching two parts saves; memory is used as it fills
        self._tabulated = 1
        self._sets: dict[Part, int] = {}
        self._members = np.zeros((0, 0), np.int32)
        self._sizes = np.zeros(0, np.int32)  # of each set: how many parts it has, and how long they are in all
        self._total = np.zeros(0, np.int32)

    def __len__(self) -> int:
        return len(self._sets)

    def number(self, parts: Iterable[Part]) -> int:
        """The number of a multiset of parts."""
        copies: dict[Part, int] = {}
        members = []
        for part in parts:
            copies[part] = copy = copies.get(part, -1) + 1
            member = self._parts.get((part, copy))
            members.append(self._new_part(part, copy) if member is None else member)
        key = tuple(sorted(members))
        number = self._sets.setdefault(key, len(self._sets))
        if number == len(self._sets) - 1:
            self._members = grown(self._members, number + 1, len(key))
            self._members[number, : len(key)] = key
            self._sizes, self._total = grown(self._sizes, number + 1), grown(self._total, number + 1)
            self._sizes[number], self._total[number] = len(key), self._lengths[members].sum()
        return number

    def _new_part(self, part: Part, copy: int) -> int:
        number = len(self._parts)
        self._parts[part, copy] = number
        self._symbols = grown(self._symbols, number + 1, len(part))
        self._symbols[number, : len(part)] = part
        self._lengths = grown(self._lengths, number + 1)
        self._lengths[number] = len(part)
        return number

    def distances(self, lefts: np.ndarray, rights: np.ndarray) -> np.ndarray:
        """The distances of sets, by their numbers, from others, shape (lefts, rights)."""
        self._tabulate()
        if len(lefts) * len(rights) <= _SINGLES:
            return np.array([[self._single(left, right) for right in rights] for left in lefts]).reshape(
                len(lefts), len(rights)
            )
        found = np.zeros((len(lefts), len(rights)), np.int64)
        order = np.argsort(-self._sizes[rights], kind="stable")
        rights, sizes = rights[order], self._sizes[lefts]
        step = 1 + _BATCH // max(1, len(rights))
        for size in np.flatnonzero(np.bincount(sizes)).tolist():
            some = np.flatnonzero(sizes == size)
            for start in range(0, len(some), step):
                batch = some[start : start + step]
                compared = self._few if size <= _SUBSETS else self._many
                found[batch[:, None], order] = compared(lefts[batch], rights)
        return found

    def _single(self, left: int, right: int) -> int:
        sets = [self._members[each, : self._sizes[each]] for each in (left, right)]
        gains = self._gain(sets[0][:, None], sets[1])
        return self._total[left] + self._total[right] + gains[self._assignment(gains)].sum()

    def _few(self, lefts: np.ndarray, rights: np.ndarray) -> np.ndarray:
        """As `distances`, of sets that have equally few parts, from others that come by size, the largest first. What
        many of them share is looked up once."""
        total = self._total[lefts, None] + self._total[rights]
        parts, columns = np.unique(self._members[lefts, : self._sizes[lefts[0]]].T, return_inverse=True)
        columns = columns.reshape(-1, len(lefts))  # of NumPy 2.0 and others
        sizes = self._sizes[rights]
        ends = np.searchsorted(-sizes, -np.arange(sizes[0])).tolist()
        rows = [self._members[rights[:end], i] for i, end in enumerate(ends)]
        gains = self._gains_of(parts, np.concatenate([np.zeros(0, int), *rows]))
        if total.max() < 128:  # no sum of gains is below -total
            gains = gains.astype(np.int8)
        starts = accumulate(ends, initial=0)
        stretches = [gains[:, start : start + end][columns] for start, end in zip(starts, ends, strict=False)]
        return total + _best(stretches, (*columns.shape, len(rights)))

    def _many(self, lefts: np.ndarray, rights: np.ndarray) -> np.ndarray:
        """As `distances`, of sets of any size."""
        every = [each.ravel() for each in np.broadcast_arrays(lefts[:, None], rights)]
        found = np.empty(len(every[0]), np.int64)
        for start in range(0, len(found), _BATCH):
            left, right = (self._members[each[start : start + _BATCH]].T.copy() for each in every)
            found[start : start + _BATCH] = self._batch(left, right)
        return found.reshape(len(lefts), len(rights))

    def _batch(self, left: np.ndarray, right: np.ndarray) -> np.ndarray:
        """The distances of pairs of sets, as columns of part numbers, shape (pairs,).

        Parts that both sets have are matched with each other: if a cheapest matching pairs such a part p with r and
        with q instead, d(p, p) + d(q, r) <= d(q, p) + d(p, r), the triangle inequality, so re-pairing costs nothing.
        """
        for part in left:
            common = (right == part) & (part > 0)
            right[common] = 0
            part[common.any(axis=0)] = 0
        left, right = np.sort(left, axis=0)[::-1], np.sort(right, axis=0)[::-1]
        total = self._lengths[left].sum(axis=0) + self._lengths[right].sum(axis=0)
        many, few = (left > 0).sum(axis=0), (right > 0).sum(axis=0)
        turned = few > many
        left, right = np.where(turned, right, left), np.where(turned, left, right)
        many, few = np.maximum(many, few), np.minimum(many, few)
        for size in np.flatnonzero(np.bincount(few)):
            if size > 0:
                some = np.flatnonzero(few == size)
                rows, columns = left[: many[some].max(), some], right[:size, some]
                gains = self._gain(rows[:, None, :], columns[None, :, :])
                few_enough = size <= _SUBSETS
                total[some] += _best(gains, gains.shape[1:]) if few_enough else self._assigned(gains)
        return total

    def _assigned(self, gains: np.ndarray) -> np.ndarray:
        """As `_best`, one after the other."""
        return np.array([each[self._assignment(each)].sum() for each in np.moveaxis(gains, 2, 0)])

    def _gain(self, left: np.ndarray, right: np.ndarray) -> np.ndarray:
        """d(p, r) - d(p, empty) - d(r, empty) for part numbers, arrays of shapes that fit; never above 0."""
        if len(self._parts) <= _TABLE:
            return self._gains[left, right]
        left, right = np.broadcast_arrays(left, right)
        return self._computed(left.ravel(), right.ravel()).reshape(left.shape)

    def _gains_of(self, left: np.ndarray, right: np.ndarray) -> np.ndarray:
        """As `_gain`, of each of some parts with each of others that may come many times; shape (left, right)."""
        if len(self._parts) <= _TABLE:
            return self._gains[left, : len(self._parts)].take(right, axis=1)
        others, where = np.unique(right, return_inverse=True)
        return self._gain(left[:, None], others)[:, where]

    def _computed(self, left: np.ndarray, right: np.ndarray) -> np.ndarray:
        lengths = self._lengths[left], self._lengths[right]
        return edit_distances(self._symbols[left], lengths[0], self._symbols[right], lengths[1]) - sum(lengths)

    def _tabulate(self) -> None:
        """Adds the parts that have come since it was called last to the table."""
        old, new = self._tabulated, min(len(self._parts), _TABLE)
        for number in range(old, new):
            others = np.arange(number + 1)
            row = self._computed(np.full(number + 1, number), others)
            self._gains[number, : number + 1] = row
            self._gains[: number + 1, number] = row
        self._tabulated = new


def grown(array: np.ndarray, length: int, *shape: int) -> np.ndarray:
    """The array, or where it is too small a larger copy, twice as long as is wanted; what is new is 0."""
    if len(array) >= length and all(have >= want for have, want in zip(array.shape[1:], shape, strict=True)):
        return array
    rows = len(array) if len(array) >= length else 2 * length
    larger = np.zeros((rows, *map(max, array.shape[1:], shape)), array.dtype)
    larger[tuple(map(slice, array.shape))] = array
    return larger


def edit_distances(
    left: np.ndarray, left_lengths: np.ndarray, right: np.ndarray, right_lengths: np.ndarray
) -> np.ndarray:
    """Levenshtein distances of pairs of sequences, the rows of two arrays of which so many symbols count; insertion,
    deletion and replacement cost 1 (Wagner and Fischer 1974). Shape (pairs,)."""
    pairs = np.arange(len(left))
    ramp = np.arange(right.shape[1] + 1, dtype=np.int32)[:, None]
    row = np.broadcast_to(ramp, (len(ramp), len(left)))  # [j]: from the first i symbols of left to j of right
    found = right_lengths.astype(np.int32)
    for i in range(1, left.shape[1] + 1):
        new = np.empty_like(row)
        new[0] = i
        np.minimum(row[:-1] + (left[:, i - 1] != right.T), row[1:] + 1, out=new[1:])
        row = np.minimum.accumulate(new - ramp, axis=0) + ramp  # row[j] = min(new[j], row[j - 1] + 1)
        found = np.where(left_lengths == i, row[right_lengths, pairs], found)
    return found


def _best(gains: Sequence[np.ndarray] | np.ndarray, shape: tuple[int, ...]) -> np.ndarray:
    """The least sum of gains, none above 0, over the matchings of rows with columns, for many pairs at once. `shape` is
    (columns, ..., pairs), and so is that of each row's gains, but they may be about the first few of the pairs only, no
    more than the row before. Goes through the rows; `best` has an entry for each set of columns that may be used."""
    columns, *rest, pairs = shape
    best = np.zeros((1 << columns, *rest, pairs), gains[0].dtype if len(gains) else np.int16)
    for row in gains:
        some = row.shape[-1]
        before = best[..., :some].copy()
        for column, gain in enumerate(row):
            split = (-1, 2, 1 << column, *rest)
            used = best.reshape(*split, pairs)[:, 1, ..., :some]
            np.minimum(used, before.reshape(*split, some)[:, 0] + gain, out=used)
    return best[-1]
