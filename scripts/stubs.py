#!/usr/bin/env python3
"""Prints python/pupflow/__init__.pyi, made from the tables of the built module.

    PYTHONPATH=build/release/python python3 scripts/stubs.py > python/pupflow/__init__.pyi
"""

import inspect
import textwrap
from collections.abc import Mapping

import pupflow

TEMPLATE = '''\
"""{module}"""

# Written by scripts/stubs.py.

from collections.abc import Callable, Iterator, Mapping
from os import PathLike
from typing import Any, Literal, Protocol, TypedDict

import numpy as np
from numpy.typing import ArrayLike, NDArray

__version__: str
__all__: list[str]

_Numbers = NDArray[np.float64]

class BadNumbers(ArithmeticError):
{BadNumbers}
    kind: str
    stage: str
    step: int
    pup: int
    point: int

class Observables(TypedDict):
{observables}

class Means(TypedDict):
{means}

class _Group(Mapping[str, Any]):
    def keys(self) -> list[str]: ...  # type: ignore[override]
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...
    def __getitem__(self, name: str, /) -> Any: ...

class Params(_Group):
{Params}

class PupFields(_Group):
{PupFields}

class AfferentFields(_Group):
{AfferentFields}

class Litter:
{Litter}

{functions}

class Littermates(Protocol):
{Littermates}
    metadata: dict[str, Any]
    render_mode: str
    possible_agents: list[str]
    agents: list[str]
    litter: Litter | None
    def reset(
        self, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[dict[str, dict[str, _Numbers]], dict[str, dict[str, Any]]]: ...
    def step(
        self, actions: Mapping[str, ArrayLike | None]
    ) -> tuple[
        dict[str, dict[str, _Numbers]],
        dict[str, float],
        dict[str, bool],
        dict[str, bool],
        dict[str, dict[str, Any]],
    ]: ...
    def observation_space(self, agent: str) -> Any: ...
    def action_space(self, agent: str) -> Any: ...
    @property
    def num_agents(self) -> int: ...
    @property
    def max_num_agents(self) -> int: ...
    def render(self) -> NDArray[np.uint8]: ...
    def close(self) -> None: ...
'''

# The parameters that every call with a scene takes.
SCENE = "scene: str | PathLike[str] | None = None"

# Methods and attributes of Litter that no table has: their types. "rw" can be assigned.
METHODS = {
    "copy": "(self) -> Litter",
    "image": """(
        self, width: int = 1280, height: int = 960, *, color_by: str = "tb", colormap: str | None = None,
        scale: tuple[float, float] | None = None, camera: str = "orbit:30,35", bar: bool = True
    ) -> NDArray[np.uint8]""",
    "observe": "(self) -> Observables",
    "record": "(self, field: str) -> None",
    "save": "(self, path: str | PathLike[str], force: bool = False) -> None",
    "step": "(self, count: int = 1) -> None",
}
ATTRIBUTES = {
    "afferent": "AfferentFields", "force": "_Numbers", "hash": "str", "heat": "_Numbers",
    "params": "Params", "points": "int", "position": "NDArray[np.floating[Any]]", "pup": "PupFields",
    "steps_done": "int", "threads": "int", "time": "float", "turn": "_Numbers",
    "velocity": "NDArray[np.floating[Any]]", "warnings": "list[str]",
}
WRITABLE = {"force": "ArrayLike", "heat": "ArrayLike", "turn": "ArrayLike", "threads": "int"}


def indented(text, by=4):
    return textwrap.indent(text, " " * by)


def docstring(words):
    return f'"""{words}"""' if "\n" not in words else f'"""{words}\n"""'


def parameter_type(row):
    """What an attribute gives, and what it takes."""
    if row["choices"]:
        literal = "Literal[" + ", ".join(f'"{choice}"' for choice in row["choices"]) + "]"
        return literal, literal
    return ("int", "int") if isinstance(row["default"], int) else ("float", "float")


def attribute(owner, name, gives, takes=None):
    text = f"@property\ndef {name}(self) -> {gives}:\n" + indented(docstring(getattr(owner, name).__doc__))
    if takes:
        text += f"\n@{name}.setter\ndef {name}(self, value: {takes}) -> None: ..."
    return text


def members(owner):
    """All public members of a class of the module, by name."""
    parameters, fields = pupflow.parameters(), pupflow.fields()
    texts = []
    for name in sorted(name for name in vars(owner) if not name.startswith("_") and not hasattr(Mapping, name)):
        if owner is pupflow.Litter and name in METHODS:
            signature, _, words = getattr(owner, name).__doc__.partition("\n\n")
            texts.append(f"def {name}{METHODS[name]}:\n" + indented(docstring(words)))
        elif owner is pupflow.Litter and name in ATTRIBUTES:
            texts.append(attribute(owner, name, ATTRIBUTES[name], WRITABLE.get(name)))
        elif name in fields["pup"] and owner.__name__ != "Params" or name in fields["afferent"]:
            texts.append(attribute(owner, name, "_Numbers"))
        else:
            texts.append(attribute(owner, name, *parameter_type(parameters[name])))
    return "\n".join(texts)


def keywords():
    """All parameters as keyword arguments."""
    return ", ".join(f"{name}: {parameter_type(row)[1]} = ..." for name, row in pupflow.parameters().items())


def function(name, arguments, result):
    words = getattr(pupflow, name).__doc__
    return f"def {name}({arguments}) -> {result}:\n" + indented(docstring(inspect.cleandoc(words)))


def main():
    litter = pupflow.Litter(pups=1)
    start = f"def __init__(self, {SCENE}, *, {keywords()}) -> None: ..."
    rows = pupflow.fields()
    typed = {"observables": rows["litter"], "means": rows["run"]}
    functions = [
        function("run", f"{SCENE}, *, {keywords()}", "Means"),
        function("load", "path: str | PathLike[str]", "Litter"),
        function("scenes", "", "dict[str, str]"),
        function("parameters", "", "dict[str, dict[str, Any]]"),
        function("fields", "", "dict[str, dict[str, dict[str, Any]]]"),
        function("littermates", f'{SCENE}, *, actions: tuple[Literal["force", "heat", "turn"], ...] = '
                 '("turn",), steps_per_action: int = 10, reward: Callable[[Litter], ArrayLike] | None = None, '
                 + keywords(), "Littermates"),
    ]
    print(TEMPLATE.format(
        module=pupflow.__doc__,
        BadNumbers=indented(docstring(pupflow.BadNumbers.__doc__)),
        Litter=indented("\n".join([docstring(pupflow.Litter.__doc__), start, members(pupflow.Litter)])),
        Littermates=indented('"""What littermates() returns; PettingZoo\'s ParallelEnv where that is installed."""'),
        functions="\n".join(functions),
        **{owner.__name__: indented(docstring(owner.__doc__) + "\n" + members(owner))
           for owner in map(type, (litter.params, litter.pup, litter.afferent))},
        **{name: "\n".join(indented(f"{field}: float") for field in table) for name, table in typed.items()},
    ), end="")


if __name__ == "__main__":
    main()
