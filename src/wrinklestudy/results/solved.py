"""What a sheet was found to be at one strain, for use from Python."""

from dataclasses import dataclass
from typing import Any

from wrinklestudy.equilibrium import tension_field, wrinkled
from wrinklestudy.metrics.confinement import Confinement
from wrinklestudy.metrics.interpolant import DeformedSheet
from wrinklestudy.metrics.measure import Measures
from wrinklestudy.results.fields import state_row
from wrinklestudy.results.rows import StateRow
from wrinklestudy.results.states import unmeasured, with_measures
from wrinklestudy.results.tension import TensionRow
from wrinklestudy.vocabulary import Status


@dataclass(frozen=True)
class State:
    """What `Sheet.solve` found at one strain.

    Parameters
    ----------
    strain : float
    equilibrium : wrinkled.Equilibrium
        Position, energy, inertia and history.
    measures : Measures or None
        What is measured on the mid-line, in units of W; None where it did not converge.
    seconds : float
        Wall time of the solve.
    """

    strain: float
    equilibrium: wrinkled.Equilibrium
    measures: Measures | None
    seconds: float

    @property
    def shape(self) -> DeformedSheet:
        """The deformed sheet, z = 0 where it is flat.

        Raises
        ------
        ValueError
            If there is no equilibrium to show.
        """
        solved = self.equilibrium
        unwrinkled = solved.planar.flat
        if self.measures is None or solved.position is None or unwrinkled is None:
            raise ValueError(f"state at strain {self.strain:g}: {self.status}, has no shape")
        nodes = unwrinkled.space.nodes_from_field(solved.position)
        return DeformedSheet(unwrinkled.space.grid, nodes, solved.planar.settings.symmetry)

    @property
    def status(self) -> str:
        """'wrinkled', 'flat' or 'not-converged'."""
        return self.equilibrium.status

    def row(self) -> StateRow:
        """Return the state as a row of the tables, without what is measured beside x = 0."""
        row = state_row(self.equilibrium)
        return unmeasured(row) if self.measures is None else with_measures(row, self.measures)

    def as_dict(self) -> dict[str, Any]:
        """Return the numbers of the state as plain values, None where there is none.

        The keys are the columns of `results.rows.StateRow` that ``solve --json`` shows, then
        ``seconds``.
        """
        return self.row().shown() | {"seconds": self.seconds}


@dataclass(frozen=True)
class TensionState:
    """What `Sheet.tension_field` found at one strain.

    Parameters
    ----------
    strain : float
    field : tension_field.TensionField
        Position, energy, force and history, with the field on a coarser mesh.
    row : TensionRow
        The state as a row of the tables.
    confinement : Confinement or None
        What is measured on the field, in units of W; None where it did not converge.
    seconds : float
        Wall time.
    """

    strain: float
    field: tension_field.TensionField
    row: TensionRow
    confinement: Confinement | None
    seconds: float

    @property
    def status(self) -> Status:
        """'wrinkled', 'flat' (taut on both mid-lines) or 'not-converged'."""
        return self.row.status

    @property
    def reason(self) -> str:
        """Why it did not converge; empty if it did."""
        return self.row.reason

    @property
    def phi_squared_error(self) -> float | None:
        """Error of Phi^2 by the mesh, if known: `metrics.confinement.mesh_error`."""
        return self.row.phi_squared_error

    def as_dict(self) -> dict[str, Any]:
        """Return the numbers of the state as plain values, None where there is none.

        The keys are the columns of `results.tension.TensionRow` that ``tension-field --json``
        shows, then ``seconds``.
        """
        return self.row.shown() | {"seconds": self.seconds}
