"""OpenGL for pyvista: VTK's wheel has none, and without it the first picture would crash the
process.

``python -m toolkit.view.render.opengl`` says how to install it, with exit status 1, where it is
missing.
"""

import os
import subprocess
import sys
import warnings
from functools import cache

MISSING = ("pyvista finds no OpenGL here, so pictures take longer. On Debian or Ubuntu: "
           "apt-get install -y --no-install-recommends libegl1 libgl1-mesa-dri")
PROBE = """
import vtkmodules.vtkRenderingOpenGL2
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow
window = vtkRenderWindow()
window.SetOffScreenRendering(1)
window.SetSize(16, 16)
window.AddRenderer(vtkRenderer())
window.Render()
raise SystemExit(0 if window.SupportsOpenGL() else 1)
"""

if sys.platform.startswith("linux") and not os.environ.get("DISPLAY"):
    # Do not look for an X server first.
    os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")


@cache
def opengl_works() -> bool:
    """Whether VTK can draw here, tried once in a child process, which crashes where OpenGL is
    missing.
    """
    try:
        done = subprocess.run(
            [sys.executable, "-c", PROBE], capture_output=True, timeout=60, check=False
        )
    except (OSError, subprocess.TimeoutExpired):
        return False
    return done.returncode == 0


@cache
def explain_missing_opengl() -> None:
    """Warn once how to install OpenGL for pyvista."""
    warnings.warn(MISSING, stacklevel=3)


if __name__ == "__main__":
    if not opengl_works():
        print(MISSING)
        sys.exit(1)
