"""Litters of soft, warm pups that huddle (Wilson 2017).

>>> import pupflow
>>> litter = pupflow.Litter("cold", seed=1, ta=0.3)
>>> litter.step(500)
>>> litter.tb.shape
(12,)

help(pupflow.Litter) lists all that a litter shows and takes; docs/python.md has examples.
"""

from pupflow._core import (
    BadNumbers,
    Litter,
    __version__,
    fields,
    load,
    parameters,
    run,
    scenes,
)
from pupflow._littermates import littermates

__all__ = ["BadNumbers", "Litter", "fields", "littermates", "load", "parameters", "run", "scenes"]
