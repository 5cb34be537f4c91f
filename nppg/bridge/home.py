"""Keeps Prolog at the home that belongs to the libswipl that janus-swi is linked to.

SWI-Prolog looks for its home (boot file and library) in SWI_HOME_DIR, and then beside the `swipl` that comes first on
PATH. If that one is of another version the process aborts, and nothing in Python can catch it ("incompatible
VM-signature"). The dynamic linker knows better: it is asked here which libswipl it takes for janus's extension,
before Prolog starts.
"""

from __future__ import annotations

import ctypes
import os
from contextlib import suppress
from dataclasses import dataclass
from importlib.machinery import EXTENSION_SUFFIXES
from importlib.util import find_spec
from pathlib import Path

OLDEST = (9, 1, 12)
_FOLDERS = ("", "swi-prolog", "swipl", "lib/swi-prolog", "lib/swipl")


@dataclass(frozen=True)
class Linked:
    """The SWI-Prolog that janus-swi is linked to; `home` is None if no boot file lies near its library."""

    extension: Path
    library: Path
    version: tuple[int, int, int]
    home: Path | None

    @property
    def bundled(self) -> bool:
        """Whether it has come inside janus-swi's own wheel, which keeps to it whatever SWI_HOME_DIR says."""
        return self.extension.resolve().parent in self.library.parents


class _Symbol(ctypes.Structure):
    """Dl_info of dlfcn.h."""

    _fields_ = (
        ("file", ctypes.c_char_p),
        ("base", ctypes.c_void_p),
        ("name", ctypes.c_char_p),
        ("address", ctypes.c_void_p),
    )


def linked() -> Linked:
    """Loads janus's extension, without initialising Prolog, and says what it is linked to.

    Raises ModuleNotFoundError without janus-swi, OSError if the extension or its libswipl cannot be loaded.
    """
    extension = _extension()
    loaded = ctypes.CDLL(str(extension), mode=os.RTLD_NOW | os.RTLD_GLOBAL)
    library = _file_of(loaded.PL_initialise)
    return Linked(extension, library, version(loaded.PL_version_info(1)), _home(library))


def prepare() -> None:
    """Sets SWI_HOME_DIR, unless the user has, to the home that fits; to be called before `import janus_swi`.

    Whatever hinders is left for that import to report. Child processes inherit the variable.
    """
    if not os.environ.get("SWI_HOME_DIR"):
        with suppress(ImportError, OSError):
            if home := linked().home:
                os.environ["SWI_HOME_DIR"] = str(home)


def version(number: int) -> tuple[int, int, int]:
    """The parts of a version as SWI-Prolog numbers them: 90209 is 9.2.9."""
    return number // 10000, number // 100 % 100, number % 100


def _extension() -> Path:
    spec = find_spec("janus_swi")
    for folder in (spec and spec.submodule_search_locations) or ():
        for suffix in EXTENSION_SUFFIXES:
            if (file := Path(folder, "_swipl" + suffix)).is_file():
                return file
    raise ModuleNotFoundError("janus-swi is not installed in this Python", name="janus_swi")


def _file_of(function: ctypes._CFuncPtr) -> Path:  # type: ignore[name-defined]
    symbol = _Symbol()
    ctypes.CDLL(None).dladdr(ctypes.cast(function, ctypes.c_void_p), ctypes.byref(symbol))
    return Path(os.fsdecode(symbol.file)).resolve()


def _home(library: Path) -> Path | None:
    for above in library.parents:
        for folder in _FOLDERS:
            if (home := above / folder / "boot.prc").is_file():
                return home.parent
    return None
