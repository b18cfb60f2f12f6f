"""Exceptions, and the file and line that an error names."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, Union


class InputError(ValueError):
    """Bad input: a file, a number or an option. The message says where, what is wrong, and what to do.

    >>> try:
    ...     exactmdm.Gradation(sizes=["1", "2"], masses=["1", "x"])
    ... except exactmdm.InputError as error:
    ...     print(error)
    masses[1]: 'x' is not a number: write a decimal such as 3.86
    """

    #: The file that is wrong, or None.
    file: str | None
    #: The line of it, counted from 1, or None.
    line: int | None

    def __init__(self, message: str, file: str | None = None, line: int | None = None) -> None:
        super().__init__(message)
        self.file = file
        self.line = line

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.args[0], self.file, self.line)


class _Ended(BaseException):
    """The end of a search before its time."""

    known: Any

    def __init__(self, message: str, known: Any) -> None:
        super().__init__(message)
        self.known = known

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.args[0], self.known)


class LimitReached(_Ended, Exception):
    """A limit came before the end. `known` is what is certain: a Match or a Spectrum."""


class Interrupted(_Ended, KeyboardInterrupt):
    """Ctrl-C ended a search. `known` is what is certain, as in LimitReached."""


def cannot_read(path: Union[str, "os.PathLike[str]"], error: Exception) -> InputError:
    """The error of a file that the system does not read."""
    reason = getattr(error, "strerror", None) or str(error)
    return InputError(f"{os.fspath(path)}: it cannot be read: {reason}", os.fspath(path))


def located(message: str, name: str) -> InputError:
    """The error of a file, with the line where the message begins with both."""
    if not message.startswith(name + ":"):
        return InputError(f"{name}: {message}", name)
    line = re.match(r":(\d+):", message[len(name):])
    return InputError(message, name, int(line[1]) if line else None)


@contextmanager
def in_file(name: str) -> Iterator[None]:
    """Adds the file and its line to an InputError."""
    try:
        yield
    except InputError as error:
        raise located(str(error), name) from None
