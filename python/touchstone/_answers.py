# SPDX-License-Identifier: Apache-2.0
"""The answers of decisions over arrays. The number of the first enumerator is 0: as a truth value it would be false, as an
index the first row. So neither enumerators nor their arrays serve as conditions, masks or indices."""
from __future__ import annotations

from collections.abc import Iterator
from enum import IntEnum
from typing import Any, NoReturn, Union

import numpy
from numpy.typing import NDArray

Mask = NDArray[numpy.bool_]


class Enumeration(IntEnum):
    """One of several possible answers. It is compared, `answer == Side.left`, and refuses to be a condition."""

    def __bool__(self) -> NoReturn:
        raise TypeError(f"{self!s} is no condition, compare it: answer == {self!s}")

    def __str__(self) -> str:
        return f"{type(self).__name__}.{self.name}"


class Answers:
    """An enumerator for each row.

    answers == Side.left, answers != Side.left      masks: arrays of bool
    answers.isin(Side.left, Side.on)                the same of several enumerators
    answers[17], answers[mask], list(answers)       enumerators, answers of some rows
    answers.numbers                                 the numbers of the enumerators, an array of uint8
    """

    __slots__ = ("enumeration", "numbers")
    __array_ufunc__ = None  # numpy leaves operators to this class
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, enumeration: type[Enumeration], numbers: NDArray[numpy.uint8]) -> None:
        self.enumeration, self.numbers = enumeration, numbers

    def __eq__(self, other: object) -> Mask:  # type: ignore[override]
        mask: Mask = self.numbers == self._numbers_of(other)
        return mask

    def __ne__(self, other: object) -> Mask:  # type: ignore[override]
        mask: Mask = self.numbers != self._numbers_of(other)
        return mask

    def isin(self, *enumerators: Enumeration) -> Mask:
        return numpy.isin(self.numbers, numpy.array([self._numbers_of(enumerator) for enumerator in enumerators]))

    def __len__(self) -> int:
        return len(self.numbers)

    def __iter__(self) -> Iterator[Enumeration]:
        return map(self.enumeration, self.numbers.tolist())

    def __getitem__(self, rows: Any) -> Any:
        found = self.numbers[rows]
        return Answers(self.enumeration, found) if isinstance(found, numpy.ndarray) else self.enumeration(int(found))

    def __repr__(self) -> str:
        names = [enumerator.name for enumerator in self[:8]]
        return f"<{len(self)} answers of {self.enumeration.__name__}: {', '.join(names)}{', ...' if len(self) > 8 else ''}>"

    def __bool__(self) -> NoReturn:
        self._refuse()

    def __array__(self, *_: Any, **__: Any) -> NoReturn:
        self._refuse()

    def _refuse(self) -> NoReturn:
        first = self.enumeration(0)
        raise TypeError(f"answers are no mask and no index: write answers == {first!s} for a mask, answers.numbers for numbers")

    def _numbers_of(self, other: object) -> Union[int, NDArray[numpy.uint8]]:
        """Returns the numbers of an enumerator or of other answers; those of another enumeration would compare by chance."""
        if isinstance(other, self.enumeration):
            return int(other)
        if isinstance(other, Answers) and other.enumeration is self.enumeration:
            return other.numbers
        raise TypeError(f"answers of {self.enumeration.__name__} are compared with its enumerators, found {other!r}")
