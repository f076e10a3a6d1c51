"""Put a study into one file from which another machine makes the same again: a zipped RO-Crate.

    python workflow/archive.py config/quick.yaml archive/quick.zip

The archive has all files under version control, the config, the measured data, figures, tables and
the records of how each was made, and ``SHA256SUMS`` of all that the study made, states included. It
has no time but that of the last commit and no path of this machine: the same files give the same
bytes. To make the study anew, in an empty folder::

    unzip quick.zip
    rm -r results figures
    make figures        # or: snakemake --cores all --configfile config/quick.yaml
    sha256sum --check SHA256SUMS

The bytes are the same with the locked packages on the same kind of machine, the numbers in the
tables to rounding on any.
"""

import json
import subprocess
import sys
import zipfile
from pathlib import Path
from typing import Any

from wrinklestudy.files.records import file_digest
from wrinklestudy.files.storage import atomic_path
from wrinklestudy.results.paths import Paths
from wrinklestudy.stages.recording import program
from wrinklestudy.study.config import StudyConfig
from wrinklestudy.study.config.reading import read_study
from wrinklestudy.study.plan import files_on_the_way, wanted_files

_FIRST_TIME = (1980, 1, 1, 0, 0, 0)  # of a zip file
_SUMS, _CRATE = "SHA256SUMS", "ro-crate-metadata.json"
_STATES = (".h5", ".vtu")  # made anew from the rest, and large


def git(*words: str) -> list[str]:
    """Return the lines that git answers."""
    run = subprocess.run(["git", *words], capture_output=True, text=True, check=False)
    if run.returncode != 0:
        sys.exit(f"git {words[0]}: {run.stderr.strip()}; an archive is made from a git checkout")
    return run.stdout.splitlines()


def made_files(study: StudyConfig, paths: Paths) -> list[str]:
    """Return all files of a study with their records; refuse a study that lacks any."""
    files = [
        *files_on_the_way(study, paths),
        *wanted_files(study, paths),
        paths.pattern("gate"),
    ]
    files += [paths.record(file) for file in files]
    if missing := [file for file in files if not Path(file).is_file()]:
        sys.exit(f"{missing[0]}: is missing; run the study first, as make archive does")
    if outside := [file for file in files if Path(file).is_absolute() or ".." in Path(file).parts]:
        sys.exit(f"{outside[0]}: lies outside of this folder; give folders inside of it")
    return sorted(files)


def crate(study: StudyConfig, config: str, made: list[str]) -> dict[str, Any]:
    """Return the description of the archive, RO-Crate 1.1."""
    about = program()
    date = git("log", "-1", "--format=%cs")[0]
    root = {
        "@id": "./",
        "@type": "Dataset",
        "name": study.catalogue.title,
        "description": f"Made by {about['program']} from {config} on {about['machine']}: "
        + ", ".join(f"{name} {text}" for name, text in about["versions"].items()),
        "datePublished": date,
        "license": {"@id": "LICENSE"},
        "mainEntity": {"@id": "Snakefile"},
        "hasPart": [{"@id": name} for name in ("Snakefile", config, "LICENSE", _SUMS, *made)],
    }
    workflow = {
        "@id": "Snakefile",
        "@type": ["File", "SoftwareSourceCode", "ComputationalWorkflow"],
        "name": "wrinklestudy",
        "programmingLanguage": {"@id": "https://snakemake.github.io"},
    }
    language = {
        "@id": "https://snakemake.github.io",
        "@type": "ComputerLanguage",
        "name": "Snakemake",
    }
    itself = {
        "@id": _CRATE,
        "@type": "CreativeWork",
        "about": {"@id": "./"},
        "conformsTo": {"@id": "https://w3id.org/ro/crate/1.1"},
    }
    files = [{"@id": name, "@type": "File"} for name in ("LICENSE", _SUMS, config, *made)]
    context = "https://w3id.org/ro/crate/1.1/context"
    return {"@context": context, "@graph": [itself, root, workflow, language, *files]}


def archive(config: str, output: str) -> None:
    """Write the archive of a study that has been computed."""
    study = read_study(config)
    made = made_files(study, Paths(study.folders.results, study.folders.figures))
    kept = [file for file in made if not file.endswith(_STATES)]
    data = [one.data for one in study.materials.values() if one.data is not None]
    data += [path.as_posix() for path in Path("data").rglob("*") if path.is_file()]
    texts = {
        _SUMS: "".join(f"{file_digest(file)}  {file}\n" for file in made),
        _CRATE: json.dumps(crate(study, config, kept), indent=1) + "\n",
    }
    names = sorted({*git("ls-files"), config, *data, *kept} - texts.keys())
    with atomic_path(output) as path, zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as file:
        for name in [*texts, *names]:
            entry = zipfile.ZipInfo(name, _FIRST_TIME)
            entry.compress_type = zipfile.ZIP_DEFLATED
            mode = 0o644 if name in texts else Path(name).stat().st_mode & 0o755
            entry.external_attr = mode << 16
            file.writestr(entry, texts[name] if name in texts else Path(name).read_bytes())
    print(f"{output}: {len(names) + len(texts)} files, {Path(output).stat().st_size / 1e6:.1f} MB")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("usage: python workflow/archive.py CONFIG.yaml ARCHIVE.zip")
    archive(*sys.argv[1:])
