"""Decoder of the LZF compression that PCD files use (format after Marc Lehmann's liblzf)."""

from __future__ import annotations


def decompress(data: bytes, size: int) -> bytes:
    """Expand an LZF block.

    A control byte below 32 announces `control + 1` literal bytes; otherwise its upper three bits give the length of a
    copy (7: one more length byte follows) and the other 13 bits the distance back.

    Args:
        data: The compressed block.
        size: Length of the result in bytes.

    Raises:
        ValueError: the block does not expand to exactly `size` bytes.
    """
    out = bytearray()
    position, end = 0, len(data)
    while position < end:
        control = data[position]
        position += 1
        if control < 32:
            out += data[position:position + control + 1]
            position += control + 1
            if position > end:
                raise ValueError("a literal run reaches past the end")
        else:
            length = control >> 5
            extra = 2 if length == 7 else 1
            if position + extra > end:
                raise ValueError("a copy reaches past the end")
            if length == 7:
                length += data[position]
            distance = ((control & 31) << 8) + data[position + extra - 1] + 1
            position += extra
            _copy_back(out, distance, length + 2)
        if len(out) > size:
            raise ValueError("the block is longer than announced")
    if len(out) != size:
        raise ValueError(f"the block expands to {len(out)} bytes")
    return bytes(out)


def _copy_back(out: bytearray, distance: int, length: int) -> None:
    start = len(out) - distance
    if start < 0:
        raise ValueError("a copy starts before the beginning")
    if distance >= length:
        out += out[start:start + length]
        return
    # The copy overlaps its own result: the last `distance` bytes repeat.
    pattern = bytes(out[start:])
    out += (pattern * (length // distance + 1))[:length]
