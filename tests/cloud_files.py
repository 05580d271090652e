"""Writers of cloud files, independent of the readers that they test."""

import struct

import numpy as np


def write(path, data):
    path.write_bytes(data)
    return path


def text_bytes(points, separator=" ", header=None):
    lines = [separator.join(repr(float(v)) for v in row) for row in points]
    return ("\n".join(([header] if header else []) + lines) + "\n").encode()


def ply_bytes(points, form, kind="float", extra=False, faces=False):
    head = f"ply\nformat {form} 1.0\nobj_info by a test\ncomment c\nelement vertex {len(points)}\n"
    if extra:
        head += "property uchar red\n"
    head += "".join(f"property {kind} {axis}\n" for axis in "xyz")
    if extra:
        head += "property double nx\n"
    if faces:
        head += "element face 2\nproperty list uchar int vertex_indices\n"
    head += "end_header\n"
    if form == "ascii":
        rows = [" ".join((["255"] if extra else []) + [repr(float(v)) for v in row] + (["0.5"] if extra else []))
                for row in points]
        rows += ["3 0 1 2", "3 2 1 0"] if faces else []
        return (head + "\n".join(rows) + "\n").encode()
    order = "<" if "little" in form else ">"
    number = order + ("f4" if kind == "float" else "f8")
    fields = [(axis, number) for axis in "xyz"]
    if extra:
        fields = [("red", "u1"), *fields, ("nx", order + "f8")]
    table = np.zeros(len(points), fields)
    for index, axis in enumerate("xyz"):
        table[axis] = points[:, index]
    tail = (b"\x03" + struct.pack(order + "3i", 0, 1, 2)) * 2 if faces else b""
    return head.encode() + table.tobytes() + tail


def lzf_literals(data):
    """LZF without any compression: literal runs only."""
    out = bytearray()
    for start in range(0, len(data), 32):
        run = data[start:start + 32]
        out += bytes([len(run) - 1]) + run
    return bytes(out)


def pcd_bytes(points, form, extra=False):
    fields = [("x", "F", 4, 1), ("y", "F", 4, 1), ("z", "F", 4, 1)]
    if extra:
        fields = [("rgb", "U", 4, 1), fields[0], ("_", "U", 1, 3), *fields[1:], ("_", "I", 2, 1)]
    names, kinds, sizes, counts = zip(*fields, strict=True)
    head = ("# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS " + " ".join(names)
            + "\nSIZE " + " ".join(map(str, sizes)) + "\nTYPE " + " ".join(kinds) + "\nCOUNT "
            + " ".join(map(str, counts)) + f"\nWIDTH {len(points)}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\n"
            f"POINTS {len(points)}\nDATA {form}\n").encode()
    if form == "ascii":
        return head + text_bytes(points)
    dtype = np.dtype([(f"f{i}", f"<{kind.lower()}{size}", (count,))
                      for i, (_, kind, size, count) in enumerate(fields)])
    table = np.zeros(len(points), dtype)
    for index, axis in enumerate("xyz"):
        table[f"f{names.index(axis)}"] = points[:, index:index + 1]
    if form == "binary":
        return head + table.tobytes()
    body = b"".join(np.ascontiguousarray(table[field]).tobytes() for field in dtype.names)
    packed = lzf_literals(body)
    return head + struct.pack("<II", len(packed), len(body)) + packed


def stl_binary_bytes(triangles):
    body = b"".join(struct.pack("<12fH", 0, 0, 1, *np.ravel(t), 0) for t in triangles)
    return b"solid but binary".ljust(80, b" ") + struct.pack("<I", len(triangles)) + body


def stl_ascii_bytes(triangles):
    facets = [" facet normal 0 0 1\n  outer loop\n"
              + "".join("   vertex " + " ".join(repr(float(v)) for v in corner) + "\n" for corner in t)
              + "  endloop\n endfacet\n" for t in triangles]
    return ("solid a\n" + "".join(facets) + "endsolid a\n").encode()
