"""Speed and equality of the compiled model, compared with the limit of the machine and plain
PyTorch.
"""

import copy
import time
import timeit
from collections.abc import Callable
from typing import Annotated

import numpy as np
import torch
import typer
from torch import Tensor

from experiments.tables import Result, Store
from toolkit import published, runtime
from toolkit.cli import verbs
from toolkit.extra.compiled import network
from toolkit.extra.engines import onnx
from toolkit.motion import Clip
from toolkit.networks import Model
from toolkit.runtime.life import alive

PEERS = (1, 64)  # numbers of characters for the comparison
STYLES = 20  # that are compared
ROUNDS = 10  # of ten calls each, of which the median counts
FRAMES = (60, 300, 600)  # at which rollouts are compared
#: Parts of the rollouts that are compared: m/s, seconds, direction (x, z).
WAYS = (0.8, 3.0, (0.0, 1.0)), (1.6, 3.0, (1.0, 0.0)), (0.8, 4.0, (1.0, 1.0))
#: Columns of the stored table of speed: one core and `PEERS`.
SPEED = {"work": ["on one core"], "1": ["1 character, µs", 0], "1 floors": ["× floor", 1],
         "64": ["64 characters, µs each", 1], "64 floors": ["× floor", 1],
         "error": ["error, thousandths of the deviation", 3, 1000]}
#: Columns of the stored comparison: largest distances of a joint at a frame.
EQUALITY = {"compared": ["runtimes compared"],
            **{str(f): [f"frame {f}, mm", 3, 1000] for f in FRAMES}}


def run(
    model: verbs.TrainedRun = None,
    parameters: verbs.Published = None,
    equality: Annotated[bool, typer.Option(
        "--equality", help="Compare rollouts with the plain model instead.")] = False,
    store: Store = False,
) -> None:
    """Times of the network and of a whole frame, compared with the machine's limit, plain PyTorch
    and ONNX Runtime.

    A whole frame has features, network, trajectory, foot and arm IK.
    """
    net, bank = published.either(model, parameters)
    before = torch.get_num_threads()
    torch.set_num_threads(1)
    fast = runtime.compile(net)
    try:
        if equality:
            kind = "published" if parameters else "embedded" if model is None else "trained"
            rows = [{"compared": f"{kind}: {name}", **row}
                    for name, row in _equal(net, fast, bank).items()]
            made = Result("runtime-equality",
                          "Rollouts of 20 styles with 600 frames, with turns and changes of "
                          "speed: largest "
                          "distance of any joint in any style",
                          "python -m experiments runtime --equality [--published "
                          "DATA/lpn_film_100style] --store", EQUALITY, rows)
        else:
            rate, speed = _machine(fast)
            rows = _beside(net, fast, bank, rate, speed)
            command = (
                f"python -m experiments "
                f"runtime{' --published DATA/lpn_film_100style' * bool(parameters)} --store"
            )
            machine = {"G multiply-adds/s": rate / 1e9, "GB/s": speed / 1e9,
                       "MB of weights": _size(fast.weights) / 1e6}
            made = Result("runtime-speed",
                          "Processor time of the network and of a whole frame, medians, one thread",
                          command,
                          SPEED, rows, machine)
        made.show(store and not equality)
        if store and equality:
            made.add()
    finally:
        torch.set_num_threads(before)


def _floor(model: Model, count: int, rate: float, speed: float) -> float:
    """Least seconds: the longer of reading all weights once and of the multiply-adds, on one
    core.
    """
    weights = sum(layer.weight.numel() for layer in (*model.experts.layers, *model.gating.layers))
    return max(4 * weights / speed, count * weights / rate)


def _size(weights: network.Weights) -> int:
    """Number of bytes that a step of one character reads."""
    arrays = [array for part in weights.gating for array in part]
    return sum(array.nbytes for array in (*arrays, *weights.experts, weights.mean))


def _times(works: dict[str, Callable[[], object]]) -> dict[str, float]:
    """Median seconds of each, in rounds of ten calls, of which the first two are not measured.

    The CPU time of the thread is not affected by other load on the machine.
    """
    taken: dict[str, list[float]] = {name: [] for name in works}
    for _ in range(ROUNDS):
        for name, work in works.items():
            taken[name] += timeit.repeat(work, timer=time.thread_time, number=1, repeat=10)[2:]
    return {name: float(np.median(values)) for name, values in taken.items()}


def _machine(fast) -> tuple[float, float]:
    """Multiply-adds per second of one core in a large product, and bytes per second that it reads
    from memory, with as many numbers as this model has weights.
    """
    from numba import njit

    @njit(fastmath=True)
    def total(numbers):
        result = np.float32(0)
        for i in range(len(numbers)):
            result += numbers[i]
        return result

    weights, square = np.ones(_size(fast.weights) // 4, np.float32), torch.rand(1024, 1024)
    done = _times({"sum": lambda: total(weights), "product": lambda: square @ square})
    rate, speed = 1024**3 / done["product"], weights.nbytes / done["sum"]
    print(f"one core: {rate / 1e9:.1f} G multiply-adds/s, {speed / 1e9:.1f} GB/s from "
          f"{weights.nbytes / 1e6:.1f} MB")
    return rate, speed


def _beside(net: Model, fast, bank, rate: float, speed: float) -> list[dict]:
    """Network and frame of one character and of many, on one core, beside the floor and others:
    rows of `SPEED`.
    """
    table: dict[str, dict] = {}
    for count in PEERS:
        x, phases, style = _inputs(net, bank, count)
        floor = _floor(net, count, rate, speed)
        works = {
            "plain einsum weight blend (torch)": lambda x=x, p=phases, s=style: _einsum(net, x, p,
                                                                                        s),
            "torch, inputs scaled by gates": lambda x=x, p=phases, s=style: net.predict(x, p, s),
            "ONNX Runtime": _onnx(net, x, phases, style),
            "toolkit": _compiled(fast, x, phases, style),
        }
        with torch.no_grad():
            right = net.predict(x, phases, style)
            for name, work in works.items():
                error = float(((work() - right) / net.outputs_std).square().mean().sqrt())
                table.setdefault(name, {"work": name})["error"] = error
            frames = {f"whole frame, {name}": _frame(form, bank, count, life)
                      for name, form, life in (("plain", net, 0.0), ("toolkit", fast, 0.0),
                                               ("toolkit, with life", fast, 0.2))}
            taken = {"floor": floor} | _times(works) | _times(frames)
        for name, seconds in taken.items():
            row = table.setdefault(name, {"work": name})
            row |= {str(count): 1e6 * seconds / count, f"{count} floors": seconds / floor}
    return list(table.values())


def _inputs(net: Model, bank, count: int) -> tuple[Tensor, Tensor, Tensor]:
    """Inputs, phases and styles, different for every character."""
    seeded = torch.Generator().manual_seed(0)
    kinds = map(net.normaliser, ("inputs", "phases"))
    x, phases = (n.invert(torch.randn(count, len(n.mean), generator=seeded)) for n in kinds)
    return x, phases, bank.vectors[torch.arange(count) % len(bank)]


def _einsum(net: Model, x: Tensor, phases: Tensor, style: Tensor) -> Tensor:
    """The network as in the paper: the weights are blended for every character."""
    h, gates = net.normaliser("inputs").apply(x), net.gating(net.normaliser("phases").apply(phases))
    for i, layer in enumerate(net.experts.layers):
        blended = torch.einsum("bk,kij->bij", gates, layer.weight)
        h = torch.einsum("bi,bij->bj", h, blended) + gates @ layer.bias
        h = net.modulation(i, h, style) if i < 2 else h
    return net.normaliser("outputs").invert(h)


def _compiled(fast, x: Tensor, phases: Tensor, style: Tensor) -> Callable[[], Tensor]:
    """The network of a compiled model."""
    given = x.numpy(), phases.numpy(), style.numpy()
    z = torch.empty(len(x), fast.layout.n_outputs)

    def work() -> Tensor:
        network.predict(*given, fast.weights, z.numpy())
        return z

    return work


def _onnx(net: Model, x: Tensor, phases: Tensor, style: Tensor) -> Callable[[], Tensor]:
    """The plain model in ONNX Runtime."""
    import onnxruntime

    given = {"x": x.numpy(), "phases": phases.numpy(), "style": style.numpy()}
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = 1
    graph = onnx.graph(net).SerializeToString()
    session = onnxruntime.InferenceSession(graph, options, providers=["CPUExecutionProvider"])
    return lambda: torch.from_numpy(session.run(None, given)[0])


def _frame(model, bank, count: int, life: float) -> Callable[[], object]:
    """A function that computes the next frame and pose of all characters, one second after their
    start, with styles that wander by ``life``.
    """
    vectors = bank.vectors[torch.arange(count) % len(bank)]
    state, style, number = runtime.start(model, vectors), alive(vectors, life), 0
    command = runtime.straight(1.2, 0.1)[0]

    def frame() -> object:
        nonlocal state, number
        if callable(style):
            state, number = state.with_style(style(number)), number + 1
        state = runtime.step(model, state, command)
        return runtime.pose(model, state)

    for _ in range(runtime.FPS):
        frame()
    return frame


def _equal(net: Model, fast, bank) -> dict[str, dict[str, float]]:
    """Rollouts of 600 frames of the compiled and the plain model, compared with each other and with
    double precision: `farthest` of each pair.
    """
    commands = [command for way in WAYS for command in runtime.straight(*way)]
    forms = {"plain": net, "compiled": fast, "double precision": copy.deepcopy(net).double()}
    clips = walks(forms, some(bank), commands)
    pairs = (("compiled", "plain"), ("compiled", "double precision"), ("plain", "double precision"))
    return {f"{a} and {b}": farthest(clips[a], clips[b]) for a, b in pairs}


def some(bank) -> Tensor:
    """Vectors of `STYLES` styles, evenly over the bank."""
    return bank.vectors[:: max(1, len(bank) // STYLES)][:STYLES]


def walks(forms: dict[str, Model], vectors: Tensor, commands) -> dict[str, list[Clip]]:
    """For each form of a model, a walk in every style."""
    found = {}
    for name, model in forms.items():
        kind = torch.float64 if name == "double precision" else torch.float32
        run = list(runtime.states(model, commands, vectors.to(kind), progress=True))
        found[name] = [runtime.record(model, run, character=i) for i in range(len(vectors))]
    return found


def farthest(clips: list[Clip], others: list[Clip]) -> dict[str, float]:
    """Largest distance of a joint, metres, in any pair of clips, at `FRAMES`."""
    apart = torch.stack([(a.global_positions - b.global_positions).norm(dim=-1).amax(-1)
                         for a, b in zip(clips, others, strict=True)]).amax(0)
    return {str(frame): float(apart[frame - 1]) for frame in FRAMES}
