# SPDX-License-Identifier: Apache-2.0
"""Decisions over arrays on several threads."""
import numpy
import pytest
import touchstone
from touchstone import arrays


def test_threads_change_no_answer_and_no_error():
    points = numpy.stack([0.1 * (numpy.arange(50000) % 97), 0.3 * (numpy.arange(50000) % 101)], axis=1)
    line = numpy.array([[0.0, 0.0], [0.1, 0.3]])
    alone = arrays.orientation(line[0], line[1], points).numbers.tolist()
    try:
        for threads in (0, 2, 5):
            touchstone.use_threads(threads)
            assert arrays.orientation(line[0], line[1], points).numbers.tolist() == alone
            wrong = points.copy()
            wrong[[30000, 49000], 1] = numpy.nan
            with pytest.raises(touchstone.InvalidInput, match=r"questions\[30000\]\.p\[1\]"):
                arrays.orientation(line[0], line[1], wrong)
    finally:
        touchstone.use_threads(1)


@pytest.mark.parametrize("count", [-1, 1.5, "2", None, True])
def test_a_count_of_threads_that_is_none_is_refused(count):
    with pytest.raises(touchstone.InvalidInput, match="count: a whole number, 0 or more, found "):
        touchstone.use_threads(count)
