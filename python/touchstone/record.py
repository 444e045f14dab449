# SPDX-License-Identifier: Apache-2.0
"""Records calls of one's own functions, with their answers, in a log (docs/own_inputs.md). This file stands alone.

    @recorded("segment_segment")
    def segments_meet(a, b):
        ...

    with Recording("app.jsonl", engine="my app 1.0", one_in=100):
        run()

While a Recording is open, calls of decorated functions go into it, from any thread; at other times they cost nothing to
speak of. Each thread fills a buffer of its own; one is written as whole lines when it is full and when the log is closed.
A process that is killed loses what was in its buffers; the log then has no end mark.
"""
import atexit
import functools
import inspect
import itertools
import json
import random
import threading
from typing import Any, Callable, Iterable, Optional, TypeVar

__all__ = ["Recording", "nearness", "recorded"]

Function = TypeVar("Function", bound=Callable[..., Any])
_BUFFER = 1 << 16
_RESERVE = 200  # bytes that the end mark may take
_local = threading.local()
_open: "Optional[Recording]" = None


def nearness(value: float) -> None:
    """How near to degenerate the call is that this thread records next: |determinant| / error bound. May be said inside of
    the function that is recorded; where it is given several times, the least counts."""
    _local.nearness = min(value, getattr(_local, "nearness", float("inf")))


class _Buffer:
    """The calls of one thread."""

    def __init__(self) -> None:
        self.lines: "list[str]" = []
        self.size = self.seen = self.sampled_out = self.lost = 0
        self.sites: "dict[int, list[int]]" = {}  # by function: calls seen, calls that are left out next


class Recording:
    """A log that is open from `open()` to `close()`, in a `with` block, and no longer than the program runs.

    engine: name and version of what is recorded; boundary: "closed" or "open", whether what only touches meets;
    tolerance: in the unit of the input. one_in: of each function one call in so many is written, at random; first: its
    first calls in each thread are all written, and so are those whose nearness() is less than `near`. most_bytes: of the
    file; calls for which there is no room are counted as lost.
    """

    def __init__(self, file: str, *, engine: str = "", boundary: Optional[str] = None, tolerance: float = 0, one_in: int = 1,
                 first: int = 0, near: float = 0, most_bytes: int = 1 << 30, seed: int = 1) -> None:
        self.one_in, self.first, self.near, self.most_bytes = one_in, first, near, most_bytes
        self._file, self._bytes, self._full = file, 0, False
        self._random = random.Random(seed)
        self._lock = threading.Lock()
        self._buffers: "list[_Buffer]" = []
        self._of_thread = threading.local()
        self._written = self._lost = 0
        self._out: Any = None
        self._header: "dict[str, Any]" = {"touchstone_log": 1, "engine": engine}
        if boundary is not None:
            self._header["boundary"] = boundary
        if tolerance:
            self._header["tolerance"] = tolerance
        self._header["sampled"] = {"one_in": max(one_in, 1), **({"first": first} if first else {}), **({"near": near} if near else {})}

    def open(self) -> "Recording":
        global _open
        if _open is not None:
            _open.close()
        self._out = open(self._file, "wb", buffering=0)
        self._write([_line(self._header)])
        atexit.register(self.close)
        _open = self
        return self

    def close(self) -> None:
        global _open
        if self._out is None:
            return
        if _open is self:
            _open = None
        atexit.unregister(self.close)
        with self._lock:
            for buffer in self._buffers:
                self._flush(buffer)
            seen, left_out, lost = (sum(getattr(buffer, name) for buffer in self._buffers) for name in ("seen", "sampled_out", "lost"))
            end = {"seen": seen, "written": self._written, "sampled_out": left_out, "lost": lost + self._lost}
            self._out.write(_line({"end": end}).encode())
            self._out.close()
            self._out = None

    def __enter__(self) -> "Recording":
        return self.open()

    def __exit__(self, *_: Any) -> None:
        self.close()

    def _buffer(self) -> _Buffer:
        buffer: Optional[_Buffer] = getattr(self._of_thread, "buffer", None)
        if buffer is None:
            buffer = self._of_thread.buffer = _Buffer()
            with self._lock:
                self._buffers.append(buffer)
        return buffer

    def wants(self, function: int) -> bool:
        """Counts the next call of a function and says whether it is written."""
        buffer, near = self._buffer(), getattr(_local, "nearness", float("inf"))
        _local.nearness = float("inf")
        buffer.seen += 1
        if self.one_in > 1:
            site = buffer.sites.setdefault(function, [0, 0])
            site[0] += 1
            if site[0] > self.first and not near < self.near:
                if site[1] > 0:
                    site[1] -= 1
                    buffer.sampled_out += 1
                    return False
                site[1] = self._random.randrange(2 * self.one_in - 1)
        if self._full:
            buffer.lost += 1
        return not self._full

    def write(self, operation: str, question: "dict[str, Any]", site: str, *, answer: Any = None, error: Optional[str] = None,
              binary32: bool = False) -> None:
        """A call for which wants() has said yes."""
        line: "dict[str, Any]" = {"op": operation, "input": question}
        line.update({"answer": answer} if error is None else {"error": error})
        if binary32:
            line["number"] = "binary32"
        buffer = self._buffer()
        try:
            text = _line({**line, "site": site})
        except Exception:  # of whatever kind: the program that is recorded goes on
            buffer.lost += 1
            return
        buffer.lines.append(text)
        buffer.size += len(text)
        if buffer.size >= _BUFFER:
            with self._lock:
                self._flush(buffer)

    def _flush(self, buffer: _Buffer) -> None:
        lines, buffer.lines, buffer.size = buffer.lines, [], 0
        written = self._write(lines)
        self._written += written
        self._lost += len(lines) - written

    def _write(self, lines: "list[str]") -> int:
        """All of them with one write, or those for which there is room."""
        sizes = list(itertools.accumulate(map(len, lines), initial=self._bytes))  # they are ASCII
        count = 0 if self._full or self._out is None else sum(size + _RESERVE <= self.most_bytes for size in sizes[1:])
        if count < len(lines):
            self._full = True
        if count > 0:
            self._out.write("".join(lines[:count]).encode())
            self._bytes = sizes[count]
        return count


def _line(value: Any) -> str:
    return json.dumps(value, separators=(",", ":"), default=_plain) + "\n"


def _plain(value: Any) -> Any:
    """An array, or a number of numpy, as JSON has it; of an enumerator its name."""
    for method in ("tolist", "item"):
        if hasattr(value, method):
            return getattr(value, method)()
    if hasattr(value, "name"):
        return value.name
    if hasattr(value, "__float__"):
        return float(value)
    return list(value)


def _is_binary32(values: Iterable[Any]) -> bool:
    types = {str(value.dtype) for value in values if hasattr(value, "dtype")}
    return types == {"float32"}


def recorded(operation: str, *, fields: "Optional[list[str]]" = None, answer: Optional[str] = None,
             rows: bool = False) -> Callable[[Function], Function]:
    """A decorator: calls of the function are recorded as calls of an operation (`touchstone ops`).

    fields: the operation's names of the arguments, where the function's parameters have others. The return value
    is true or false, or the whole answer as a dict; with `answer`, it is the value of that one field. None is not
    recorded; an exception is, as an error. rows: arguments and answer are arrays over many questions, each row a call.
    """

    def decorate(function: Function) -> Function:
        parameters = list(inspect.signature(function).parameters)
        of_object = int(parameters[:1] in (["self"], ["cls"]))  # a method: the object is no argument of the operation
        parameters = parameters[of_object:]
        names = list(fields) if fields else parameters
        field_of = dict(zip(parameters, names))
        code = inspect.unwrap(function).__code__
        site, key = f"{code.co_filename}:{code.co_firstlineno}", id(code)

        def put(recording: Recording, question: "dict[str, Any]", binary32: bool, returned: Any) -> None:
            if recording.wants(key):
                value = {answer: returned} if answer is not None else returned
                recording.write(operation, question, site, answer=value, binary32=binary32)

        @functools.wraps(function)
        def called(*arguments: Any, **named: Any) -> Any:
            recording = _open
            if recording is None:
                return function(*arguments, **named)
            values = list(arguments[of_object:]) + list(named.values())
            keys = names[:len(arguments) - of_object] + [field_of.get(name, name) for name in named]
            binary32 = _is_binary32(values)
            try:
                returned = function(*arguments, **named)
            except Exception as error:
                if not rows and recording.wants(key):
                    recording.write(operation, dict(zip(keys, values)), site, error=str(error), binary32=binary32)
                raise
            if rows:
                try:
                    calls = list(zip(*values, returned))
                except TypeError:  # no rows
                    calls = [(*values, returned)]
                for *row, result in calls:
                    put(recording, dict(zip(keys, row)), binary32, result)
            elif returned is not None:
                put(recording, dict(zip(keys, values)), binary32, returned)
            return returned

        return called  # type: ignore[return-value]

    return decorate
