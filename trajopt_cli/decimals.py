"""Tables of numbers as text, many at once: the bytes of '%.17g', a third of the time.

A double m 2^q has the digits of the whole number nearest to m 2^q 10^k; with 5^k and m apart that is one product of
128 bits and one shift, exact.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from trajopt_cli.geometry import Array, IndexArray

Bytes = NDArray[np.uint8]
"""(n, width): one number's text per row, spaces left over are 0."""

_DIGITS, _WIDTH = 17, 25
_LEAST, _MOST = 1e-4, 1e14  # what is written without an exponent, and fits the product
_LOW = np.uint64(0xFFFFFFFF)
_32, _64 = np.uint64(32), np.uint64(64)
_FIVES = np.array([5**k for k in range(27)], dtype=np.uint64)
_FOUR = np.frombuffer(b"".join(b"%04d" % i for i in range(10_000)), dtype=np.uint32)
"""Four digits' text, as the memory holds it."""
_ZERO, _POINT, _MINUS = b"0.-"
_ROWS = 16_384  # of a table that are text at once


def rows_of(columns: Sequence[Array], first: Bytes | None = None) -> Iterator[bytes]:
    """Lines of a table in parts: arrays (n, k) side by side, every number as '%.17g' writes it, commas between.

    first (n, width): texts of a column before them.
    """
    n = len(columns[0])
    for begin in range(0, n, _ROWS):
        part = slice(begin, begin + _ROWS)
        fields = [] if first is None else [first[part]]
        fields += [texts(column) for array in columns for column in array[part].T]
        size = len(fields[0])
        comma, end = np.full((size, 1), ord(","), np.uint8), np.full((size, 1), ord("\n"), np.uint8)
        parts = [piece for field in fields for piece in (field, comma)]
        table = np.hstack([*parts[:-1], end])
        yield table.tobytes().translate(None, b"\0")


def texts(values: Array, digits: int = _DIGITS) -> Bytes:
    """Numbers (n,) as '%.{digits}g' writes them; digits up to 17."""
    values = np.asarray(values, dtype=np.float64)
    out = np.zeros((len(values), _WIDTH), dtype=np.uint8)
    size = np.abs(values)
    plain = (size >= _LEAST) & (size < _MOST)
    at = np.flatnonzero(plain)
    if at.size == len(values):
        return _plain(values, digits)
    if at.size:
        out[at] = _plain(values[at], digits)
    nothing = values == 0
    out[nothing, 1] = _ZERO
    out[nothing & np.signbit(values), 0] = _MINUS
    for i in np.flatnonzero(~plain & ~nothing):
        text = f"{values[i]:.{digits}g}".encode()
        out[i, : len(text)] = np.frombuffer(text, dtype=np.uint8)
    return out


def read_back(values: Array, digits: int) -> Array:
    """Numbers (n,) as they are read from their texts of up to 15 digits; above 1e-5 and below 1e14, or 0."""
    number, exponent = _rounded(np.where(values == 0, 1.0, np.abs(values)), digits)
    # both are doubles without an error, so the quotient is what a reader finds
    scale = 10.0 ** np.abs(digits - 1 - exponent)
    back = np.where(exponent < digits, number / scale, number * scale)
    return np.asarray(np.where(values == 0, 0.0, np.copysign(back, values)))


def _plain(values: Array, digits: int) -> Bytes:
    """Texts of numbers (n,) that need no exponent."""
    number, exponent = _rounded(np.abs(values), digits)
    number = number * np.uint64(10 ** (_DIGITS - digits))
    fours = np.empty((len(values), 5), dtype=np.uint32)
    for i in (4, 3, 2, 1, 0):
        whole = number // np.uint64(10_000)
        fours[:, i] = _FOUR[(number - whole * np.uint64(10_000)).astype(np.intp)]
        number = whole
    d = fours.view(np.uint8)[:, 3:]
    last = _DIGITS - np.argmax(d[:, ::-1] != _ZERO, axis=1)  # what is behind the last digit but 0 is not written
    d *= np.arange(_DIGITS) < np.maximum(last, exponent + 1)[:, None]
    out = np.zeros((len(values), _WIDTH), dtype=np.uint8)
    out[values < 0, 0] = _MINUS
    found = np.flatnonzero(np.bincount(exponent + 9)) - 9
    for e in found.tolist():
        rows = np.flatnonzero(exponent == e) if len(found) > 1 else slice(None)
        if e < 0:
            begin = 2 - e
            out[rows, 1:begin] = _ZERO
            out[rows, 2] = _POINT
            out[rows, begin : begin + _DIGITS] = d[rows]
        else:
            out[rows, 1 : e + 2] = d[rows, : e + 1]
            out[rows, e + 2] = np.where(last[rows] > e + 1, _POINT, 0)
            out[rows, e + 3 : _DIGITS + 2] = d[rows, e + 1 :]
    return out


def _rounded(size: Array, digits: int) -> tuple[NDArray[np.uint64], IndexArray]:
    """Sizes (n,) as whole numbers of so many digits, and the power of ten of the first."""
    fraction, power = np.frexp(size)
    m = np.ldexp(fraction, 53).astype(np.uint64)
    q = power.astype(np.int64) - 53
    exponent = np.floor(np.log10(size)).astype(np.intp)
    number = _scaled(m, q, digits - 1 - exponent)
    # the logarithm is off by one beside a power of ten, and what is rounded up may reach the next
    for wrong, step in ((number >= 10**digits, 1), (number < 10 ** (digits - 1), -1)):
        at = np.flatnonzero(wrong)
        if at.size:
            exponent[at] += step
            number[at] = _scaled(m[at], q[at], digits - 1 - exponent[at])
    return number, exponent


def _scaled(m: NDArray[np.uint64], q: NDArray[np.int64], k: IndexArray) -> NDArray[np.uint64]:
    """The whole numbers nearest to m 2^q 10^k, to the even one of two; -64 < k + q < 0."""
    five = _FIVES[k]
    m_1, m_0, f_1, f_0 = m >> _32, m & _LOW, five >> _32, five & _LOW
    low, cross, other = m_0 * f_0, m_0 * f_1, m_1 * f_0
    middle = (low >> _32) + (cross & _LOW) + (other & _LOW)
    lower = (low & _LOW) | (middle << _32)
    upper = m_1 * f_1 + (cross >> _32) + (other >> _32) + (middle >> _32)
    shift = (-(k + q)).astype(np.uint64)
    number = (upper << (_64 - shift)) | (lower >> shift)
    rest = lower & ((np.uint64(1) << shift) - np.uint64(1))
    half = np.uint64(1) << (shift - np.uint64(1))
    up = (rest > half) | ((rest == half) & ((number & np.uint64(1)) == 1))
    return np.asarray(number + up, dtype=np.uint64)
