"""One blended layer, Σ αₖ (x Wₖ), for many characters at once: tiles of characters by outputs, summed in registers."""

import llvmlite.binding
import numpy as np
from llvmlite import ir
from numba import njit, types
from numba.core import cgutils
from numba.extending import intrinsic

from toolkit.io.compilation import compiled

LANES = 16  # numbers in a vector; processors with shorter vectors use several
WIDE = bool(llvmlite.binding.get_host_cpu_features().get("avx512f"))
ROWS, VECTORS = (8, 2) if WIDE else (4, 1)  # of the largest tile: what fits in the registers
COLUMNS = VECTORS * LANES
CHAINS = 8  # parallel sums that keep a processor busy; short tiles split their sums to reach it
AHEAD = 4096  # distance of prefetched weights in tall tiles; short tiles are faster without prefetch
_ZERO = np.float32(0.0)


def _tile(rows: int):
    """``tile(y, y0, who, shares, first, x, x0, w, w0, n)``: y[who[r], y0 + c] += shares[r] Σᵢ x[x0, i, r] w[w0, i, c].

    The flat x and w hold, from x0 and w0, n lines of ``rows`` and of `COLUMNS` numbers; r counts from ``first`` in ``who``
    and ``shares``.

    It is written in LLVM's instructions because numba leaves the sums of such loops in memory: the same loops in Python take
    10 times as long for one character and 29 to 66 times for several, and one matrix product by torch 1.5 and 2.8 times.
    What is generated, where ``v`` counts the `VECTORS` of a line and every ``total`` is `LANES` numbers in registers::

        total[chain][r][v] = 0
        for start in range(0, n, chains):
            for chain in range(chains):                      # unrolled, as the loops inside it are
                i = start + chain
                loaded[v] = w[line i, lanes v]               # bfloat16: shifted into the upper half of a float32
                for r in range(rows):
                    total[chain][r][v] += x[line i, r] * loaded[v]      # one fused multiply-add
        for r in range(rows):
            y[who[r], y0 + lanes v] += shares[r] * sum(total[chain][r][v] for all chains)

    Chains are independent sums. An addition must wait for the previous one of its sum, and a short tile has only few sums.
    """
    chains = max(1, CHAINS // (rows * VECTORS))
    number, index, byte = ir.FloatType(), ir.IntType(32), ir.IntType(8)
    vector, indices = ir.VectorType(number, LANES), ir.VectorType(index, LANES)
    zero, unset = ir.Constant(vector, [0.0] * LANES), ir.Constant(vector, ir.Undefined)

    @intrinsic
    def tile(_typing, y, y0, who, shares, first, x, x0, w, w0, n):
        word = number if w.dtype == types.float32 else ir.IntType(16)

        def generate(context, builder, signature, arguments):
            def data(i):  # argument i, an array, as a structure of its pointer and shape
                return context.make_array(signature.args[i])(context, builder, arguments[i])

            def at(array, *offsets):  # pointer to a number that lies so far from the first
                for offset in offsets:
                    array = builder.gep(array, [offset])
                return array

            def vectors(array, *offsets, of=number):  # pointer to `LANES` numbers from there
                return builder.bitcast(at(array, *offsets), ir.VectorType(of, LANES).as_pointer())

            def widen(loaded):  # weights to float32: the bits of a bfloat16 are a float32's upper half
                if word is number:
                    return loaded
                raised = builder.shl(builder.zext(loaded, indices), ir.Constant(indices, [16] * LANES))
                return builder.bitcast(raised, vector)

            def spread(value):  # one number in all lanes
                one = builder.insert_element(unset, value, index(0))
                return builder.shuffle_vector(one, unset, ir.Constant(indices, [0] * LANES))

            target, source, weights = data(0), data(5).data, data(7).data
            _, y_start, _, _, row_start, _, x_start, _, w_start, count = arguments
            stride, whole = builder.extract_value(target.shape, 1), count.type

            def intrinsic_of(name, result, *takes):
                return cgutils.get_or_insert_function(builder.module, ir.FunctionType(result, takes), f"llvm.{name}")

            fused = intrinsic_of(f"fma.v{LANES}f32", vector, vector, vector, vector)
            prefetch = intrinsic_of("prefetch.p0", ir.VoidType(), byte.as_pointer(), index, index, index)
            # places on the stack, which LLVM turns into registers
            total = [[[cgutils.alloca_once_value(builder, zero) for _ in range(VECTORS)] for _ in range(rows)]
                     for _ in range(chains)]
            with cgutils.for_range_slice(builder, whole(0), count, whole(chains)) as (start, _):
                for chain in range(chains):
                    i = builder.add(start, whole(chain))
                    line = at(weights, w_start, builder.mul(i, whole(COLUMNS)))
                    numbers = at(source, x_start, builder.mul(i, whole(rows)))
                    loaded = [widen(builder.load(vectors(line, whole(v * LANES), of=word), align=4 if word is number else 2))
                              for v in range(VECTORS)]
                    if rows == ROWS:
                        for v in range(VECTORS):
                            ahead = builder.bitcast(at(line, whole(v * LANES + AHEAD)), byte.as_pointer())
                            builder.call(prefetch, [ahead, index(0), index(2), index(1)])
                    for r in range(rows):
                        value = spread(builder.load(at(numbers, whole(r))))
                        for v in range(VECTORS):
                            place = total[chain][r][v]
                            builder.store(builder.call(fused, [value, loaded[v], builder.load(place)]), place)
            for r in range(rows):
                row, share = (builder.load(at(data(i).data, row_start, whole(r))) for i in (2, 3))
                line, share = at(target.data, builder.mul(row, stride), y_start), spread(share)
                for v in range(VECTORS):
                    value = builder.load(total[0][r][v])
                    for chain in range(1, chains):
                        value = builder.fadd(value, builder.load(total[chain][r][v]))
                    place = vectors(line, whole(v * LANES))
                    builder.store(builder.call(fused, [share, value, builder.load(place, align=4)]), place, align=4)
            return context.get_dummy_value()

        return types.void(y, y0, who, shares, first, x, x0, w, w0, n), generate

    return tile


_tile8, _tile4, _tile2, _tile1 = (_tile(rows) for rows in (8, 4, 2, 1))


@njit(nogil=True)
def _height(left):
    """Rows of the next tile, from the number of characters that are left."""
    return ROWS if left >= ROWS else 4 if left >= 4 else 2 if left >= 2 else 1


@njit(nogil=True)
def _pack(x, rows, n, packed):
    """Inputs of some rows of x in the order of the tiles: per tile the first number of all its rows, then the second …"""
    at = 0
    while at < len(rows):
        height = _height(len(rows) - at)
        for r in range(height):
            source = x[rows[at + r]]
            for i in range(n):
                packed[at * n + i * height + r] = source[i]
        at += height


@compiled()
def blended_layer(x, gates, weight, bias, y):
    """y = Σ αₖ (x Wₖ + bₖ); a gate of zero leaves its expert out."""
    count, (experts, columns) = len(x), bias.shape
    n = weight.size // (experts * columns)
    packed, rows, shares = np.empty(count * n, np.float32), np.empty(count, np.int64), np.empty(count, np.float32)
    y[:] = _ZERO
    whole = False
    for k in range(experts):
        active = 0
        for b in range(count):
            share = gates[b, k]
            if share != _ZERO:
                rows[active], shares[active], active = b, share, active + 1
                for c in range(columns):
                    y[b, c] += share * bias[k, c]
        if not (whole and active == count):
            _pack(x, rows[:active], n, packed)
            whole = active == count
        for first in range(0, columns, COLUMNS):
            start, at = (k * columns + first) * n, 0
            while at < active:
                height = _height(active - at)
                if height == 8:
                    _tile8(y, first, rows, shares, at, packed, at * n, weight, start, n)
                elif height == 4:
                    _tile4(y, first, rows, shares, at, packed, at * n, weight, start, n)
                elif height == 2:
                    _tile2(y, first, rows, shares, at, packed, at * n, weight, start, n)
                else:
                    _tile1(y, first, rows, shares, at, packed, at * n, weight, start, n)
                at += height
