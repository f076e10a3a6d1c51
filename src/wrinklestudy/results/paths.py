"""The paths of all files of a study: the only place that makes them."""

from dataclasses import dataclass

from wrinklestudy.results.cases import Case, StudySheet, format_value

_SHEET = "{material}/aspect{aspect}_thickness{thickness}"


# Path of each output without its root folder, and its suffix. A stage with several outputs has
# its logs and run times under the name of the first.
_OUTPUTS = {
    "material": ("material/{material}", ".json"),
    "mesh": ("mesh/aspect{aspect}_resolves{resolved}", ".vtu"),
    "planar": ("planar/{material}/aspect{aspect}_resolves{resolved}/strain{strain}", ".h5"),
    "stability": (f"stability/{_SHEET}", ".json"),
    "wrinkle": (f"wrinkle/{_SHEET}/strain{{strain}}", ".h5"),
    "metrics": (f"metrics/{_SHEET}", ".csv"),
    "summary": ("summary/states", ".csv"),
    "summary_stability": ("summary/stability", ".csv"),
    "summary_peaks": ("summary/peaks", ".csv"),
    "figures": ("figures/{figure}", ""),
    "claims": ("claims/claims", ".csv"),
    "claims_page": ("claims/claims", ".html"),
    "claims_table": ("claims/{table}", ".csv"),
    "gate": ("gate/gate", ".json"),
}


@dataclass(frozen=True)
class Paths:
    """Where the files of a study lie.

    Parameters
    ----------
    results : str
        Folder of the results.
    figures : str
        Folder of the figures.
    """

    results: str = "results"
    figures: str = "figures"

    def pattern(self, output: str) -> str:
        """Return the path of an output with wildcards such as ``{strain}``."""
        return f"{self.results}/{''.join(_OUTPUTS[output])}"

    def figure(self, suffix: str) -> str:
        """Return the path of a figure with the wildcard ``{figure}``; suffix .pdf or .png."""
        return f"{self.figures}/{{figure}}{suffix}"

    def log(self, stage: str) -> str:
        """Return the path of a stage's log files, with the wildcards of its output."""
        return f"{self.results}/log/{_OUTPUTS[stage][0]}.log"

    def benchmark(self, stage: str) -> str:
        """Return the path of a stage's run times, with the wildcards of its output."""
        return f"{self.results}/benchmark/{_OUTPUTS[stage][0]}.tsv"

    def of(self, output: str, **wildcards: str | float) -> str:
        """Return the path of one output: names as they are, numbers in the one format."""
        texts = {
            name: value if isinstance(value, str) else format_value(value)
            for name, value in wildcards.items()
        }
        return self.pattern(output).format(**texts)

    def planar(self, case: Case) -> str:
        """Return the flat state that a case starts from."""
        sheet = case.sheet
        return self.of(
            "planar",
            material=sheet.material,
            aspect=sheet.aspect,
            resolved=sheet.resolved,
            strain=case.strain,
        )

    def wrinkle(self, case: Case) -> str:
        """Return the equilibrium of a case."""
        sheet = case.sheet
        return self.of(
            "wrinkle",
            material=sheet.material,
            aspect=sheet.aspect,
            thickness=sheet.thickness,
            strain=case.strain,
        )

    def of_sheet(self, output: str, sheet: StudySheet) -> str:
        """Return the one output of a stage for a sheet: stability or metrics."""
        return self.of(
            output, material=sheet.material, aspect=sheet.aspect, thickness=sheet.thickness
        )
