"""Cloud files: every format gives the same points back, every lying file a sentence."""

import struct

import numpy as np
import pytest

from core.clouds import read_cloud
from core.clouds.lzf import decompress
from core.errors import InputError
from tests.cloud_files import (
    lzf_literals,
    pcd_bytes,
    ply_bytes,
    stl_ascii_bytes,
    stl_binary_bytes,
    text_bytes,
    write,
)


@pytest.fixture
def points():
    rng = np.random.default_rng(1)
    return rng.uniform(-200.0, 200.0, (257, 3)).astype(np.float32).astype(float)


WRITERS = {
    "a.ply": lambda p: ply_bytes(p, "ascii"),
    "le.ply": lambda p: ply_bytes(p, "binary_little_endian"),
    "be.ply": lambda p: ply_bytes(p, "binary_big_endian"),
    "double.ply": lambda p: ply_bytes(p, "binary_little_endian", kind="double"),
    "extra.ply": lambda p: ply_bytes(p, "binary_big_endian", extra=True),
    "extra_ascii.ply": lambda p: ply_bytes(p, "ascii", extra=True),
    "faces.ply": lambda p: ply_bytes(p, "binary_little_endian", faces=True),
    "faces_ascii.ply": lambda p: ply_bytes(p, "ascii", faces=True),
    "a.pcd": lambda p: pcd_bytes(p, "ascii"),
    "b.pcd": lambda p: pcd_bytes(p, "binary"),
    "c.pcd": lambda p: pcd_bytes(p, "binary_compressed"),
    "extra.pcd": lambda p: pcd_bytes(p, "binary", extra=True),
    "extra_c.pcd": lambda p: pcd_bytes(p, "binary_compressed", extra=True),
    "a.xyz": lambda p: text_bytes(p),
    "a.csv": lambda p: text_bytes(p, ",", header="x,y,z"),
    "named.csv": lambda p: text_bytes(np.c_[np.arange(len(p)), p], ",", header='"id","X [mm]","y_mm","Z"'),
    "semicolon.csv": lambda p: text_bytes(p, ";").replace(b".", b","),
    "tab.txt": lambda p: b"# scanner 7\r\n" + text_bytes(p, "\t").replace(b"\n", b"\r\n"),
    "count.pts": lambda p: f"{len(p)}\n".encode() + text_bytes(np.c_[p, p]),
    "bom.csv": lambda p: b"\xef\xbb\xbf" + text_bytes(p, ","),
    "ply_inside.xyz": lambda p: ply_bytes(p, "binary_little_endian"),
    "no_ending": lambda p: pcd_bytes(p, "binary"),
}


@pytest.mark.parametrize("name", WRITERS)
def test_every_format_gives_the_points_back(tmp_path, points, name):
    cloud = read_cloud(write(tmp_path / name, WRITERS[name](points)))
    np.testing.assert_allclose(cloud.points_mm, points, rtol=0, atol=1e-12)
    assert cloud.points_mm.dtype == np.float64
    assert (cloud.total, cloud.dropped) == (257, 0)


@pytest.mark.parametrize("writer", [stl_ascii_bytes, stl_binary_bytes])
def test_stl_gives_its_distinct_vertices(tmp_path, points, writer):
    triangles = points[np.array([[0, 1, 2], [2, 1, 3], [3, 4, 0]])]
    cloud = read_cloud(write(tmp_path / "a.stl", writer(triangles)))
    expected = np.unique(points[:5], axis=0)
    np.testing.assert_allclose(cloud.points_mm, expected, atol=1e-12)


@pytest.mark.parametrize("name", ["a.ply", "le.ply", "a.pcd", "b.pcd", "c.pcd", "a.xyz", "a.csv", "semicolon.csv"])
def test_no_measurement_is_dropped_and_counted(tmp_path, points, name):
    points[[3, 8]] = np.nan
    points[5] = 0.0
    points[7, 1] = np.inf
    points[9, :2] = 0.0
    cloud = read_cloud(write(tmp_path / name, WRITERS[name](points)))
    assert (cloud.total, cloud.dropped, len(cloud.points_mm)) == (257, 4, 253)
    np.testing.assert_allclose(cloud.points_mm[[3, 4]], points[[4, 6]], atol=1e-12)


def test_lzf_copies_overlap_and_reach_back():
    # "abc", then 9 bytes from 3 back, then a long copy of 264 bytes from 1 back.
    packed = bytes([2]) + b"abc" + bytes([(7 << 5), 0, 2]) + bytes([(7 << 5), 255, 0])
    assert decompress(packed, 276) == b"abc" * 4 + b"c" * 264
    assert decompress(lzf_literals(bytes(range(100))), 100) == bytes(range(100))


@pytest.mark.parametrize("packed", [b"\x05ab", b"\x20", b"\xe0\x00", b"\x20\x05", b"\x00a\x00b"])
def test_lzf_refuses_damage(packed):
    with pytest.raises(ValueError, match=r"past|before|longer|expands"):
        decompress(packed, 1)


def _ply(points, old, new, form="binary_little_endian"):
    return ply_bytes(points, form).replace(old, new, 1)


def _pcd(points, old, new, form="binary"):
    return pcd_bytes(points, form).replace(old, new, 1)


BAD = {
    "empty.ply": (lambda p: b"", "empty"),
    "short.ply": (lambda p: ply_bytes(p, "binary_little_endian")[:-100],
                  r"257 vertices of 12 bytes, the file holds 248"),
    "short_ascii.ply": (lambda p: b"\n".join(ply_bytes(p, "ascii").splitlines()[:-3]), r"257 vertices, .* holds 254"),
    "lies.ply": (lambda p: _ply(p, b"vertex 257", b"vertex 1000"), "1000 vertices"),
    "lies_less.ply": (lambda p: _ply(p, b"vertex 257", b"vertex 100"), "1884 bytes are left"),
    "lies_less_ascii.ply": (lambda p: _ply(p, b"vertex 257", b"vertex 100", "ascii"), "157 more lines"),
    "huge.ply": (lambda p: _ply(p, b"vertex 257", b"vertex 999999999999"), "999999999999 vertices"),
    "negative.ply": (lambda p: _ply(p, b"vertex 257", b"vertex -5"), "'-5'"),
    "word.ply": (lambda p: _ply(p, b"vertex 257", b"vertex many"), "'many'"),
    "no_z.ply": (lambda p: _ply(p, b"float z", b"float w"), "lack z"),
    "twice.ply": (lambda p: _ply(p, b"float z", b"float y"), "second time"),
    "type.ply": (lambda p: _ply(p, b"float z", b"quad z"), "property quad z"),
    "format.ply": (lambda p: _ply(p, b"binary_little_endian", b"binary_middle"), "binary_middle"),
    "no_format.ply": (lambda p: _ply(p, b"format binary_little_endian 1.0\n", b""), "no format line"),
    "no_end.ply": (lambda p: _ply(p, b"end_header", b"the_end"), "end_header"),
    "no_vertex.ply": (lambda p: _ply(p, b"element vertex", b"element corner"), "vertex"),
    "list.ply": (lambda p: _ply(p, b"end_header", b"property list uchar int k\nend_header"), "list property"),
    "magic.ply": (lambda p: b"x" + ply_bytes(p, "ascii"), "must begin"),
    "words.ply": (lambda p: _ply(p, b"obj_info", b"hello"), "hello"),
    "gap.ply": (lambda p: ply_bytes(p, "ascii").replace(b"end_header\n", b"end_header\n1 2\n"),
                r"line 10 .*3 numbers|more lines"),
    "garbage.ply": (lambda p: np.random.default_rng(0).bytes(5000), "must begin"),
    "short.pcd": (lambda p: pcd_bytes(p, "binary")[:-5], "257 points, the file holds 256"),
    "long.pcd": (lambda p: pcd_bytes(p, "binary") + b"1234", "the file holds 257"),
    "ascii.pcd": (lambda p: pcd_bytes(p, "ascii") + b"1 2 3\n", "the file holds 258"),
    "count.pcd": (lambda p: _pcd(p, b"POINTS 257", b"POINTS 300"), "300 points, but WIDTH 257"),
    "fields.pcd": (lambda p: _pcd(p, b"FIELDS x y z", b"FIELDS x y w"), "once each"),
    "sizes.pcd": (lambda p: _pcd(p, b"SIZE 4 4 4", b"SIZE 4 4"), "3 fields, but 2 SIZE"),
    "type.pcd": (lambda p: _pcd(p, b"SIZE 4 4 4", b"SIZE 4 4 3"), "SIZE 3"),
    "data.pcd": (lambda p: _pcd(p, b"DATA binary", b"DATA base64"), "base64"),
    "no_data.pcd": (lambda p: pcd_bytes(p, "binary")[:120], "DATA|lacks"),
    "key.pcd": (lambda p: _pcd(p, b"VIEWPOINT", b"VIEWPORT"), "VIEWPORT"),
    "lzf.pcd": (lambda p: pcd_bytes(p, "binary_compressed")[:-9], "cut short"),
    "lzf_size.pcd": (lambda p: _pcd(p, b"257\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 257",
                                    b"999\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 999", "binary_compressed"),
                     "announces"),
    "lzf_none.pcd": (lambda p: pcd_bytes(p, "binary_compressed").split(b"compressed\n")[0] + b"compressed\n",
                     "missing"),
    "word.xyz": (lambda p: text_bytes(p) + b"1 2 three\n", r"line 258 is '1 2 three'"),
    "two.xyz": (lambda p: text_bytes(p) + b"1 2\n", "line 258"),
    "decimal.xyz": (lambda p: text_bytes(p).replace(b".", b","), "line 1 "),
    "named.csv": (lambda p: b"time,px,py,pz\n1,2,3,4\n", "line 1 names 4 columns but not x, y and z"),
    "line.xyz": (lambda p: b"# c\n" + b"1 " * 20_000, "line 2 has 40000 characters"),
    "middle.csv": (lambda p: b"# c\n\n1,2,3\n4,5,x\n7,8,9\n", "line 4 is '4,5,x'"),
    "header.csv": (lambda p: b"x,y,z\n", "no points"),
    "comment.csv": (lambda p: b"# nothing\n", "no lines"),
    "utf16.csv": (lambda p: text_bytes(p).decode().encode("utf-16"), "UTF-16"),
    "binary.xyz": (lambda p: np.random.default_rng(0).bytes(5000), "binary"),
    "announced.pts": (lambda p: b"300\n" + text_bytes(p), "says 300 points, the file holds 257"),
    "zeros.xyz": (lambda p: text_bytes(0.0 * p), "all 257 points"),
    "wild.xyz": (lambda p: text_bytes(p) + b"1 2 4e22\n", "point 258 .*4e.22"),
    "short.stl": (lambda p: stl_binary_bytes(p[:9].reshape(3, 3, 3))[:-7], "3 triangles, .* 234 .* has 227"),
    "tiny.stl": (lambda p: b"abc", "at least 84"),
    "cut.stl": (lambda p: stl_ascii_bytes(p[:9].reshape(3, 3, 3))[:-40], "cut short"),
    "word.stl": (lambda p: stl_ascii_bytes(p[:9].reshape(3, 3, 3)).replace(b"vertex", b"vertex q", 1), "line 4"),
    "no_facets.stl": (lambda p: b"solid a\nendsolid a\n", "no facets"),
    "cloud.las": (lambda p: b"LASF" + bytes(400), r"\.ply \.pcd"),
    "cloud.docx": (lambda p: text_bytes(p), "supported are"),
}


@pytest.mark.parametrize("name", BAD)
def test_a_bad_file_is_refused_with_a_sentence(tmp_path, points, name):
    make, pattern = BAD[name]
    path = write(tmp_path / name, make(points))
    with pytest.raises(InputError, match=pattern) as caught:
        read_cloud(path)
    assert str(caught.value).startswith(str(path))
    assert "\n" not in str(caught.value)


def test_missing_file_folder_and_odd_names(tmp_path):
    with pytest.raises(InputError, match="No such file"):
        read_cloud(tmp_path / "none.ply")
    with pytest.raises(InputError, match="folder"):
        read_cloud(tmp_path)
    with pytest.raises(InputError, match="ordinary"):
        read_cloud("/dev/null")
    with pytest.raises(InputError, match="cannot be read"):
        read_cloud("a\0b.ply")
    with pytest.raises(InputError, match="cannot be read"):
        read_cloud(tmp_path / ("x" * 300 + ".ply"))


@pytest.mark.parametrize("name", [*WRITERS, "a.stl", "b.stl"])
def test_truncated_or_flipped_files_never_crash(tmp_path, points, name):
    rng = np.random.default_rng(7)
    triangles = points[:90].reshape(30, 3, 3)
    writers = {**WRITERS, "a.stl": lambda p: stl_ascii_bytes(triangles), "b.stl": lambda p: stl_binary_bytes(triangles)}
    whole = writers[name](points)
    path = tmp_path / name
    for trial in range(60):
        data = bytearray(whole)
        if trial % 3 == 0:
            data = data[:rng.integers(0, len(data))]
        else:
            # Half of the damage goes into the header, where it hurts.
            reach = min(len(data), 300) if trial % 3 == 1 else len(data)
            for _ in range(rng.integers(1, 6)):
                data[rng.integers(0, reach)] = rng.integers(0, 256)
        path.write_bytes(bytes(data))
        try:
            cloud = read_cloud(path)
        except InputError as error:
            assert str(path) in str(error)
        else:
            assert np.isfinite(cloud.points_mm).all()
            assert len(cloud.points_mm) + cloud.dropped == cloud.total


def test_a_signalling_nan_is_dropped_without_a_warning(tmp_path):
    data = bytearray(ply_bytes(np.ones((2, 3)), "binary_little_endian"))
    data[-4:] = struct.pack("<I", 0x7F800001)
    cloud = read_cloud(write(tmp_path / "a.ply", bytes(data)))
    assert cloud.dropped == 1
