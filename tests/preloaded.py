"""What the kernels of notebooks' tests have at birth: large packages, the compiled runtime."""

# ruff: noqa: F401

import anywidget
import ipykernel.kernelapp
import matplotlib.pyplot
import nbformat
import numba
import pandas
import plotly.graph_objects
import pyvista
import scipy.stats
import sklearn.ensemble
import sklearn.manifold
import torch._dynamo

import toolkit as tk
from tests import compiled_runtime
from toolkit.view.render.opengl import opengl_works

opengl_works()  # remembers it
compiled_runtime.fit()
fast = compiled_runtime.read()
state = tk.runtime.start(fast, tk.pretrained().bank.vectors[0])
tk.runtime.pose(fast, tk.runtime.step(fast, state, tk.runtime.Command()))
