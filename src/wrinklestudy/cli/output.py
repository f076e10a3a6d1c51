"""Results as text."""

from typing import Any

_COLUMNS = (
    "strain",
    "status",
    "amplitude_over_thickness",
    "wavelength_over_width",
    "phi_squared",
    "nominal_stress_pa",
    "newton_iterations",
)


def print_text(result: Any) -> None:
    """Print a list of states as a table, anything else as one line per value."""
    if isinstance(result, list):
        print("  ".join(f"{name:>24}" for name in _COLUMNS))
        for row in result:
            print("  ".join(f"{_text(row[name]):>24}" for name in _COLUMNS))
        return
    for key, value in result.items():
        if key == "critical_thickness":
            for strain, tau in value:
                print(f"critical_thickness at strain {strain:.5f}: {tau:.6g}")
        else:
            print(f"{key}: {_text(value)}")


def _text(value: Any) -> str:
    if value is None or value != value:
        return "-"
    return f"{value:.6g}" if isinstance(value, float) else str(value)
