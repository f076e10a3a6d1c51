"""From the name of a study in the config to its catalogue, and to the modules behind it."""

import sys
import traceback
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec, module_from_spec, spec_from_file_location
from os.path import relpath
from pathlib import Path
from types import ModuleType

from wrinklestudy.study.catalogue import Catalogue
from wrinklestudy.study.digest import SOURCE, module_file

_STUDIES = "wrinklestudy.studies"


class CatalogueError(ValueError):
    """A study cannot be loaded; the message is one line."""


@dataclass(frozen=True)
class _Place:
    """Where a study is: name and file of its module, and the folder it is imported from."""

    module: str
    file: Path
    source: Path

    @property
    def folder(self) -> Path | None:
        """The folder of a package; None for a single file."""
        return self.file.parent if self.file.name == "__init__.py" else None


def built_in() -> tuple[str, ...]:
    """Return the names of the studies that come with the package."""
    folder = SOURCE.joinpath(*_STUDIES.split("."))
    return tuple(sorted(file.parent.name for file in folder.glob("*/__init__.py")))


def load_catalogue(study: str) -> Catalogue:
    """Return the catalogue of a study.

    Parameters
    ----------
    study : str
        Name of a study of this package, or path of a folder with an ``__init__.py`` or of a
        ``.py`` file, relative to the working directory.

    Raises
    ------
    CatalogueError
        If there is no such study, its file cannot be imported or does not define ``CATALOGUE``, or
        a module that the catalogue names does not exist; one line.
    """
    place = _place(study)
    catalogue = getattr(_imported(study, place), "CATALOGUE", None)
    if not isinstance(catalogue, Catalogue):
        shown = relpath(place.file)
        raise CatalogueError(
            f"study = {study!r}: {shown} must define CATALOGUE, a wrinklestudy.study.catalogue."
            "Catalogue"
        )
    named = [(f"figure {entry.name!r}", entry.module) for entry in catalogue.figures]
    named += [(f"table {entry.name!r}", entry.module) for entry in catalogue.tables]
    named += [("claims", catalogue.claims)] if catalogue.claims else []
    for what, module in named:
        if module_file(module, (place.source,)) is None:
            raise CatalogueError(
                f"study = {study!r}: {what}: there is no module {module!r} in {place.source}"
            )
    return catalogue


def sources(study: str) -> tuple[Path, ...]:
    """Return the folders with the code behind a study: of this package and of the user."""
    return tuple(dict.fromkeys((SOURCE, _place(study).source)))


def claim_modules(study: str) -> tuple[str, ...]:
    """Return the names of the modules with the claims of a study, without importing them."""
    module = load_catalogue(study).claims
    file = module_file(module, sources(study))
    if file is None:
        return ()
    if file.name != "__init__.py":
        return (module,)
    topics = sorted(path.stem for path in file.parent.glob("*.py") if path != file)
    return (module, *(f"{module}.{topic}" for topic in topics))


def _place(study: str) -> _Place:
    if study in built_in():
        file = SOURCE.joinpath(*_STUDIES.split("."), study, "__init__.py")
        return _Place(f"{_STUDIES}.{study}", file, SOURCE)
    path = Path(study).resolve()
    path = path.parent if path.name == "__init__.py" else path
    file = path / "__init__.py" if path.is_dir() else path
    if not (file.is_file() and file.suffix == ".py"):
        raise CatalogueError(
            f"study = {study!r}: must be one of {', '.join(built_in())}, or a folder with an "
            "__init__.py or a .py file"
        )
    if not path.stem.isidentifier():
        raise CatalogueError(
            f"study = {study!r}: {path.stem!r} must be a name that Python can import: letters, "
            "digits and '_'"
        )
    return _Place(path.stem, file, path.parent)


def _imported(study: str, place: _Place) -> ModuleType:
    """Import the module of a study, from its file if it is the user's."""
    try:
        if place.source == SOURCE:
            return import_module(place.module)
        known = find_spec(place.module)
        if known is not None and Path(known.origin or "").resolve() != place.file:
            raise CatalogueError(
                f"study = {study!r}: {place.module!r} is the name of another package; take another"
            )
        return sys.modules.get(place.module) or _from_file(place)
    except CatalogueError:
        raise
    except Exception as error:
        message = str(error).splitlines()[0] if str(error) else ""
        raise CatalogueError(
            f"study = {study!r}: {_where(error, place)}: {type(error).__name__}: {message}"
        ) from error


def _from_file(place: _Place) -> ModuleType:
    folders = None if place.folder is None else [str(place.folder)]
    spec = spec_from_file_location(place.module, place.file, submodule_search_locations=folders)
    assert spec is not None
    assert spec.loader is not None
    module = module_from_spec(spec)
    sys.modules[place.module] = module
    try:
        spec.loader.exec_module(module)
    except BaseException:
        del sys.modules[place.module]
        raise
    return module


def _where(error: Exception, place: _Place) -> str:
    """Return file and line of the user's code that an error comes from."""
    if isinstance(error, SyntaxError) and error.filename:
        return f"{relpath(error.filename)}, line {error.lineno}"
    own = place.folder or place.file
    frames = [
        frame
        for frame in traceback.extract_tb(error.__traceback__)
        if Path(frame.filename).is_relative_to(own)
    ]
    last = frames[-1] if frames else None
    return f"{relpath(last.filename)}, line {last.lineno}" if last else relpath(place.file)
