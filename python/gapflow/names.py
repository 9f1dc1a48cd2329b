"""Names that users type: those that do not exist are refused with the nearest that does, in the words of the reader of scenes."""
from __future__ import annotations

import functools
import inspect
from typing import Any, Callable, Iterable, TypeVar

from . import _core

F = TypeVar("F", bound=Callable[..., Any])
C = TypeVar("C", bound=type)


def unknown(owner: str, name: str, names: Iterable[str], what: str = "key") -> str:
    """The message for a name that is none of `names`."""
    names = list(names)
    near = _core.nearest_name(name, names)
    return f"{owner}: {name}: unknown {what}{f'; did you mean {near!r}?' if near else ''} (there are: {', '.join(names)})"


class Named:
    """An object whose attributes that do not exist cannot be set."""

    __slots__ = ()

    def __setattr__(self, name: str, value: Any) -> None:
        _set_attribute(self, name, value)


def _set_attribute(owner: Any, name: str, value: Any) -> None:
    kind = type(owner)
    if not name.startswith("_") and not hasattr(kind, name):
        names = sorted(n for n in dir(kind) if not n.startswith("_"))
        raise AttributeError(unknown(kind.__name__, name, names, "attribute"))
    object.__setattr__(owner, name, value)


def checked_arguments(function: F) -> F:
    """The function, which refuses arguments by names that it does not have with the nearest that it has (TypeError)."""
    names = [name for name, parameter in inspect.signature(function).parameters.items()
             if parameter.kind in (parameter.KEYWORD_ONLY, parameter.POSITIONAL_OR_KEYWORD) and name not in ("self", "cls")]
    shown = function.__qualname__.removesuffix(".__init__")

    @functools.wraps(function)
    def checked(*arguments: Any, **named: Any) -> Any:
        for name in named:
            if name not in names:
                raise TypeError(unknown(shown, name, names, "argument"))
        return function(*arguments, **named)

    return checked  # type: ignore[return-value]


def checked_names(kind: C) -> C:
    """A data class with slots whose arguments and attributes are checked so."""
    fields = [name for name in kind.__dataclass_fields__ if kind.__dataclass_fields__[name].init]
    init = kind.__init__

    @functools.wraps(init)
    def checked(self: Any, *arguments: Any, **named: Any) -> None:
        for name in named:
            if name not in fields:
                raise TypeError(unknown(kind.__name__, name, fields))
        init(self, *arguments, **named)

    kind.__init__ = checked  # type: ignore[misc]
    kind.__setattr__ = _set_attribute  # type: ignore[assignment]
    return kind
