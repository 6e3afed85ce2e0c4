"""The compiled module: by AVX2 where the processor has it, unless ``STEWARD_PODRACE_MODULE=plain``."""

import importlib
import os
from types import ModuleType


def load(name: str) -> ModuleType:
    """Imports a module by its name, ``plain`` or ``avx2``."""
    return importlib.import_module(f"steward_podrace._{name}")


def _choose() -> ModuleType:
    plain = load("plain")
    if os.environ.get("STEWARD_PODRACE_MODULE") != "plain" and plain.HAS_AVX2:
        try:
            return load("avx2")
        except ImportError:  # built by a compiler that has no AVX2
            pass
    return plain


core = _choose()


def module_name() -> str:
    """Name of the module in use, ``plain`` or ``avx2``."""
    return core.__name__.rpartition("._")[2]
