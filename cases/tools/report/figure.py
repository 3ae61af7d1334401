"""What all figures share: palette, units of axes, and how a figure becomes part of the page."""
from __future__ import annotations

import base64
import io
from dataclasses import dataclass

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot

# Okabe & Ito (2008): told apart with every kind of colour vision
PALETTE = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
TIME = "viridis"  # of the same kind, for what is coloured by time
PREFIXES = {"s": ((2e-4, 1e6, "µs"), (1.0, 1e3, "ms")), "m": ((1.0, 1e3, "mm"),), "N s": ((0.1, 1e3, "mN s"),)}


@dataclass(frozen=True)
class Picture:
    """An image as a data URI; the text says what is seen to those who cannot see it, the note below is for all. The shape
    is that of its place on the page: empty (a third), `wide`, `half` or `small`."""

    source: str
    text: str
    note: str = ""
    shape: str = ""


def style() -> None:
    """matplotlib's settings for the page."""
    pyplot.rcParams.update({
        "font.size": 9.5, "axes.titlesize": 10, "axes.linewidth": 0.7, "axes.grid": True, "grid.color": "#e3e6e9",
        "grid.linewidth": 0.6, "axes.axisbelow": True, "lines.linewidth": 1.4, "legend.fontsize": 8.5, "legend.frameon": False,
        "figure.constrained_layout.use": True, "svg.hashsalt": "frazil", "axes.spines.top": False, "axes.spines.right": False})


def colour(number: int) -> str:
    """Of the run of that number, the same in all figures."""
    return PALETTE[number % len(PALETTE)]


def readable(unit: str, largest: float) -> tuple[float, str]:
    """(factor, unit) for numbers of that size: seconds below one as milliseconds, and so on."""
    for limit, factor, name in PREFIXES.get(unit, ()):
        if 0 < largest < limit:
            return factor, name
    return 1.0, unit


def labelled(label: str, unit: str) -> str:
    """Text of an axis."""
    return f"{label} [{unit}]" if unit else label


def embed(figure, text: str, kind: str = "svg", **more) -> Picture:
    """The figure as part of the page: lines as SVG, areas of many points as PNG."""
    stream = io.BytesIO()
    figure.savefig(stream, format=kind, dpi=130, metadata={"Date": None} if kind == "svg" else None)
    pyplot.close(figure)
    return picture(stream.getvalue(), text, "svg+xml" if kind == "svg" else kind, **more)


def picture(data: bytes, text: str, kind: str, note: str | None = None, shape: str = "") -> Picture:
    """An image file as part of the page; where no note is given the text stands below it."""
    return Picture(f"data:image/{kind};base64,{base64.b64encode(data).decode()}", text, text if note is None else note, shape)
