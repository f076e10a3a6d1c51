"""One sheet for interactive use: material, L/W and t/W in, states and measures out."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cached_property
from time import perf_counter

from wrinklestudy.equilibrium import planar, stability, tension_field, wrinkled
from wrinklestudy.equilibrium.critical_shape import WrinkleMode, wrinkle_mode
from wrinklestudy.equilibrium.envelope import envelope
from wrinklestudy.equilibrium.imperfections import Bifurcation, Imperfections, bifurcation
from wrinklestudy.equilibrium.newton import Observer
from wrinklestudy.equilibrium.ranges import Stability
from wrinklestudy.equilibrium.tension_field import TensionField
from wrinklestudy.equilibrium.whole import WholeSettings
from wrinklestudy.fem.boundary import Symmetry
from wrinklestudy.fem.clamps import Clamps
from wrinklestudy.fem.grid import MeshSettings, make_grid
from wrinklestudy.fem.size import ProblemSize
from wrinklestudy.fem.space import Space
from wrinklestudy.fem.thickness import ThicknessField
from wrinklestudy.mechanics.bending import check_bending
from wrinklestudy.mechanics.laws import Material, describe
from wrinklestudy.metrics.confinement import confinement
from wrinklestudy.metrics.interpolant import DeformedSheet
from wrinklestudy.metrics.measure import measure_sheet
from wrinklestudy.metrics.profile import FoldedProfileError
from wrinklestudy.results.cases import resolved_thickness
from wrinklestudy.results.prediction import PredictionRow, prediction_row
from wrinklestudy.results.solved import State, TensionState
from wrinklestudy.results.tension import tension_row
from wrinklestudy.results.whole import solve_whole
from wrinklestudy.vocabulary import ASPECT, PARITIES, STRAIN, THICKNESS, Parity, Part


@dataclass(frozen=True)
class Sheet:
    """A clamped rectangular sheet.

    Parameters
    ----------
    aspect : float
        L/W.
    thickness : float
        t/W.
    material : Material
        From `mooney_rivlin`, `ogden` or another of the laws.
    bending : str
        The bending law, a name in `mechanics.bending.BENDING_LAWS`.
    parity : {'antisymmetric', 'symmetric'}
        Of the wrinkles across the sheet.
    mesh : MeshSettings
        Cells for the reference sheet; longer and thinner sheets get more.
    symmetry : {'quarter', 'half', 'half-width', 'whole'}
        Which part is solved: with mirrors at x = 0 and y = 0, at x = 0, at y = 0, or with none.
        Without that at y = 0 `parity` is what the pattern is like at the centre.
    clamps : Clamps
        How the clamps are shifted and turned; if at all, the symmetry must be 'whole'.
    thickness_field : ThicknessField
        How the thickness varies about its mean t.
    weight : float
        rho g W/mu of a level sheet, see `equilibrium.imperfections.self_weight`.

    Raises
    ------
    ValueError
        If a number or an option is not allowed.
    """

    aspect: float
    thickness: float
    material: Material
    bending: str = "thinning"
    parity: Parity = "antisymmetric"
    mesh: MeshSettings = field(default_factory=MeshSettings)
    symmetry: Part = "quarter"
    clamps: Clamps = field(default_factory=Clamps)
    thickness_field: ThicknessField = field(default_factory=ThicknessField)
    weight: float = 0.0

    def __post_init__(self) -> None:
        if self.aspect not in ASPECT:
            raise ValueError(f"aspect = {self.aspect:g}: must be {ASPECT}")
        if self.thickness not in THICKNESS:
            raise ValueError(f"thickness = {self.thickness:g}: must be {THICKNESS}{self._mesh()}")
        check_bending(self.material.law, self.bending)
        if self.parity not in PARITIES:
            raise ValueError(f"parity = {self.parity!r}: must be one of {', '.join(PARITIES)}")
        self.imperfections.check_part(self.symmetry, self.aspect)

    def _mesh(self) -> str:
        """Return what mesh a sheet that is too thin would need, for a message."""
        if not 1e-6 * THICKNESS.lowest < self.thickness < THICKNESS.lowest:
            return ""
        size = ProblemSize.of_sheet(self.aspect, self.thickness, self.mesh)
        return f"; it would need {size.text()}"

    @cached_property
    def imperfections(self) -> Imperfections:
        """What the sheet is like that a perfect one is not."""
        return Imperfections(self.clamps, self.thickness_field, self.weight)

    @property
    def is_plain(self) -> bool:
        """Whether the sheet is perfect, and solved as a quarter."""
        return self.symmetry == "quarter" and self.imperfections.none

    @property
    def mirrors(self) -> Symmetry:
        """Mirrors and clamps of the part that is solved."""
        return Symmetry.of_part(self.symmetry, self.parity, self.clamps)

    @cached_property
    def size(self) -> ProblemSize:
        """How many unknowns the sheet needs."""
        quarter = ProblemSize.of_sheet(self.aspect, resolved_thickness(self.thickness), self.mesh)
        return quarter.of_part(self.symmetry)

    @property
    def bifurcation(self) -> Bifurcation:
        """Whether wrinkles appear at a sharp strain, and by which symmetry."""
        return bifurcation(self.imperfections, self.aspect, self.parity)

    def check_memory(self, wrinkled: bool = True, jobs: int = 1) -> None:
        """Raise a MemoryError of one line if the memory would not hold the problem.

        Parameters
        ----------
        wrinkled : bool
            Whether wrinkled states are wanted, not flat ones alone.
        jobs : int
            How many are solved at the same time.
        """
        sheet = f"L/W = {self.aspect:g}, t/W = {self.thickness:g}"
        self.size.check_memory(sheet, wrinkled, jobs)

    @cached_property
    def space(self) -> Space:
        """The finite element space on the part that is solved, the quarter sheet by default."""
        quarter = make_grid(self.aspect, resolved_thickness(self.thickness), self.mesh)
        return Space(self.mirrors.lines(quarter), unevenness=self.thickness_field)

    @property
    def settings(self) -> planar.PlanarSettings:
        """Settings of the planar stage."""
        return planar.PlanarSettings(self.bending, self.parity)

    def solve(
        self,
        strain: float,
        settings: wrinkled.WrinkleSettings | None = None,
        observer: Observer | None = None,
    ) -> State:
        """Return the state of the sheet at a strain.

        Parameters
        ----------
        strain : float
            eps = (L' - L)/L of the clamps, within `vocabulary.STRAIN`.
        settings : wrinkled.WrinkleSettings, optional
        observer : Observer, optional
            Is told of each iteration.

        Returns
        -------
        State
            A `WholeState` with any symmetry but 'quarter', or with imperfections.

        Raises
        ------
        ValueError
            If the strain is not allowed.
        MemoryError
            If the memory would not hold the problem; one line with its size.
        """
        if strain not in STRAIN:
            raise ValueError(f"strain = {strain:g}: must be {STRAIN}")
        self.check_memory()
        start = perf_counter()
        if not self.is_plain:
            return solve_whole(
                self.space,
                self.material,
                strain,
                self.thickness,
                self._whole_settings,
                self.symmetry,
                self.imperfections,
                settings,
                observer,
            )
        unwrinkled = planar.solve(
            self.space, self.material, strain, self.settings, observer=observer
        )
        solved = wrinkled.solve(unwrinkled, self.thickness, settings, observer)
        seconds = perf_counter() - start
        measures = None
        if solved.status != "not-converged" and solved.position is not None:
            nodes = self.space.nodes_from_field(solved.position)
            shape = DeformedSheet(self.space.grid, nodes, self.settings.symmetry)
            try:
                measures = measure_sheet(shape)
            except FoldedProfileError as error:
                solved = replace(solved, status="not-converged", reason=str(error))
        return State(strain, solved, measures, seconds)

    @property
    def _whole_settings(self) -> WholeSettings:
        return WholeSettings(self.mirrors, self.bending, self.parity, self.weight)

    def _check_plain(self, what: str) -> None:
        """Refuse what is only known of a perfect sheet that is solved as a quarter."""
        if not self.is_plain:
            raise ValueError(f"{what}: only of a perfect sheet with symmetry = 'quarter'")

    def mode(self, strain: float) -> WrinkleMode:
        """Return the critical mode at a strain: with its shape the thickest sheet wrinkles first.

        The thickness of this sheet only chooses the mesh: -S phi = tau_1^2 B phi holds for any.

        Parameters
        ----------
        strain : float
            eps = (L' - L)/L of the clamps, within `vocabulary.STRAIN`.

        Returns
        -------
        WrinkleMode
            `critical_thickness` and `deflection(x, y)`, lengths in units of W.

        Raises
        ------
        ValueError
            If the strain is not allowed.
        ArithmeticError
            If there is no flat state, or no thickness wrinkles; one line.
        MemoryError
            If the memory would not hold the problem; one line with its size.
        """
        if strain not in STRAIN:
            raise ValueError(f"strain = {strain:g}: must be {STRAIN}")
        self._check_plain("mode")
        self.check_memory(wrinkled=False)
        return wrinkle_mode(self.space, self.material.law, strain, self.settings)

    def tension_field(self, strain: float, observer: Observer | None = None) -> TensionState:
        """Return the limit of no thickness at a strain: the sheet by tension field theory.

        Thickness, bending law and parity of this sheet play no role, and the mesh is one of its
        own (`equilibrium.tension_field.tension_grid`).

        Parameters
        ----------
        strain : float
            eps = (L' - L)/L of the clamps, within `vocabulary.STRAIN`.
        observer : Observer, optional
            Is told of each iteration.

        Raises
        ------
        ValueError
            If the strain is not allowed.
        MemoryError
            If the memory would not hold the problem; one line with its size.
        """
        start = perf_counter()
        field = self._field(strain, observer)
        seconds = perf_counter() - start
        row = tension_row(field, self.material, str(describe(self.material)["law"]))
        measured = confinement(field) if field.converged else None
        return TensionState(strain, field, row, measured, seconds)

    def far_from_threshold(self, strain: float, observer: Observer | None = None) -> PredictionRow:
        """Return what tension field theory predicts of this sheet, without solving it.

        The width that the wrinkles hide is that of the limit of no thickness, and their wavelength
        that of least energy under the envelope which hides it (`equilibrium.envelope`). The
        thinner the sheet the better; parity plays no role.

        Parameters
        ----------
        strain : float
            eps = (L' - L)/L of the clamps, within `vocabulary.STRAIN`.
        observer : Observer, optional
            Is told of each iteration.

        Raises
        ------
        ValueError
            If the strain is not allowed.
        MemoryError
            If the memory would not hold the problem; one line with its size.
        """
        field = self._field(strain, observer)
        wrinkles = envelope(field, self.thickness, self.bending) if field.converged else None
        return prediction_row(field, wrinkles, self.material, self.bending, self.thickness)

    def _field(self, strain: float, observer: Observer | None) -> TensionField:
        """Return the tension field on its own mesh, once strain and memory allow it."""
        self._check_plain("tension field")
        if strain not in STRAIN:
            raise ValueError(f"strain = {strain:g}: must be {STRAIN}")
        grid = tension_field.tension_grid(self.aspect, self.mesh)
        ProblemSize(*grid.cells).check_memory(f"L/W = {self.aspect:g}", wrinkled=False)
        return tension_field.solve(grid, self.material.law, strain, observer=observer)

    def stability(self, report: Callable[[float, float], None] | None = None) -> Stability:
        """Return birth and decay strain, the largest critical thickness and those between.

        All ranges of strain with wrinkles are found; see `bifurcation` for whether they are sharp.

        Parameters
        ----------
        report : callable, optional
            Called with each strain that is computed and its tau_1/W.

        Raises
        ------
        ArithmeticError
            If the critical thickness can be computed at no strain; one line.
        MemoryError
            If the memory would not hold the problem; one line with its size.
        """
        self.check_memory(wrinkled=False)
        if not self.is_plain:
            return stability.of_imperfect_sheet(
                self.space, self.material, self._whole_settings, self.thickness, report
            )
        return stability.of_sheet(self.space, self.material, self.settings, self.thickness, report)
