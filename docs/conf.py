"""The documentation site: ``make docs``, or ``sphinx-build -W --keep-going -b html docs out/docs``.

The build needs no network.

The site shows full runs of the notebooks. A run is taken from ``out/full`` if one of the same code
is there, made by ``jupyter nbconvert --to notebook --execute --output-dir out/full
notebooks/NAME.ipynb``. The build runs the others, one after another: docs/lecturers.md says for how
many minutes each. It stores their results in ``out/notebooks``, so a build that was stopped goes on
where it was; `make clean` deletes both folders. With ``TOOLKIT_DOCS_NOTEBOOKS=fast`` all notebooks
run at the small sizes of the tests, for some minutes in all. With ``off`` nothing is run, and a
notebook that has no stored run is shown without results.
"""

import dataclasses
import inspect
import os
import platform
import re
import sys
from pathlib import Path

import plotly
from docutils.nodes import SkipNode
from latex2mathml.converter import convert
from myst_nb.sphinx_ import NbMetadataCollector

DOCS = Path(__file__).parent
ROOT = DOCS.parent
sys.path[:0] = [str(DOCS), str(ROOT)]

import reference  # noqa: E402
import stored  # noqa: E402

import toolkit as tk  # noqa: E402

project = "toolkit"
author = copyright = "the authors of toolkit; MIT licence"
version = release = tk.__version__

extensions = [
    "myst_nb",  # Markdown and notebooks
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",  # numpydoc sections
    "sphinx.ext.viewcode",  # links from names to source code
]
html_theme = "furo"
html_title = "toolkit"
html_static_path = ["_static", str(Path(plotly.__file__).parent / "package_data" / "plotly.min.js")]
html_css_files = ["site.css"]
html_math_renderer = "mathml"  # browsers draw it without a script; see `setup`

# --- Markdown
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 3
smartquotes = False  # quotation marks in messages and code must not change

# --- docstrings
default_role = "py:obj"  # `name` in a docstring is a link if the name exists, else code
add_module_names = False
# matplotlib adds `set` to figures
autodoc_default_options = {"exclude-members": "set", "no-value": True}
suppress_warnings = ["ref.python",  # an annotation that several classes match gets no link
                     "mystnb.unknown_mime_type"]  # plotly's JSON, beside the HTML that is shown
autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_preserve_defaults = True
napoleon_google_docstring = False
napoleon_use_rtype = False
napoleon_use_ivar = True

# --- notebooks
RUN = os.environ.get("TOOLKIT_DOCS_NOTEBOOKS", "full")
if RUN not in ("full", "fast", "off"):
    raise ValueError(f"TOOLKIT_DOCS_NOTEBOOKS is {RUN!r}; use full, fast or off")
nb_execution_mode = "off" if RUN == "off" else "cache"
nb_execution_cache_path = str(ROOT / "out" / "notebooks" / RUN)
nb_execution_timeout = 1800  # seconds a cell
nb_output_stderr = "remove"  # progress bars
# static pictures instead
nb_mime_priority_overrides = [("*", "application/vnd.jupyter.widget-view+json", None)]
nb_ipywidgets_js = {}
os.environ |= {
    "TOOLKIT_FAST": "1" if RUN == "fast" else "",
    "PYVISTA_OFF_SCREEN": "true",
    "PYVISTA_JUPYTER_BACKEND": "static",
    "PYVISTA_MULTI_SAMPLES": "0",
    "OMP_NUM_THREADS": "1",
    "PLOTLY_RENDERER": "notebook_connected",
    # no recordings: every build gives the same site
    "TOOLKIT_DATA": str(DOCS / "notebooks"),
    "PYTHONPATH": os.pathsep.join(filter(None, (
        str(ROOT), str(ROOT / "notebooks"), os.environ.get("PYTHONPATH")))),
}

#: Links as GitHub needs them, and the same links as the site needs them.
LINKS = {"](../docs/": "](../", "](docs/": "](", "](../notebooks/": "](notebooks/",
         "](../CONTRIBUTING.md": "](contributing.md", "](../CHANGELOG.md": "](changelog.md",
         "](README.md": "](index.md", "](../README.md": "](index.md"}
#: Scripts that plotly loads from other servers, and the copy of plotly that each notebook brings.
FETCHED = re.compile(
    r'<script[^>]*src="https?://[^>]*></script>'
    r'|<script type="module">import "https?://[^<]*</script>'
    r'|<script data-toolkit="plotly">.*?</script>',
    re.DOTALL,
)
# megabytes of widget state, useless without a kernel
STATE = "application/vnd.jupyter.widget-state+json"
#: The picture of a controller without a kernel; the page that runs without Python replaces it.
CONTROLLER = re.compile(r'<div class="tk-still"><img[^>]*alt="Controller">.*?</div>', re.DOTALL)
#: The same of a Director; the page is beside it in the notebook.
DESK = re.compile(CONTROLLER.pattern.replace("Controller", "Director"), re.DOTALL)
#: The text of a progress bar that was a widget.
BAR = re.compile(r"<pre><span></span>[\w ]+: +0%\|[^\n]*\n</pre>")


#: A link from source code to its documentation. Sphinx names the package for modules that a package
#: re-exports in part.
DOCUMENTED = re.compile(r'(?<=/api/)([\w.]+)\.html#([\w.]+)')

#: A field of a dataclass: comment lines above it, its name, and the comment beside it.
FIELD = re.compile(r"^((?:    # .*\n)*)    (\w+): [^#\n]*(?:  # (.+))?$", re.MULTILINE)

#: A note below the title of each notebook.
NOTE = """</h1><div class="admonition note"><p class="admonition-title">{title}</p>
<p>{text} <code>make lab</code> starts JupyterLab for a run of your own.</p></div>"""
SMALL = (
    "The small run",
    "The results on this page come from the small run of the tests. Its networks are trained for a "
    "very short time.",
)


def note(seconds: float | None) -> str:
    """Say how a notebook was run, and for how long."""
    if seconds is None:
        return "</h1>"
    machine = f"{platform.system()}, {platform.machine()}"
    full = (
        "The full run",
        "The results on this page come from the full run. It took "
        f"{max(1, round(seconds / 60))} min on one core ({machine}).",
    )
    title, text = SMALL if RUN == "fast" else full
    return NOTE.format(title=title, text=text)


def lead_links(*event) -> None:
    """Replace `LINKS` in a page, or in a file that it includes."""
    source = event[-1]
    for there, here in LINKS.items():
        source[0] = source[0].replace(there, here)


def documented(link: re.Match) -> str:
    """A link of `DOCUMENTED` whose anchor begins with the module of its page."""
    module, name = link.groups()
    above = module
    while not name.startswith(f"{above}."):
        above = above.rpartition(".")[0]
    return f"{module}.html#{module}{name.removeprefix(above)}"


def stand_alone(app, name: str, _template: str, context: dict, _doctree) -> None:
    """Load plotly from the site, not from other servers; add the note about a notebook's run."""
    scripts = context.get("script_files", [])
    scripts[:] = [
        script for script in scripts if getattr(script, "attributes", {}).get("type") != STATE
    ]
    if "body" in context:
        page = context["pathto"]("_static/controller.html", 1)
        character = f'<iframe class="character" src="{page}"></iframe>'
        without = DESK.sub("", BAR.sub("", FETCHED.sub("", context["body"])))
        context["body"] = CONTROLLER.sub(character, without)
        # a number and its spread stay in one line
        context["body"] = context["body"].replace(" ± ", "\u00a0±\u00a0")
        if name.startswith("_modules/"):
            context["body"] = DOCUMENTED.sub(documented, context["body"])
        if name.startswith("notebooks/"):
            run = NbMetadataCollector.get_exec_data(app.env, name) or {}
            seconds = run.get("runtime", took.get(f"{Path(name).name}.ipynb"))
            context["body"] = context["body"].replace("</h1>", note(seconds), 1)
        if "plotly-graph-div" in context["body"]:
            own = context["pathto"]("_static/plotly.min.js", 1)
            context["body"] = f'<script src="{own}"></script>' + context["body"]


def steerable(app) -> None:
    """Write the pages with the embedded model that `index.md` and `shots.md` show."""
    if app.builder.format == "html":
        folder = Path(app.outdir) / "_static"
        folder.mkdir(parents=True, exist_ok=True)
        tk.view.web(
            *tk.pretrained(),
            folder / "controller.html",
            title="A character under control",
            half=True,
        )
        scene = tk.shots.Scene.load(ROOT / "examples" / "shots" / "figure_eight.json")
        tk.view.director.web(*tk.pretrained(), folder / "director.html", scene, half=True)


def whole_signature(
    _app, _what, _name, _value, _options, signature: str | None, returns: str | None
):
    """Show a default that a factory makes as ``...``."""
    return signature and signature.replace("<factory>", "..."), returns


def fields(_app, what: str, _name: str, value, _options, lines: list[str]) -> None:
    """Describe the fields of a dataclass by their comments, if its docstring does not."""
    if what == "class" and dataclasses.is_dataclass(value) and "Parameters" not in lines:
        described = []
        for above, name, beside in FIELD.findall(inspect.getsource(value)):
            comment = beside or " ".join(above.replace("# ", "").split())
            described += [name, f"    {comment}"] if comment else []
        lines += ["", "Parameters", "----------", *described, ""] if described else []


def formula(display: str):
    """Return a visitor that writes a formula as MathML."""

    def visit(self, node):
        text = convert(node.astext().strip(), display=display)
        self.body.append(f'<div class="formula">{text}</div>' if display == "block" else text)
        raise SkipNode

    return visit


def with_source(app, env) -> None:
    """Leave modules whose source is not Python out of the list of sources: they have no page."""
    env._viewcode_modules = {name: found for name, found in env._viewcode_modules.items() if found}


def setup(app) -> None:
    """Connect the functions above; Sphinx calls this."""
    app.add_html_math_renderer("mathml", (formula("inline"), None), (formula("block"), None))
    app.connect("autodoc-process-signature", whole_signature)
    # before napoleon reads the sections
    app.connect("autodoc-process-docstring", fields, priority=100)
    app.connect("builder-inited", steerable)
    app.connect("source-read", lead_links)
    app.connect("include-read", lead_links)
    app.connect("html-page-context", stand_alone)
    app.connect("env-check-consistency", with_source)


runs = ROOT / "out" / ("fast" if RUN == "fast" else "full")
texts, took = stored.results(runs, sorted((ROOT / "notebooks").glob("*.ipynb")))
reference.put(DOCS / "notebooks", texts)
nb_execution_excludepatterns = [f"notebooks/{name}" for name in took]
# notebooks/ of the checkout is beside docs/, that of the site within
results = sorted((DOCS / "results").glob("*.json"))
result_texts = {path.name: path.read_text(encoding="utf-8") for path in results}
reference.put(DOCS / "docs" / "results", result_texts)
reference.put(DOCS / "api", reference.pages())
