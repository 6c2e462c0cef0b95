"""Bodies from files that hold many: where each comes out, by pin's URDF reader and by closed forms."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest
import trimesh

from trajopt_cli.cell.loader import load_cell
from trajopt_cli.cell.model import Cell
from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.problem.plant import build_plant
from trajopt_cli.proximity.meshes import convex
from trajopt_cli.proximity.pair import Pair
from trajopt_cli.shapes import Box, Capsule, Mesh, MeshFile, Solid

CELL = 'robot: irb140\nstart: {joints: "[0, 0, 0, 0, 30, 0] deg"}\nobstacles:\n'
POSTS = """positioners:
  STN1: {eax: b, range: "[-90, 90] deg", velocity: 1, acceleration: 1, source: a test}
"""
TETRA = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
URDF = """<robot name="cell">
  <link name="world"/>
  <link name="table"><collision><origin xyz="0 0 0.4" rpy="0.1 0.2 0.3"/><geometry><box size="1 2 0.8"/></geometry>
    </collision><collision><geometry><cylinder radius="0.1" length="0.5"/></geometry></collision></link>
  <link name="door"><visual><origin xyz="0.1 0 0"/><geometry><mesh filename="package://parts/door.obj"
    scale="0.5 1 2"/></geometry></visual></link>
  <link name="ball"><collision><geometry><sphere radius="0.2"/></geometry></collision></link>
  <joint name="a" type="fixed"><parent link="world"/><child link="table"/><origin xyz="1 0 0" rpy="0 0 0.5"/></joint>
  <joint name="b" type="revolute"><parent link="table"/><child link="door"/><origin xyz="0 1 0.2" rpy="0.3 0 0"/>
    <axis xyz="0 0 1"/><limit lower="0" upper="1" effort="1" velocity="1"/></joint>
  <joint name="c" type="fixed"><parent link="door"/><child link="ball"/><origin xyz="0 0 1"/></joint>
</robot>"""


def cell_of(folder: Path, obstacles: str, head: str = CELL) -> Cell:
    (folder / "c.yaml").write_text(head + "".join(f"  {line}\n" for line in obstacles.splitlines()))
    return load_cell(folder / "c.yaml")


def bodies(cell: Cell) -> dict[str, Solid]:
    return {solid.name: solid for solid in build_plant(cell).obstacles}


def points(solid: Solid) -> Array:
    shape = solid.loaded
    assert isinstance(shape, Mesh)
    return np.asarray(shape.vertices @ shape.X[:3, :3].T + shape.X[:3, 3])


# ---------------------------------------------------------------------------------------------------------------- URDF


@pytest.fixture
def with_urdf(tmp_path: Path) -> Path:
    (tmp_path / "parts").mkdir()
    (tmp_path / "urdf").mkdir()
    (tmp_path / "parts/door.obj").write_text(TETRA)
    (tmp_path / "urdf/cell.urdf").write_text(URDF)
    return tmp_path


def test_links_of_a_urdf_stand_where_pin_has_them(with_urdf: Path) -> None:
    cell = cell_of(with_urdf, "hall: {urdf: {file: urdf/cell.urdf, position: [0, 0, 1]}, ignore: [link_3]}")
    found = bodies(cell)
    assert list(found) == ["hall/table", "hall/table 2", "hall/door", "hall/ball"]
    assert all(solid.ignore == {"link_3"} for solid in found.values())
    model = pin.buildModelFromXML(URDF)
    data = model.createData()
    pin.framesForwardKinematics(model, data, pin.neutral(model))
    X = {frame.name: pin.SE3(np.eye(3), np.array([0, 0, 1.0])) * data.oMf[i]
         for i, frame in enumerate(model.frames) if frame.type == pin.FrameType.BODY}  # fmt: skip
    table, ball = found["hall/table"].loaded, found["hall/ball"].loaded
    assert isinstance(table, Box)
    assert isinstance(ball, Capsule)
    origin = pin.SE3(pin.rpy.rpyToMatrix(0.1, 0.2, 0.3), np.array([0, 0, 0.4]))
    np.testing.assert_allclose(table.X, (X["table"] * origin).homogeneous, atol=1e-12)
    np.testing.assert_allclose(table.size, [1, 2, 0.8])
    np.testing.assert_allclose([ball.a, ball.b], [X["ball"].translation] * 2, atol=1e-12)
    corners = np.array([[0.1, 0, 0], [0.6, 0, 0], [0.1, 1, 0], [0.1, 0, 2]])
    wanted = corners @ X["door"].rotation.T + X["door"].translation
    np.testing.assert_allclose(np.sort(points(found["hall/door"]), axis=0), np.sort(wanted, axis=0), atol=1e-9)


def test_a_cylinder_is_a_convex_body_around_the_circle(with_urdf: Path) -> None:
    cylinder = bodies(cell_of(with_urdf, "hall: {urdf: {file: urdf/cell.urdf}}"))["hall/table 2"].loaded
    assert isinstance(cylinder, Mesh)
    assert convex(cylinder) is not None
    mesh = trimesh.Trimesh(cylinder.vertices, cylinder.triangles)
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    assert np.pi * 0.01 * 0.5 <= mesh.volume <= 1.01 * np.pi * 0.01 * 0.5
    np.testing.assert_allclose(np.ptp(cylinder.vertices[:, 2]), 0.5)


def test_what_a_urdf_leaves_open_is_told_and_its_files_are_kept(with_urdf: Path) -> None:
    cell = cell_of(with_urdf, "hall: {urdf: {file: urdf/cell.urdf}}")
    assert [str(one.text) for one in cell.doubts if "joint 'b'" in str(one.text)]
    kept = [path.relative_to(with_urdf).as_posix() for path in cell.mesh_files]
    assert kept == ["urdf/cell.urdf", "parts/door.obj"]


@pytest.mark.parametrize(
    ("old", "new", "word"),
    [
        ('size="1 2 0.8"', 'size="1 2"', "size"),
        ('size="1 2 0.8"', 'size="1 -2 1"', "size"),
        ('radius="0.2"', "", "radius"),
        ("<sphere", "<ellipsoid", "ellipsoid"),
        ('<child link="table"/>', "", "child"),
        ('<parent link="world"/>', '<parent link="door"/>', "itself"),
        ('<child link="ball"/>', '<child link="door"/>', "two joints"),
        ("package://parts/", "package://nowhere/", "nowhere"),
        ("package://parts/", "../../", "door.obj"),
        ('rpy="0 0 0.5"', 'rpy="0 0 x"', "rpy"),
        ("<robot", "<!DOCTYPE x><robot", "DOCTYPE"),
    ],
)
def test_a_urdf_that_is_wrong_is_refused_by_its_file(with_urdf: Path, old: str, new: str, word: str) -> None:
    assert old in URDF
    (with_urdf / "urdf/cell.urdf").write_text(URDF.replace(old, new))
    with pytest.raises(InputError) as error:
        cell_of(with_urdf, "hall: {urdf: {file: urdf/cell.urdf}}")
    assert "cell.urdf" in str(error.value)
    assert word in str(error.value)


# --------------------------------------------------------------------------------------------------- folders and lists


def test_a_folder_of_meshes_is_a_body_for_each_file(tmp_path: Path) -> None:
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts/readme.txt").write_text("no mesh")
    for i, kind in enumerate(("stl", "obj", "glb")):
        box = trimesh.creation.box((1, 2, 3), trimesh.transformations.translation_matrix([i, 0, 10]))
        if kind == "glb":  # y points up in glTF: our z is its y
            box.apply_transform(trimesh.transformations.rotation_matrix(-np.pi / 2, [1, 0, 0]))
        box.export(tmp_path / f"parts/post_{i}.{kind}")
    folder = 'fixtures: {folder: {path: parts, scale: 0.1, position: [0, 0, 1], rpy: "[0, 0, 90] deg"}}'
    found = bodies(cell_of(tmp_path, folder))
    assert list(found) == ["fixtures/post_0", "fixtures/post_1", "fixtures/post_2"]
    for i, solid in enumerate(found.values()):
        low, high = points(solid).min(axis=0), points(solid).max(axis=0)
        np.testing.assert_allclose(low, [-0.1, 0.1 * i - 0.05, 1.85], atol=1e-6)
        np.testing.assert_allclose(high, [0.1, 0.1 * i + 0.05, 2.15], atol=1e-6)


LISTS = {
    "bodies.csv": "name,file,x [mm],y [mm],z [mm],rx [deg],ry [deg],rz [deg],scale,on,ignore\n"
    "post,post.obj,100,200,300,10,20,30,0.5,,link_2 link_3\n# a remark\nplate,post.obj,0,0,5,0,0,0,,STN1,\n",
    "bodies.txt": "name;file;x [m];y [m];z [m];q1;q2;q3;q4;scale;on;ignore\n"
    "post;post.obj;0,1;0,2;0,3;{q};0,5;;link_2 link_3\nplate;post.obj;0;0;0,005;;;;;;STN1;\n",
    "bodies.yaml": 'post: {file: post.obj, position: "[100, 200, 300] mm", rpy: "[10, 20, 30] deg", scale: 0.5, '
    "ignore: [link_2, link_3]}\nplate: {file: post.obj, position: [0, 0, 0.005], on: STN1}\n",
}


@pytest.mark.parametrize("name", LISTS)
def test_bodies_of_a_list_stand_where_it_has_them(tmp_path: Path, name: str) -> None:
    R = pin.rpy.rpyToMatrix(*np.radians([10, 20, 30]))
    x, y, z, w = pin.Quaternion(R).coeffs()
    quaternion = ";".join(f"{value:.12f}".replace(".", ",") for value in (w, x, y, z))
    (tmp_path / name).write_text(LISTS[name].replace("{q}", quaternion))
    (tmp_path / "post.obj").write_text(TETRA)
    cell = cell_of(tmp_path, f"cell: {{list: {{file: {name}, position: [0, 0, 1]}}}}", POSTS + CELL)
    found = {solid.name: solid for solid in cell.obstacles}
    assert list(found) == ["cell/post", "cell/plate"]
    post = found["cell/post"].shape
    assert isinstance(post, MeshFile)
    np.testing.assert_allclose(post.X[:3, :3], R, atol=1e-9)
    np.testing.assert_allclose(post.X[:3, 3], [0.1, 0.2, 1.3], atol=1e-12)
    assert post.scale == 0.5
    assert found["cell/post"].ignore == {"link_2", "link_3"}
    assert found["cell/plate"].rides == ("stn1", 1)
    np.testing.assert_allclose(found["cell/plate"].shape.X[:3, 3], [0, 0, 1.005], atol=1e-12)
    assert [path.name for path in cell.mesh_files] == [name, "post.obj"]
    assert set(bodies(cell)) == {"cell/post", "cell/plate"}


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("name,file,x\np,post.obj,1\n", 1),  # no unit
        ("name,file,x [deg]\np,post.obj,1\n", 1),
        ("name,file,width [mm]\np,post.obj,1\n", 1),
        ("name,file,x [mm],x [mm]\np,post.obj,1,2\n", 1),
        ("name,file,x [mm],y [mm],z [mm]\np,post.obj,1,2\n", 2),
        ("name,file,x [mm],y [mm],z [mm]\np,post.obj,1,,3\n", 2),
        ("name,file,x [mm],y [mm],z [mm]\np,post.obj,1,a,3\n", 2),
        ("name,file,q1,q2,q3,q4\nq,post.obj,1,0,0,0\np,post.obj,1,1,0,0\n", 3),
        ("name,file\np,post.obj\np,post.obj\n", 3),
        ("name,file\np,post.obj\nq,\n", 3),
        ("name,file\np,../post.obj\n", 2),
        ("name,file,scale\np,post.obj,-1\n", 2),
    ],
)
def test_a_list_that_is_wrong_is_refused_by_its_line(tmp_path: Path, text: str, line: int) -> None:
    (tmp_path / "bodies.csv").write_text(text)
    with pytest.raises(InputError) as error:
        cell_of(tmp_path, "cell: {list: {file: bodies.csv}}")
    assert Path(error.value.file or "").name == "bodies.csv"
    assert error.value.line == line


@pytest.mark.parametrize(
    ("obstacles", "key"),
    [
        ("a: {folder: {path: nothing}}", "obstacles.a"),
        ("a: {list: {file: nothing.csv}}", "nothing.csv"),
        ("a: {urdf: {file: nothing.urdf}}", "nothing.urdf"),
        ("a: {urdf: {file: ../x.urdf}}", "obstacles.a.urdf.file"),
        ("a: {urdf: {file: x.urdf}, box: {size: [1, 1, 1]}}", "obstacles.a"),
    ],
)
def test_files_that_are_not_there_are_told(tmp_path: Path, obstacles: str, key: str) -> None:
    with pytest.raises(InputError, match=key):
        cell_of(tmp_path, obstacles)


@pytest.mark.parametrize(
    ("kind", "wanted"), [("urdf", "{file: a}"), ("list", "{file: a}"), ("mesh", "{file: a}"), ("folder", "{path: a}")]
)
def test_a_name_alone_is_told_how_to_be_written(tmp_path: Path, kind: str, wanted: str) -> None:
    with pytest.raises(InputError, match=f"obstacles.hall.{kind}.*{wanted}") as error:
        cell_of(tmp_path, f"hall: {{{kind}: a}}")
    assert error.value.line == 4


# ------------------------------------------------------------------------------------------------- glTF beside, STEP


def test_the_buffers_of_a_gltf_are_kept_with_it(tmp_path: Path) -> None:
    scene = trimesh.Scene(trimesh.creation.box((1, 2, 3)))
    for name, content in scene.export(file_type="gltf").items():
        (tmp_path / name.replace("model", "post")).write_bytes(content)
    cell = cell_of(tmp_path, "post: {mesh: {file: post.gltf}}")
    assert len(cell.mesh_files) > 1
    assert all(path.is_file() for path in cell.mesh_files)
    np.testing.assert_allclose(np.ptp(points(bodies(cell)["post"]), axis=0), [1, 3, 2], atol=1e-6)


def test_a_step_file_needs_its_library(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, "cascadio", None)
    (tmp_path / "post.step").write_text(step_box(100, 200, 300))
    with pytest.raises(InputError, match="cascadio") as error:
        build_plant(cell_of(tmp_path, "post: {mesh: {file: post.step}}"))
    assert error.value.line == 4


def test_a_step_file_is_read_in_metres_with_its_own_axes(tmp_path: Path) -> None:
    pytest.importorskip("cascadio")
    (tmp_path / "post.step").write_text(step_box(100, 200, 300))
    found = points(bodies(cell_of(tmp_path, "post: {mesh: {file: post.step}}"))["post"])
    np.testing.assert_allclose(found.min(axis=0), [0, 0, 0], atol=1e-6)
    np.testing.assert_allclose(found.max(axis=0), [0.1, 0.2, 0.3], atol=1e-6)


def step_box(*size: float) -> str:
    """A box from the origin on, in mm, as AP214 text (ISO 10303-21)."""
    lines: list[str] = []

    def add(text: str) -> str:
        lines.append(f"#{len(lines) + 1}={text};")
        return f"#{len(lines)}"

    def point(p: Array) -> str:
        return add(f"CARTESIAN_POINT('',({p[0]:.6f},{p[1]:.6f},{p[2]:.6f}))")

    def direction(d: Array) -> str:
        return add(f"DIRECTION('',({d[0]:.6f},{d[1]:.6f},{d[2]:.6f}))")

    def axes(p: Array, z: Array, x: Array) -> str:
        return add(f"AXIS2_PLACEMENT_3D('',{point(p)},{direction(z)},{direction(x)})")

    corner = {(i, j, k): np.array([i, j, k]) * size for i in (0, 1) for j in (0, 1) for k in (0, 1)}
    vertex = {key: add(f"VERTEX_POINT('',{point(p)})") for key, p in corner.items()}
    edges: dict[tuple[tuple[int, ...], tuple[int, ...]], str] = {}
    faces = []
    for axis in range(3):
        for side in (0, 1):
            u, v = np.roll(np.eye(3, dtype=int), -axis, axis=0)[1:]
            loop = [side * np.eye(3, dtype=int)[axis] + a * u + b * v for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
            loop = loop if side else loop[::-1]
            oriented = []
            for a, b in zip(loop, [*loop[1:], loop[0]], strict=True):
                start, end = sorted((tuple(a.tolist()), tuple(b.tolist())))
                if (start, end) not in edges:
                    way = corner[end] - corner[start]
                    vector = add(f"VECTOR('',{direction(way / np.linalg.norm(way))},1.)")
                    line = add(f"LINE('',{point(corner[start])},{vector})")
                    edges[start, end] = add(f"EDGE_CURVE('',{vertex[start]},{vertex[end]},{line},.T.)")
                sense = "T" if (start, end) == (tuple(a.tolist()), tuple(b.tolist())) else "F"
                oriented.append(add(f"ORIENTED_EDGE('',*,*,{edges[start, end]},.{sense}.)"))
            bound = add(f"FACE_OUTER_BOUND('',{add(f'EDGE_LOOP({chr(39) * 2},({chr(44).join(oriented)}))')},.T.)")
            normal = (2.0 * side - 1) * np.eye(3)[axis]
            plane = add(f"PLANE('',{axes(loop[0] * np.array(size), normal, np.roll(np.eye(3), -axis, axis=0)[1])})")
            faces.append(add(f"ADVANCED_FACE('',({bound}),{plane},.T.)"))
    solid = add(f"MANIFOLD_SOLID_BREP('',{add(f'CLOSED_SHELL({chr(39) * 2},({chr(44).join(faces)}))')})")
    units = [
        add("(LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.))"),
        add("(NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.))"),
        add("(NAMED_UNIT(*) SI_UNIT($,.STERADIAN.) SOLID_ANGLE_UNIT())"),
    ]
    near = add(f"UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-6),{units[0]},'','')")
    context = add(
        f"(GEOMETRIC_REPRESENTATION_CONTEXT(3) GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({near})) "
        f"GLOBAL_UNIT_ASSIGNED_CONTEXT(({','.join(units)})) REPRESENTATION_CONTEXT('',''))"
    )
    origin = axes(np.zeros(3), np.array([0, 0, 1.0]), np.array([1.0, 0, 0]))
    shape = add(f"ADVANCED_BREP_SHAPE_REPRESENTATION('',({origin},{solid}),{context})")
    application = add("APPLICATION_CONTEXT('automotive design')")
    product = add(
        f"PRODUCT('box','box','',({add(f'PRODUCT_CONTEXT({chr(39) * 2},{application},{chr(39)}mechanical{chr(39)})')}))"
    )
    formation = add(f"PRODUCT_DEFINITION_FORMATION('','',{product})")
    design = add(f"PRODUCT_DEFINITION_CONTEXT('part definition',{application},'design')")
    definition = add(f"PRODUCT_DEFINITION('design','',{formation},{design})")
    defined = add(f"PRODUCT_DEFINITION_SHAPE('','',{definition})")
    add(f"SHAPE_DEFINITION_REPRESENTATION({defined},{shape})")
    head = "HEADER;FILE_DESCRIPTION((''),'2;1');FILE_NAME('','',(''),(''),'','','');"
    head += "FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));ENDSEC;"
    return "\n".join(["ISO-10303-21;", head, "DATA;", *lines, "ENDSEC;", "END-ISO-10303-21;"])


def test_vertices_within_faces_leave_a_mesh_solid(tmp_path: Path) -> None:
    """A cylinder with a vertex in the middle of each end, as tools write it: the depth inside is the whole depth."""
    trimesh.creation.cylinder(0.1, 1.0, sections=32).export(tmp_path / "pin.stl")
    shape = bodies(cell_of(tmp_path, "pin: {mesh: {file: pin.stl}}"))["pin"].loaded
    ball = Capsule("ball", np.array([0, 0, 0.48]), np.array([0, 0, 0.48]), 0.01)
    assert Pair(ball, shape).distances(np.eye(4)[None])[0] == pytest.approx(-0.03, abs=1e-6)
