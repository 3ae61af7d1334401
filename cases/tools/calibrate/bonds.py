"""What is looked for, and what the ice is to have. SI units, angles in degrees."""
from __future__ import annotations

import dataclasses
from dataclasses import dataclass


@dataclass(frozen=True)
class Targets:
    """Bulk values of an ice [Pa], and its Poisson's ratio in the plate's plane [-]; None where nothing is asked for."""
    young: float
    bending: float | None
    compression: float | None
    tension: float | None
    poisson: float | None = None


@dataclass(frozen=True)
class Bonds:
    """Parameters of fix bond/parallel [Pa, -, degrees]."""
    young: float
    stiffness_ratio: float
    tensile_strength: float
    shear_strength: float
    friction_angle: float = 0.0
    weibull_modulus: float = 0.0

    def with_ratio(self, ratio: float) -> Bonds:
        """With another κ."""
        return dataclasses.replace(self, stiffness_ratio=ratio)

    def scaled(self, young: float, tensile: float, shear: float) -> Bonds:
        """With E_b, σc and τc times these factors."""
        return dataclasses.replace(self, young=self.young * young, tensile_strength=self.tensile_strength * tensile,
                                   shear_strength=self.shear_strength * shear)

    def rounded(self) -> Bonds:
        """To four digits, so that the numbers shown are those that were measured."""
        return dataclasses.replace(self, **{name: float(f"{getattr(self, name):.4g}")
                                            for name in ("young", "stiffness_ratio", "tensile_strength", "shear_strength")})

    def script(self) -> str:
        """The command of the input script."""
        words = [f"young {self.young:.4g} stiffness_ratio {self.stiffness_ratio:g}",
                 f"    tensile_strength {self.tensile_strength:.4g} shear_strength {self.shear_strength:.4g}"]
        if self.friction_angle:
            words[-1] += f" friction_angle {self.friction_angle:g}"
        if self.weibull_modulus:
            words[-1] += f" weibull {self.weibull_modulus:g} 1"
        return "fix bonds ice bond/parallel " + " &\n".join(words)


@dataclass(frozen=True)
class Sample:
    """What the specimens are made of: spheres of a diameter [m] and a density [kg/m3], so many layers."""
    diameter: float
    density: float
    layers: int
    packing: str = "hcp"  # or the file of a cell (packing/cell.py)

    def lattice(self) -> bool:
        """Whether the closed form holds."""
        return self.packing == "hcp"
