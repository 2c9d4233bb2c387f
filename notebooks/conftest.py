"""Environment of the notebooks' kernels in tests: no window, still pictures, one thread each, small runs."""

import os

for name, value in {
    "PYVISTA_OFF_SCREEN": "true",
    "PYVISTA_JUPYTER_BACKEND": "static",
    "PYVISTA_MULTI_SAMPLES": "0",
    "OMP_NUM_THREADS": "1",
    "TOOLKIT_FAST": "1",
}.items():
    os.environ.setdefault(name, value)
