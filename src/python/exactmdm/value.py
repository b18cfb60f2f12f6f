"""Objects that do not change."""

from __future__ import annotations

from typing import Any, NoReturn


class Value:
    """An object whose attributes are set once; `functools.cached_property` works in it."""

    def __init__(self) -> None:
        raise TypeError(f"{type(self).__name__} is what functions of exactmdm return: call them")

    def _set(self, **attributes: Any) -> None:
        vars(self).update(attributes)

    def __setattr__(self, name: str, value: object) -> NoReturn:
        raise AttributeError(f"{type(self).__name__} does not change: make a new one")

    def __delattr__(self, name: str) -> NoReturn:
        raise AttributeError(f"{type(self).__name__} does not change: make a new one")
