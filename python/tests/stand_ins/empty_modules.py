"""Modules that are not installed, for packages that import them and do not use them here."""

import importlib.abc
import importlib.machinery
import types


class _AnyName(type):
    """The class of everything in a module that is not installed: each of its attributes is again such a class."""

    def __getattr__(cls, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return Nothing

    def __or__(cls, other):
        return cls

    __ror__ = __or__


class Nothing(metaclass=_AnyName):
    pass


class EmptyModules(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    """Finds modules of these names, and those in them: modules that have every name."""

    def __init__(self, names):
        self.names = names

    def find_spec(self, name, path, target=None):
        if any(name == one or name.startswith(one + ".") for one in self.names):
            return importlib.machinery.ModuleSpec(name, self, is_package=True)
        return None

    def create_module(self, spec):
        module = types.ModuleType(spec.name)
        module.__path__ = []
        module.__getattr__ = lambda name: Nothing
        return module

    def exec_module(self, module):
        pass
