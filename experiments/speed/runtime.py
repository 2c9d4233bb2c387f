"""Speed and equality of the compiled model, compared with the limit of the machine, plain PyTorch and other runtimes."""

import copy
import dataclasses
import time
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Annotated

import numpy as np
import torch
import typer
from threadpoolctl import threadpool_limits
from torch import Tensor

from experiments.tables import Result
from toolkit import export, published, runtime
from toolkit.cli import verbs
from toolkit.evaluation import metrics
from toolkit.networks import Model

ONE, MANY, MANY_FRAMES, MANY_PLAIN = 1.3, 1.25, 1.6, 21.0  # targets: time / floor, and speed-up over plain einsum
FRAME = 100.0  # microseconds per character for the whole frame of 64 characters
PEERS = (1, 64)  # numbers of characters for the comparison
SPEEDS = 0.8, 1.6  # metres per second of the rollouts that are compared
#: Columns of the stored tables of speed: one core and `PEERS`; a crowd.
SPEED = {"work": ["on one core"], "1": ["1 character, µs", 0], "1 floors": ["× floor", 1],
         "64": ["64 characters, µs each", 1], "64 floors": ["× floor", 1],
         "error": ["error, thousandths of the deviation", 3, 1000]}
CROWD = {"characters": ["characters", 0], "1": ["one thread, µs each", 0], "hertz": ["characters at 60 Hz on one thread", 0],
         "2": ["two threads, µs each", 0], "state": ["state, MB", 2]}
#: Columns of the stored comparison: largest distances of a joint at a frame.
EQUALITY = {"compared": ["runtimes compared"], **{str(f): [f"frame {f}, mm", 3, 1000] for f in (60, 300, 600)}}


def run(
    model: verbs.TrainedRun = None,
    parameters: verbs.Published = None,
    characters: Annotated[str, typer.Option(help="Comma-separated numbers of characters.")] = "1,2,4,8,16,32,64,128,256,512",
    threads: Annotated[str, typer.Option(help="Comma-separated numbers of threads.")] = "1,2",
    rounds: Annotated[int, typer.Option(min=1, help="Rounds of ten calls; medians are printed.")] = 10,
    peers: Annotated[bool, typer.Option(help="Also time ONNX Runtime and torch.compile.")] = True,
    equality: Annotated[bool, typer.Option("--equality", help="Compare rollouts with the plain model instead.")] = False,
    styles: Annotated[int, typer.Option(min=1, help="Number of styles to compare.")] = 20,
    plot: Annotated[Path | None, typer.Option(help="File for a plot of the cost per character.")] = None,
    store: Annotated[bool, typer.Option("--store", help="Write the tables into docs/results.")] = False,
) -> None:
    """Times of the network and of a whole frame, compared with the machine's limit, plain PyTorch and other runtimes.

    A whole frame has features, network, trajectory, foot and arm IK.
    """
    net, bank = published.either(model, parameters)
    before = torch.get_num_threads()
    torch.set_num_threads(1)
    fast = runtime.compile(net)
    print(fast)
    try:
        if equality:
            kind = "published" if parameters else "embedded" if model is None else "trained"
            rows = [{"compared": f"{kind}: {name}", **row} for name, row in _equal(net, fast, bank, styles).items()]
            if store:
                Result("runtime-equality", "Rollouts of 20 styles with 600 frames, with turns and changes of speed: largest "
                       "distance of any joint in any style", "python -m experiments runtime --equality [--published "
                       "DATA/lpn_film_100style] --store", EQUALITY, rows).add()
            return
        with threadpool_limits(1):  # numpy's
            rate, speed = _machine(fast, rounds)
        rows = _beside(net, fast, bank, rounds, rate, speed, peers)
        counts, costs = [int(n) for n in characters.split(",")], {}
        for t in map(int, threads.split(",")):
            costs[t], sizes = _sweep(net, bank, counts, t, rounds)
        if store:
            command = f"python -m experiments runtime{' --published DATA/lpn_film_100style' * bool(parameters)} --store"
            machine = {"G multiply-adds/s": rate / 1e9, "GB/s": speed / 1e9, "MB of weights": fast.weights.bytes / 1e6}
            Result("runtime-speed", "Processor time of the network and of a whole frame, medians, one thread", command,
                   SPEED, rows, machine).save()
            crowd = [{"characters": n, "state": size / 1e6, "hertz": 1 / 60 / costs[min(costs)][i]}
                     | {str(t): 1e6 * cost[i] for t, cost in costs.items()}
                     for i, (n, size) in enumerate(zip(counts, sizes, strict=True))]
            Result("runtime-crowd", "Whole frame of the compiled runtime: one thread in processor time, two in elapsed time",
                   command, CROWD, crowd).save()
        if plot is not None:
            _plot(plot, counts, costs, [_floor(net, n, rate, speed) / n for n in counts])
    finally:
        torch.set_num_threads(before)


def _floor(model: Model, count: int, rate: float, speed: float) -> float:
    """Least seconds: the longer of reading all weights once and of the multiply-adds, on one core."""
    weights = sum(layer.weight.numel() for layer in (*model.experts.layers, *model.gating.layers))
    return max(4 * weights / speed, count * weights / rate)


def _times(works: dict[str, Callable[[], object]], rounds: int,
           clock: Callable[[], float] = time.thread_time) -> dict[str, float]:
    """Median seconds of each, in rounds of ten calls, of which the first two are not measured.

    The CPU time of the thread is not affected by other load on the machine.
    """
    taken: dict[str, list[float]] = {name: [] for name in works}
    for _ in range(rounds):
        for name, work in works.items():
            for call in range(10):
                start = clock()
                work()
                if call > 1:
                    taken[name].append(clock() - start)
    return {name: float(np.median(values)) for name, values in taken.items()}


def _machine(fast, rounds: int) -> tuple[float, float]:
    """Multiply-adds and bytes per second of one core: the best of several kernels, with arrays of this model's sizes."""
    from numba import njit

    from toolkit.runtime.compiled import network

    @njit(fastmath=True)
    def total(numbers):
        result = np.float32(0)
        for i in range(len(numbers)):
            result += numbers[i]
        return result

    weights = np.ones(fast.weights.bytes // 4, np.float32)
    square = torch.rand(1024, 1024)
    x, y, gates = np.ones((64, 128), np.float32), np.empty((64, 512), np.float32), np.ones((64, 1), np.float32)
    near, bias = np.ones(128 * 512, np.float32), np.zeros((1, 512), np.float32)
    done = _times({
        "sum": lambda: total(weights), "torch": lambda: square @ square, "numpy": lambda: square.numpy() @ square.numpy(),
        "toolkit": lambda: network.blended_layer(x, gates, near, bias, y),
    }, rounds)
    rates = {name: 1024**3 / done[name] for name in ("torch", "numpy")} | {"toolkit": 64 * 128 * 512 / done["toolkit"]}
    best, speed = max(rates, key=rates.__getitem__), weights.nbytes / done["sum"]
    print(f"one core: {rates[best] / 1e9:.1f} G multiply-adds/s ({best}), "
          f"{speed / 1e9:.1f} GB/s from {weights.nbytes / 1e6:.1f} MB")
    return rates[best], speed


def _beside(net: Model, fast, bank, rounds: int, rate: float, speed: float, peers: bool) -> list[dict]:
    """Network and frame of one character and of many, on one core, compared with the floor and with others.

    Returns the rows of `SPEED`.
    """
    half, calibrated, table = runtime.compile(net, precision="bfloat16"), copy.deepcopy(net), {"floor": {"work": "floor"}}
    calibrated.calibrated = True
    for count in PEERS:
        x, phases, style = _inputs(net, bank, count)
        floor = _floor(net, count, rate, speed)
        print(f"\n{count} character{'s' * (count > 1)}, one core{'':20}{'µs':>9}{'µs each':>9}{'× floor':>9}{'error':>10}")
        print(f"{'floor':40}{1e6 * floor:9.0f}{1e6 * floor / count:9.1f}{1:9.2f}")
        works = {
            "plain einsum weight blend (torch)": lambda x=x, p=phases, s=style: _einsum(net, x, p, s),
            "torch, inputs scaled by gates": lambda x=x, p=phases, s=style: net.predict(x, p, s),
            **({"ONNX Runtime": _onnx(net, x, phases, style), "torch.compile": _torch_compile(net, x, phases, style)}
               if peers else {}),
            "toolkit": lambda x=x, p=phases, s=style: fast.predict(x, p, s),
            "toolkit, bfloat16 weights": lambda x=x, p=phases, s=style: half.predict(x, p, s),
        }
        for name in [name for name, work in works.items() if isinstance(work, str)]:
            print(f"{name}: {works.pop(name)}")
        with torch.no_grad():
            done, right = _times(works, rounds), net.predict(x, phases, style)
            for name, seconds in done.items():
                error = float(((works[name]() - right) / net.outputs_std).square().mean().sqrt())
                table[name] = table.get(name, {"work": name}) | {"error": error}
                print(f"{name:40}{1e6 * seconds:9.0f}{1e6 * seconds / count:9.1f}{seconds / floor:9.2f}{error:10.1e}")
            forms = {"plain": net, "toolkit": fast, "toolkit, calibrated": runtime.compile(calibrated)}
            both = {f"whole frame, {name}": _frame(form, bank, count) for name, form in forms.items()}
            frames = _times(both, rounds)
        for name, seconds in frames.items():
            print(f"{name:40}{1e6 * seconds:9.0f}{1e6 * seconds / count:9.1f}{seconds / floor:9.2f}")
        for name, seconds in (done | frames | {"floor": floor}).items():
            found = {str(count): 1e6 * seconds / count, f"{count} floors": seconds / floor}
            table[name] = table.get(name, {"work": name}) | found
        own, frame, plain = done["toolkit"], frames["whole frame, toolkit"], done["plain einsum weight blend (torch)"]
        if count == 1:
            _verdict(f"network ≤ {ONE} × floor", own <= ONE * floor)
            _verdict(f"whole frame ≤ {MANY_FRAMES} × the network's floor", frame <= MANY_FRAMES * floor)
        else:
            _verdict(f"network ≤ {MANY} × floor", own <= MANY * floor)
            _verdict(f"network {plain / own:.1f} × as fast as einsum (target {MANY_PLAIN:g})", plain >= MANY_PLAIN * own)
            _verdict(f"whole frame ≤ {FRAME:g} µs each ({1 / 60 / frame * count:.0f} characters at 60 Hz)",
                     frame <= 1e-6 * FRAME * count)
    return list(table.values())


def _verdict(what: str, met: bool) -> None:
    print(f"  {what}: {'met' if met else 'MISSED'}")


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


def _torch_compile(net: Model, x: Tensor, phases: Tensor, style: Tensor) -> Callable[[], Tensor] | str:
    """The plain model in torch.compile, or the reason why it cannot run."""
    made = torch.compile(net.predict, dynamic=False)
    try:
        with torch.no_grad():
            made(x, phases, style)
    except Exception as error:  # whatever the compilers raise
        return f"not here ({str(error).splitlines()[0][:80]}); it needs a C++ compiler"
    return lambda: made(x, phases, style)


def _onnx(net: Model, x: Tensor, phases: Tensor, style: Tensor) -> Callable[[], Tensor] | str:
    """The plain model in ONNX Runtime, or the reason why it cannot run."""
    try:
        import onnxruntime

        graph = export.onnx.graph(net)
    except ImportError:
        return 'not installed (pip install ".[export]")'
    given = dict(zip(("x", "phases", "style"), (v.numpy() for v in (x, phases, style)), strict=True))
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = 1
    session = onnxruntime.InferenceSession(graph.SerializeToString(), options, providers=["CPUExecutionProvider"])
    return lambda: torch.from_numpy(session.run(None, given)[0])


def _frame(model, bank, count: int) -> Callable[[], object]:
    """A function that computes the next frame and pose of all characters, one second after their start."""
    state = runtime.start(model, bank.vectors[torch.arange(count) % len(bank)])
    command = runtime.straight(1.2, 0.1)[0]

    def frame() -> object:
        nonlocal state
        state = runtime.step(model, state, command)
        return runtime.pose(model, state)

    for _ in range(runtime.FPS):
        frame()
    return frame


def _sweep(net: Model, bank, counts: Iterable[int], threads: int, rounds: int) -> tuple[list[float], list[int]]:
    """Print and return seconds of a whole frame per character, and bytes of the state, for each number of characters."""
    fast, costs, sizes = runtime.compile(net, threads=threads), [], []
    print(f"\nwhole frame, {threads} thread{'s' * (threads > 1)}{'':6}{'ms':>9}{'µs each':>9}{'at 60 Hz':>10}{'state':>10}")
    for count in counts:
        work = _frame(fast, bank, count)
        taken = _times({"": work}, max(2, rounds // 2), time.thread_time if threads == 1 else time.perf_counter)[""]
        costs.append(taken / count)
        state = runtime.start(fast, bank.vectors[:1].expand(count, -1))
        sizes.append(sum(getattr(state, name).nbytes for name in state.__dataclass_fields__))
        print(f"{count:6d} characters{'':11}{1e3 * taken:9.2f}{1e6 * costs[-1]:9.1f}{count / 60 / taken:10.0f}"
              f"{sizes[-1] / 1e6:7.2f} MB")
    return costs, sizes


def _equal(net: Model, fast, bank, styles: int) -> dict[str, dict[str, float]]:
    """Rollouts of 600 frames of the compiled and the plain model, compared with each other and with double precision.

    Returns the greatest distances of each pair, metres, see `EQUALITY`.
    """
    names = list(bank)[:: max(1, len(bank) // styles)][:styles]
    vectors, (slow, quick) = torch.stack([bank[name] for name in names]), SPEEDS
    ways = (slow, 3.0, (0.0, 1.0)), (quick, 3.0, (1.0, 0.0)), (slow, 4.0, (1.0, 1.0))
    commands = [command for way in ways for command in runtime.straight(*way)]
    first = runtime.start(net, vectors)
    double = dataclasses.replace(first, **{name: value.double() for name, value in vars(first).items()})
    runs = {"plain": (net, first), "compiled": (fast, first), "double precision": (copy.deepcopy(net).double(), double)}
    clips, found = {}, {}
    for name, (model, start) in runs.items():
        run = list(runtime.states(model, commands, start.style, start, progress=True))
        clips[name] = [runtime.record(model, run, character=i) for i in range(len(names))]
    for name, other in (("compiled", "plain"), ("compiled", "double precision"), ("plain", "double precision")):
        pairs = list(zip(clips[name], clips[other], strict=True))
        apart = torch.stack([(a.global_positions - b.global_positions).norm(dim=-1).amax(-1) for a, b in pairs])
        distances = ", ".join(f"{1e3 * float(apart[:, f - 1].max()):.3g} mm at {f}" for f in (1, 60, 300, 600))
        print(f"\n{name} and {other}: {len(names)} styles; largest distance of a joint {distances}")
        print(f"{'':24}{'mean':>10}{'difference':>12}{'spread over styles':>20}")
        for what, measure in MEASURES.items():
            now, was = torch.tensor([[float(measure(clip)) for clip in pair] for pair in pairs]).T
            print(f"{what:24}{was.mean():10.4f}{(now - was).mean():12.2e}{(now - was).std():20.2e}")
        if (name, other) == ("compiled", "double precision"):  # plain single precision differs more from it
            _verdict("under 1 mm at frame 60", float(apart[:, 59].max()) < 1e-3)
        found[f"{name} and {other}"] = {str(f): float(apart[:, f - 1].max()) for f in (60, 300, 600)}
    return found


MEASURES: dict[str, Callable] = {
    "speed, m/s": metrics.speed,
    "hips, m": lambda clip: clip.global_positions[:, clip.skeleton.role("hips"), 1].mean(),
    "foot speed, m/s": lambda clip: (clip.global_positions[1:] - clip.global_positions[:-1])[
        :, [clip.skeleton.role(f"{side}_toe") for side in ("left", "right")]].norm(dim=-1).mean() * clip.fps,
    "hand height, m": lambda clip: clip.global_positions[:, clip.skeleton.role("right_hand"), 1].mean(),
    "end of the path, m": lambda clip: clip.root_positions[-1].norm(),
}


def _plot(path: Path, counts: list[int], costs: dict[int, list[float]], floor: list[float]) -> None:
    from matplotlib.figure import Figure

    figure = Figure((6.4, 3.6), layout="constrained")
    axes = figure.subplots()
    for threads, cost in costs.items():
        axes.plot(counts, [1e6 * c for c in cost], "o-", label=f"whole frame, {threads} thread{'s' * (threads > 1)}")
    axes.plot(counts, [1e6 * f for f in floor], "k--", label="floor of the network, one core")
    axes.set(xscale="log", yscale="log", xlabel="characters", ylabel="µs per character and frame", xticks=counts)
    axes.set_xticks(counts, map(str, counts))
    axes.set_yticks(ticks := [50, 100, 200, 400, 800], map(str, ticks))
    axes.minorticks_off()
    axes.legend(frameon=False)
    figure.savefig(path, dpi=110)
