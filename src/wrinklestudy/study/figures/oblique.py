"""A sheet seen obliquely from above, its deflection drawn larger than it is, coloured and lit."""

from dataclasses import dataclass

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

from wrinklestudy.metrics.surface import SampledSurface
from wrinklestudy.study.figures import style
from wrinklestudy.typing import Array

_AZIMUTH, _ELEVATION = np.radians(-72.0), np.radians(40.0)
_CMAP = "coolwarm"  # its middle is grey, which leaves room for light and shade
_LIGHT = np.array([0.25, -0.55, 0.8]) / np.linalg.norm([0.25, -0.55, 0.8])


def projected(points: Array) -> tuple[Array, Array]:
    """Return the screen coordinates of points ``(3, ...)`` in an orthographic oblique view."""
    x, y, z = points
    sin_a, cos_a = np.sin(_AZIMUTH), np.cos(_AZIMUTH)
    sin_e, cos_e = np.sin(_ELEVATION), np.cos(_ELEVATION)
    return -sin_a * x + cos_a * y, cos_e * z - sin_e * (cos_a * x + sin_a * y)


@dataclass(frozen=True)
class ObliqueView:
    """How deflections are shown.

    Parameters
    ----------
    exaggeration : float
        By which z is drawn larger.
    limit : float
        |z| at the ends of the scale of colours, in units of W.
    """

    exaggeration: float
    limit: float

    def draw(self, axes: Axes, surface: SampledSurface) -> Array:
        """Draw a surface with its outline; return its points with the exaggerated z."""
        stretched = surface.position * np.array([1.0, 1.0, self.exaggeration])[:, None, None]
        # Rows and columns are painted in order: the far ones must come first.
        toward = (np.cos(_AZIMUTH), np.sin(_AZIMUTH))
        flip = tuple(slice(None, None, 1 if part > 0.0 else -1) for part in toward)
        points = stretched[(slice(None), *flip)]
        u, v = projected(points)
        axes.pcolormesh(u, v, self._colours(points), rasterized=True, lw=0.0, antialiased=False)
        for edge in (stretched[:, 0], stretched[:, -1], stretched[:, :, 0], stretched[:, :, -1]):
            axes.plot(*projected(edge), color=style.BLACK, lw=0.5)
        return stretched

    def scale(self, unit: float = 1.0) -> ScalarMappable:
        """Return the scale of colours of z, in parts of a unit (in units of W)."""
        return ScalarMappable(Normalize(-self.limit / unit, self.limit / unit), _CMAP)

    def _colours(self, points: Array) -> Array:
        """Return the colour of each cell, shape (m - 1, n - 1, 3): deflection times light."""
        corners = points[:, :-1, :-1], points[:, 1:, :-1], points[:, :-1, 1:], points[:, 1:, 1:]
        height = 0.25 * sum(corner[2] for corner in corners) / self.exaggeration
        colours = colormaps[_CMAP](Normalize(-self.limit, self.limit)(height))[..., :3]
        normal = np.cross(corners[3] - corners[0], corners[2] - corners[1], axis=0)
        normal *= np.sign(normal[2]) / np.linalg.norm(normal, axis=0)
        light = np.clip(np.einsum("i...,i->...", normal, _LIGHT) / _LIGHT[2], 0.0, None)
        return np.clip(colours * (0.6 + 0.4 * light)[..., None], 0.0, 1.0)
