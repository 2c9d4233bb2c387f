"""What the notebooks of the course share: the map, checked exercises, sentences that a run can
refute, and live figures.

Each result of the course is said by `claim` or `learnt`, which compare the sentence with the run. A
figure of `show` or `film` answers without a kernel: in JupyterLab, in the HTML of nbconvert and on
the site.
"""

import os
import pkgutil
import sys

import lazy_loader

# Plotly loads jsonschema, and jsonschema this optional package, whose grammar of addresses takes
# more than a second to compile. No notebook checks an address.
sys.modules.setdefault("rfc3987_syntax", None)
# Tests set this variable for a small run of each notebook.
FAST = bool(os.environ.get("TOOLKIT_FAST"))
__getattr__, __dir__, __all__ = lazy_loader.attach(
    __name__,
    [module.name for module in pkgutil.iter_modules(__path__)],
    {
        "checks": ["Exercise", "Verdict", "check", "claim", "exercises_of", "learnt"],
        "pages": ["SYMBOLS", "ahead", "blind", "film", "show", "steer", "switch", "symbols",
                  "two_bone"],
        "phase_pictures": ["phase_figure", "principal_axes"],
        "sequence": ["LESSONS", "Lesson", "here"]
    },
)
