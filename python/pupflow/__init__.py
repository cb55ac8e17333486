"""Litters of soft, warm pups that huddle (Wilson 2017).

>>> import pupflow
>>> litter = pupflow.Litter("cold", seed=1, ta=0.3)
>>> litter.step(500)
>>> litter.tb.shape
(12,)

help(pupflow.Litter) lists all that a litter shows and takes; docs/python.md has examples.
"""

from pupflow import _core
from pupflow._core import BadNumbers, Litter, __version__
from pupflow._littermates import littermates

__all__ = ["BadNumbers", "Litter", "fields", "littermates", "load", "parameters", "run", "scenes"]


# Functions of Python can be pickled, for processes that run litters, and have a signature.


def run(scene=None, **parameters):
    return _core.run(scene, **parameters)


def load(path):
    return _core.load(path)


def scenes():
    return _core.scenes()


def parameters():
    return _core.parameters()


def fields():
    return _core.fields()


for _function in (run, load, scenes, parameters, fields):
    _function.__doc__ = getattr(_core, _function.__name__).__doc__.partition("\n\n")[2]
del _function
