"""What the kernels of notebooks' tests have at birth: large packages, the runtime."""

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
import sklearn.manifold
import torch._dynamo

import toolkit as tk
from toolkit.view.render.opengl import opengl_works

opengl_works()  # remembers it
model, bank = tk.pretrained()
fast = tk.runtime.quick(model, 300)  # compiled, if the disk has it
state = tk.runtime.start(fast, bank.vectors[0])
tk.runtime.pose(fast, tk.runtime.step(fast, state, tk.runtime.Command()))
