#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the binary files of this folder, each a tetrahedron with one habit."""
import base64
import json
import pathlib
import struct
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
VERTICES = ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))
FACES = ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3))


def stl(title, count=len(FACES), attribute=0, behind_each=b"", behind=b""):
    triangles = b"".join(
        struct.pack("<12f", 0, 0, 0, *(x for i in face for x in VERTICES[i])) + struct.pack("<H", attribute) + behind_each
        for face in FACES)
    return title.ljust(80, b" ") + struct.pack("<I", count) + triangles + behind


def ply():
    header = ("ply\nformat binary_big_endian 1.0\ncomment The greatest byte first, and a normal behind each position.\n"
              "element vertex 4\n" + "".join(f"property float {name}\n" for name in ("x", "y", "z", "nx", "ny", "nz")) +
              "element face 4\nproperty list uchar int vertex_indices\nend_header\n")
    rows = b"".join(struct.pack(">6f", *vertex, 0, 0, 1) for vertex in VERTICES)
    return header.encode() + rows + b"".join(struct.pack(">B3i", 3, *face) for face in FACES)


def gltf(habit, uri, node, mode=4, indices=tuple(i for face in FACES for i in face)):
    positions = b"".join(struct.pack("<3f", *vertex) for vertex in VERTICES)
    buffer = positions + struct.pack(f"<{len(indices)}H", *indices)
    document = {
        "asset": {"version": "2.0", "extras": habit},
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, **node}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "mode": mode}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1]},
            {"bufferView": 1, "componentType": 5123, "count": len(indices), "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48},
                        {"buffer": 0, "byteOffset": 48, "byteLength": 2 * len(indices)}],
        "buffers": [{"byteLength": len(buffer), **({"uri": uri} if uri else {})}],
    }
    if uri == "base64":
        document["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64.b64encode(buffer).decode()
    return document, buffer


def gltf_text(*arguments, **named):
    return (json.dumps(gltf(*arguments, **named)[0], indent=1) + "\n").encode()


def glb(*arguments):
    document, buffer = gltf(*arguments)
    text, buffer = json.dumps(document).encode(), buffer
    text, buffer = text + b" " * (-len(text) % 4), buffer + b"\0" * (-len(buffer) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(buffer), b"BIN\0") + buffer
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def threemf(path, item):
    model = ('<?xml version="1.0" encoding="UTF-8"?>\n<model unit="millimeter" xml:lang="en-US"'
             ' xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">\n<resources>\n<object id="1" type="model"><mesh>\n'
             "<vertices>\n" + "".join('<vertex x="%g" y="%g" z="%g"/>\n' % vertex for vertex in VERTICES) + "</vertices>\n"
             "<triangles>\n" + "".join('<triangle v1="%d" v2="%d" v3="%d"/>\n' % face for face in FACES) + "</triangles>\n"
             f"</mesh></object>\n</resources>\n<build><item objectid=\"1\"{item}/></build>\n</model>\n")
    relationships = ('<?xml version="1.0" encoding="UTF-8"?>\n'
                     '<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">\n'
                     '<Relationship Target="/3D/3dmodel.model" Id="rel0"'
                     ' Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>\n</Relationships>\n')
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in (("_rels/.rels", relationships), ("3D/3dmodel.model", model)):
            archive.writestr(zipfile.ZipInfo(name), text, zipfile.ZIP_DEFLATED)


FILES = {
    "solid_binary.stl": stl(b"solid tetrahedron"),
    "colours.stl": stl(b"COLOR=\xff\x00\x00\xff", attribute=0x7fff),
    "attributes.stl": stl(b"bytes behind each triangle", attribute=3, behind_each=b"rgb"),
    "newline.stl": stl(b"a line end behind the last triangle", behind=b"\n"),
    "count_zero.stl": stl(b"a stream: counted before it was known", count=0),
    "big_endian.ply": ply(),
    "chunks.glb": glb("The buffer stands in the same file.", "", {}),
    "base64.gltf": gltf_text("The buffer stands in the text.", "base64", {}),
    "beside.gltf": gltf_text("The buffer stands in a file beside it.", "beside.bin", {}),
    "beside.bin": gltf("", "beside.bin", {})[1],
    "strip.gltf": gltf_text("A strip of triangles.", "base64", {}, mode=5, indices=(0, 2, 1, 3, 0, 2)),
    "scaled.gltf": gltf_text("A scale and a translation.", "base64", {"scale": [2, 2, 2], "translation": [0.5, 0, 0]}),
    "rotated.gltf": gltf_text("A quarter turn: sqrt(1/2) is no double.", "base64", {"rotation": [0.7071068, 0, 0, 0.7071068]}),
}
for name, content in FILES.items():
    (HERE / name).write_bytes(content)
threemf(HERE / "item.3mf", "")
threemf(HERE / "mirrored.3mf", ' transform="-1 0 0 0 1 0 0 0 1 0 0 0"')
