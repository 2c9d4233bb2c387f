"""Names and shapes of the files of the authors' published parameters of LPN-FiLM, 100 styles.

They are raw little-endian float32 files (github.com/ianxmason/local-phases), from which
`toolkit.training.published` makes a model.
"""

import math
from pathlib import Path

import numpy as np

N_STYLES, TRAINED = 100, 95  # the speeds of the last five styles are not published
HIDDEN, EXPERTS, GATING = 512, 8, 32
WIDTHS = {"X": 348, "GT_X": 8, "Y": 342}  # inputs, phases and outputs
STYLE_PARTS = ("scale1", "shift1", "scale2", "shift2")


def _shapes() -> dict[str, tuple[int, ...]]:
    """Shape of the numbers in each file, by its name without ``.bin``."""
    shapes: dict[str, tuple[int, ...]] = {}
    for name, n in WIDTHS.items():
        shapes |= {f"{name}mean": (n,), f"{name}std": (n,)}
    gating = (WIDTHS["GT_X"], GATING), (GATING, GATING), (GATING, EXPERTS)
    for layer, (n_in, n_out) in enumerate(gating):
        shapes |= {f"wc{layer}_w": (n_out, n_in), f"wc{layer}_b": (n_out,)}
    experts = (WIDTHS["X"], HIDDEN), (HIDDEN, HIDDEN), (HIDDEN, WIDTHS["Y"])
    for layer, (n_in, n_out) in enumerate(experts):
        for k in range(EXPERTS):
            shapes |= {f"cp{layer}_a{k}": (n_out, n_in), f"cp{layer}_b{k}": (n_out,)}
    shapes |= {f"Style_{i:03d}_{part}": (HIDDEN,) for i in range(N_STYLES) for part in STYLE_PARTS}
    return shapes | {"Walk_Velocities": (TRAINED,)}


SHAPES = _shapes()


def read(folder: Path) -> dict[str, np.ndarray]:
    """The numbers of all files, float32, by name without ``.bin``.

    ValueError if a file is missing, has another size, or a number that is not finite.
    """
    if not folder.is_dir():
        raise ValueError(f"{folder}: no such folder; expected the published parameters "
                         "(Xmean.bin, cp0_a0.bin, …)")
    found = {}
    for name, shape in SHAPES.items():
        path, expected = folder / f"{name}.bin", f"{' × '.join(map(str, shape))} float32 numbers"
        if not path.is_file():
            raise ValueError(f"{path}: missing; expected {expected}")
        if path.stat().st_size != 4 * math.prod(shape):
            raise ValueError(f"{path}: expected {expected}, got {path.stat().st_size:,} bytes")
        values = np.fromfile(path, "<f4").astype(np.float32, copy=False)
        if not np.isfinite(values).all():
            raise ValueError(f"{path}: expected {expected} that are finite")
        found[name] = values.reshape(shape)
    return found
