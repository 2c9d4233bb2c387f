"""OpenGL for pyvista: VTK's wheel brings none, and the first picture without it would end the process.

``python -m toolkit.view.opengl`` installs it where that is one command away (root on Debian or Ubuntu), or says how.
"""

import os
import shutil
import subprocess
import sys
from functools import cache

PACKAGES = ("libegl1", "libgl1-mesa-dri")
INSTALL = f"apt-get install -y --no-install-recommends {' '.join(PACKAGES)}"
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
    os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")  # do not look for an X server first


@cache
def opengl_works() -> bool:
    """Whether VTK can draw here, tried once in a child process (without the libraries it would crash this one)."""
    try:
        done = subprocess.run([sys.executable, "-c", PROBE], capture_output=True, timeout=60, check=False)
    except (OSError, subprocess.TimeoutExpired):
        return False
    return done.returncode == 0


@cache
def explain_missing_opengl() -> None:
    """Say once how pyvista gets its OpenGL."""
    print(f"pyvista finds no OpenGL here, so a slower built-in renderer draws. On Debian or Ubuntu: {INSTALL}")


def install() -> None:
    """Install OpenGL where it is missing and can be; a failure is no error, since everything works without, slower."""
    if opengl_works():
        return
    if sys.platform.startswith("linux") and os.geteuid() == 0 and shutil.which("apt-get"):
        quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, "check": False}
        subprocess.run(["apt-get", "update"], **quiet)
        subprocess.run(INSTALL.split(), env=os.environ | {"DEBIAN_FRONTEND": "noninteractive"}, **quiet)
        opengl_works.cache_clear()
    if not opengl_works():
        explain_missing_opengl()


if __name__ == "__main__":
    install()
