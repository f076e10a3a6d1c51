"""A config read without Snakemake is what Snakemake makes of it."""

from pathlib import Path

import pytest
import snakemake.utils
import yaml

from wrinklestudy.study.config import ConfigError
from wrinklestudy.study.config.reading import read_study

ROOT = Path(__file__).parents[3]


def test_a_config_goes_over_that_of_the_folder_as_in_snakemake(monkeypatch):
    monkeypatch.chdir(ROOT)
    merged = yaml.safe_load(Path("config.yaml").read_text())
    snakemake.utils.update_config(merged, yaml.safe_load(Path("config/quick.yaml").read_text()))
    study = read_study("config/quick.yaml")
    assert study.model_dump(mode="json", exclude_unset=True, by_alias=True) == type(
        study
    ).model_validate(merged).model_dump(mode="json", exclude_unset=True, by_alias=True)
    assert study.folders.results != read_study("config.yaml").folders.results


@pytest.mark.parametrize(
    ("text", "message"),
    [("a: [", "is not YAML"), ("mesh: 3\n", "mesh"), ("materials: {a: 1, a: 2}\n", "stands twice")],
)
def test_a_wrong_config_is_refused_and_named(tmp_path, monkeypatch, text, message):
    monkeypatch.chdir(tmp_path)
    Path("own.yaml").write_text(text)
    with pytest.raises(ConfigError, match=message) as error:
        read_study("own.yaml")
    assert "own.yaml" in str(error.value)


def test_a_missing_config_is_refused_and_named():
    with pytest.raises(ConfigError, match="none\\.yaml: cannot be read"):
        read_study("none.yaml")
