"""robots.py PICTURE.png [NAME ...]: every robot that ships with its bodies, all axes at 0, on one sheet.

Solids with one shade a face, by a depth buffer; in the paint that the robot's file says.
"""

import sys

import numpy as np
from matplotlib.figure import Figure

from trajopt_cli.exporters.gltf import surface
from trajopt_cli.geometry import Array
from trajopt_cli.robot.catalogue import find_robot, read_head
from trajopt_cli.robot.model import load_robot, robot_names
from trajopt_cli.robot.srs import load_srs
from trajopt_cli.robot.structure import Structure
from trajopt_cli.scene import CARRIAGE, LINK, WORLD, Scene, scene_of_robot

COLUMNS, WIDE, HIGH, FINE = 6, 190, 200, 3  # pictures a row, px of each, pixels of a pixel
STROKE = 1.0  # m of a rail
LIGHT = np.array([-0.45, -0.6, 0.66])
OTHER = "#8d969f"


def scene_of(name: str) -> Scene:
    """A robot alone, or on a rail of STROKE."""
    if read_head(find_robot(name)).structure is Structure.SRS:
        return scene_of_robot(load_srs(name))
    robot = load_robot(name)
    return scene_of_robot(robot, strokes=[(-STROKE / 2, STROKE / 2)] * robot.has_rail)


def triangles_of(scene: Scene) -> tuple[Array, Array]:
    """Triangles (m, 3, 3) in the world with their colours (m, 3), all axes at 0."""
    poses = [*scene.poses(np.zeros((1, len(scene.axes))))[0], np.eye(4), scene.base]  # WORLD is -2, BASE is -1
    corners, colours = [], []
    for body in scene.bodies:
        vertices, triangles = surface(body.shape)
        X = poses[body.frame] @ getattr(body.shape, "X", np.eye(4))
        corners.append((vertices @ X[:3, :3].T + X[:3, 3])[triangles])
        colour = scene.colour if body.role == LINK and scene.colour else OTHER
        shade = 0.92 if body.role in (LINK, CARRIAGE) and body.frame % 2 else 1.0
        paint = shade * np.array([int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)])
        colours.append(np.tile(paint, (len(triangles), 1)))
    assert WORLD == -2
    return np.concatenate(corners), np.concatenate(colours)


def drawn(scene: Scene) -> Array:
    """A picture (HIGH, WIDE, 3) from in front, from the right and from above."""
    turn, lift = np.radians(-50), np.radians(20)
    ahead = np.array([np.cos(lift) * np.cos(turn), np.cos(lift) * np.sin(turn), np.sin(lift)])
    right = np.array([-np.sin(turn), np.cos(turn), 0.0])
    up = np.cross(ahead, right)
    corners, colours = triangles_of(scene)
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-12)
    normal *= np.where(normal @ ahead < 0, -1.0, 1.0)[:, None]
    colours = np.clip(colours * (0.62 + 0.42 * np.maximum(normal @ LIGHT, 0.0))[:, None], 0, 1)
    seen = corners @ np.stack([right, up, ahead], axis=1)
    low, high = seen[..., :2].min(axis=(0, 1)), seen[..., :2].max(axis=(0, 1))
    wide, tall = WIDE * FINE, HIGH * FINE
    scale = 0.92 * min(wide / (high - low)[0], tall / (high - low)[1])
    flat = (seen[..., :2] - (low + high) / 2) * scale * [1, -1] + [wide / 2, tall / 2]
    picture, depth = np.ones((tall, wide, 3)), np.full((tall, wide), -np.inf)
    for p, z, colour in zip(flat, seen[..., 2], colours, strict=True):
        (x_0, y_0), (x_1, y_1) = np.floor(p.min(axis=0)).astype(int), np.ceil(p.max(axis=0)).astype(int) + 1
        area = np.cross(np.append(p[1] - p[0], 0), np.append(p[2] - p[0], 0))[2]
        if abs(area) < 1e-9:
            continue
        y, x = np.mgrid[y_0:y_1, x_0:x_1]
        share = [
            ((b[0] - x) * (c[1] - y) - (b[1] - y) * (c[0] - x)) / area
            for b, c in ((p[1], p[2]), (p[2], p[0]), (p[0], p[1]))
        ]
        far = sum(one * at for one, at in zip(share, z, strict=True))
        here = (np.minimum.reduce(share) >= -1e-9) & (far > depth[y_0:y_1, x_0:x_1])
        depth[y_0:y_1, x_0:x_1][here] = far[here]
        picture[y_0:y_1, x_0:x_1][here] = colour
    return picture.reshape(HIGH, FINE, WIDE, FINE, 3).mean(axis=(1, 3))


def main() -> None:
    """The sheet."""
    names = sys.argv[2:] or [*robot_names()]
    rows = -(-len(names) // COLUMNS)
    figure = Figure(figsize=(COLUMNS * WIDE / 100, rows * (HIGH + 22) / 100), dpi=100)
    for i, name in enumerate(names):
        left, top = i % COLUMNS / COLUMNS, 1 - i // COLUMNS / rows
        tall = HIGH / (HIGH + 22) / rows
        axes = figure.add_axes((left, top - tall, 1 / COLUMNS, tall))
        axes.imshow(drawn(scene_of(name)))
        axes.set_axis_off()
        figure.text(left + 0.5 / COLUMNS, top - 1 / rows + 0.006 / rows * 6, name, ha="center", va="bottom", size=8)
    figure.savefig(sys.argv[1])


if __name__ == "__main__":
    main()
