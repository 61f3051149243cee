"""Holds `cells` against stratified MIS in twelve shots: error² × time of a first and of a sixth frame.

    cargo build --release
    python3 benches/shots/twelve.py --data FOLDER --out FOLDER

FOLDER has `hdri/NAME_1k.hdr` and `models/{stanford-bunny.obj,Ingenuity.glb}`, as the shots below name them; all else is made here. It
needs Python alone. `glimt compare` renders and measures; what it measures stays in the folder, so another run continues. The noise of
its reference, which it reports, is taken off the square error: the two are independent.
"""

import argparse
import json
import math
import pathlib
import random
import subprocess

# Name, and keys: the counts of 16 camera rays.
CELLS = [
    ("cells", "render.method=cells render.cells.rays=96"),
    ("cells, no memory", "render.method=cells render.cells.rays=96 render.cells.memory=false"),
]
MIS = [
    ("8+8", "render.method=mis render.brdf_samples=8 render.env_samples=8"),
    ("8+8, plain", "render.method=mis render.brdf_samples=8 render.env_samples=8 render.compensation=false"),
]
# Dearer, and the best in none: with --all.
MIS_4 = [
    ("16+16 on 4", "image.rays_per_pixel=4 render.method=mis render.brdf_samples=16 render.env_samples=16"),
    (
        "16+16 on 4, plain",
        "image.rays_per_pixel=4 render.method=mis render.brdf_samples=16 render.env_samples=16 render.compensation=false",
    ),
]
FRAMES = 6

parser = argparse.ArgumentParser()
parser.add_argument("--data", type=pathlib.Path, required=True)
parser.add_argument("--out", type=pathlib.Path, required=True)
parser.add_argument("--glimt", default="target/release/glimt")
parser.add_argument("--seeds", type=int, default=16)
parser.add_argument("--size", default="[160,90]")
parser.add_argument("--reference-time", type=float, default=15.0)
parser.add_argument("--all", action="store_true", help="also 16 + 16 samples on 4 rays")
parser.add_argument("shots", nargs="*", help="parts of the names of shots; all without any")
args = parser.parse_args()
args.out.mkdir(parents=True, exist_ok=True)
contestants = CELLS + MIS + (MIS_4 if args.all else [])


class Light:
    """Rows of RGB triples."""

    def __init__(self, rows):
        self.rows = rows

    @staticmethod
    def read(name):
        """A Radiance file with new run lengths."""
        data = (args.data / "hdri" / f"{name}_1k.hdr").read_bytes()
        header, _, rest = data.partition(b"\n\n")
        size, _, body = rest.partition(b"\n")
        _, height, _, width = size.split()
        height, width = int(height), int(width)
        at, rows = 0, []
        for _ in range(height):
            at += 4
            planes = []
            for _ in range(4):
                plane = bytearray()
                while len(plane) < width:
                    count = body[at]
                    if count > 128:
                        plane += body[at + 1 : at + 2] * (count - 128)
                        at += 2
                    else:
                        plane += body[at + 1 : at + 1 + count]
                        at += 1 + count
                planes.append(plane)
            scale = [math.ldexp(1.0, e - 136) if e else 0.0 for e in planes[3]]
            rows.append([(r * s, g * s, b * s) for r, g, b, s in zip(*planes[:3], scale)])
        return Light(rows)

    def write(self, path):
        width = len(self.rows[0])
        out = bytearray(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % (len(self.rows), width))
        for row in self.rows:
            for texel in row:
                most = max(texel)
                if most < 1e-32:
                    out += bytes(4)
                    continue
                exponent = math.frexp(most)[1]
                scale = math.ldexp(256.0, -exponent)
                out += bytes([*(int(c * scale) for c in texel), exponent + 128])
        path.write_bytes(out)

    def turned(self, degrees):
        step = len(self.rows[0]) * degrees // 360
        return Light([row[len(row) - step :] + row[: len(row) - step] for row in self.rows])

    def doubled(self):
        return Light([[texel for texel in row for _ in range(2)] for row in self.rows for _ in range(2)])

    def with_lamps(self, factor):
        """What is brighter than 20 times the mean, times a factor."""
        mean = sum(max(t) for row in self.rows for t in row) / (len(self.rows) * len(self.rows[0]))
        scaled = lambda t: tuple(c * factor for c in t) if max(t) > 20 * mean else t
        return Light([[scaled(t) for t in row] for row in self.rows])


def still(name):
    return [Light.read(name)]


def turning(name):
    light = Light.read(name)
    return [light.turned(3 * frame) for frame in range(FRAMES)]


def flickering(name):
    light, draw = Light.read(name), random.Random(1)
    return [light.with_lamps(draw.uniform(0.5, 1.5)) for _ in range(FRAMES)]


def cut(before, after):
    """The last frame is the first under the second light."""
    lights = Light.read(before), Light.read(after)
    return [lights[frame == FRAMES - 1] for frame in range(FRAMES)]


def smooth():
    def row(y):
        up = math.cos(math.pi * (y + 0.5) / 64)
        turn = [math.cos(2 * math.pi * x / 128) for x in range(128)]
        return [(1 + 0.5 * c * (1 - up * up) ** 0.5 + 0.3 * up,) * 3 for c in turn]

    return [Light([row(y) for y in range(64)])]


def constant():
    return [Light([[(1.0, 1.0, 1.0)] * 64] * 32)]


def large():
    return [Light.read("spiaggia_di_mondello").doubled()]


def write_triangles(path, count, blades):
    draw, lines = random.Random(3), []
    for i in range(count):
        if blades:
            x, y, turn = draw.uniform(-2, 2), draw.uniform(-2, 2), draw.uniform(0, 2 * math.pi)
            dx, dy, top = 0.015 * math.cos(turn), 0.015 * math.sin(turn), draw.uniform(0.3, 0.9)
            lean = draw.gauss(0, 0.12), draw.gauss(0, 0.12)
            corners = [(x - dx, y - dy, 0), (x + dx, y + dy, 0), (x + lean[0], y + lean[1], top)]
        else:
            centre = [draw.gauss(0, 0.7), draw.gauss(0, 0.7), abs(draw.gauss(0, 0.8)) + 0.1]
            corners = [[c + draw.uniform(-0.13, 0.13) for c in centre] for _ in range(3)]
        lines += ["v {:.5f} {:.5f} {:.5f}".format(*c) for c in corners]
        lines.append(f"f {3 * i + 1} {3 * i + 2} {3 * i + 3}")
    path.write_text("\n".join(lines) + "\n")


def matt(kd):
    return f"{{ diffuse = [{kd}, {kd}, {kd}] }}"


def glossy(kd, ks, exponent):
    return f"{{ diffuse = [{kd}, {kd}, {kd}], specular = [{ks}, {ks}, {ks}], exponent = {exponent} }}"


def bunny(material):
    mesh = (args.data / "models" / "stanford-bunny.obj").resolve().as_posix()
    return mesh, f"scale = 11.0\ntranslate = [0.2, 0.0, 0.0]\nmaterial = {material}"


INGENUITY = (args.data / "models" / "Ingenuity.glb").resolve().as_posix()
SPIN = '\n[[object.spin]]\nnode = "main rotor"\ndeg_per_frame = 37.0'
# Lights of the frames, mesh with its keys, whether the camera moves.
SHOTS = {
    "diffuse sphere, sun, still": (lambda: still("spiaggia_di_mondello"), ("sphere", f"material = {matt(0.7)}"), False),
    "helicopter, warehouse, camera, rotor": (lambda: still("empty_warehouse_01"), ("helicopter", "scale = 0.35" + SPIN), True),
    "bunny e = 50, studio, camera": (lambda: still("studio_small_03"), bunny(glossy(0.3, 0.6, 50)), True),
    "bunny e = 50, studio, flicker": (lambda: flickering("studio_small_03"), bunny(glossy(0.3, 0.6, 50)), True),
    "sphere e = 500, interior, turning": (lambda: turning("st_fagans_interior"), ("sphere", f"material = {glossy(0.1, 0.9, 500)}"), False),
    "sphere e = 50, a cut to night": (lambda: cut("st_fagans_interior", "dikhololo_night"), ("sphere", f"material = {glossy(0.3, 0.6, 50)}"), False),
    "diffuse sphere, constant, still": (constant, ("sphere", f"material = {matt(0.7)}"), False),
    "triangles, warehouse, camera": (lambda: still("empty_warehouse_01"), ("triangles.obj", f"material = {matt(0.5)}"), True),
    "textures, normal maps, sunrise, camera": (lambda: still("spruit_sunrise"), (INGENUITY, "scale = 1.6"), True),
    "diffuse bunny, sun, 2048×1024": (large, bunny(matt(0.6)), False),
    "bunny e = 500, smooth, camera": (smooth, bunny(glossy(0.1, 0.8, 500)), True),
    "grass, sunset, camera": (lambda: still("venice_sunset"), ("grass.obj", f"material = {matt(0.35)}"), True),
}


def write_shot(folder, lights, mesh, camera_moves):
    folder.mkdir(exist_ok=True)
    for number, light in enumerate(lights, 1):
        light.write(folder / f"light.{number:04}.hdr")
    frames = "light.####.hdr" if len(lights) > 1 else "light.0001.hdr"
    name, keys = mesh
    up = 'up = "z"\n' if name in ("triangles.obj", "grass.obj") else ""
    name = f"../{name}" if up else name
    eyes = [("3.2", "-4.0"), ("3.6", "-3.65")] if camera_moves else [("3.2", "-4.0")]
    camera = "fov_x_deg = 40.0\n" + "".join(
        f"[[camera.key]]\nframe = {1 + (FRAMES - 1) * i}\neye = [{x}, {y}, 2.2]\ntarget = [0.0, 0.0, 0.8]\n" for i, (x, y) in enumerate(eyes)
    )
    text = f"""[image]
size = {args.size}
rays_per_pixel = 16
[camera]
{camera}[probe]
frames = "{frames}"
mapping = "lat-long"
[render]
frames = "1-{FRAMES}"
[[object]]
mesh = "{name}"
{up}ground = true
{keys}
[[object]]
mesh = "plane"
scale = 12.0
material = {matt(0.5)}
"""
    shot = folder / "shot.toml"
    shot.write_text(text)
    return shot


def efficiency(report, frame):
    """1 / (error² × time) of each contestant in a frame."""
    noise = report["references"][frame]["noise"]
    result = {}
    for own in report["contestants"]:
        squares = [record["square_error"] for record in own["records"][frame]]
        error2 = sum(squares) / len(squares) - noise**2
        result[own["name"]] = 1 / (max(error2, 1e-3 * noise**2) * own["time"]["median"])
    return result


def mean(values):
    return math.exp(sum(map(math.log, values)) / len(values))


write_triangles(args.out / "triangles.obj", 3000, False)
write_triangles(args.out / "grass.obj", 4000, True)
names = [own[0] for own in CELLS]
table = {(name, frame): [] for name in names for frame in (0, 1)}
for title, (lights, mesh, camera_moves) in SHOTS.items():
    if args.shots and not any(part in title for part in args.shots):
        continue
    folder = args.out / "".join(c if c.isalnum() else "-" for c in title)
    shot = write_shot(folder, lights(), mesh, camera_moves)
    command = [args.glimt, "compare", str(shot), "--device", "cpu", "--equal-samples", "--measure", f"1,{FRAMES}", "--quiet"]
    command += ["--seeds", str(args.seeds), "--rounds", "3", "--reference-time", str(args.reference_time), "--out", str(folder / "compare")]
    for name, keys in contestants:
        command += ["--contestant", f"{name}: {keys}"]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    report = json.loads((folder / "compare" / "compare.json").read_text())
    row = []
    for frame in (0, 1):
        own = efficiency(report, frame)
        best = max(value for name, value in own.items() if name not in names)
        for name in names:
            table[name, frame].append(own[name] / best)
            row.append(f"{name}, frame {(1, FRAMES)[frame]}: {own[name] / best:.2f}")
    share = max(r["share_of_error"] for r in report["references"])
    print(f"{title}: {'; '.join(row)}; reference's share {share:.2f}", flush=True)
for (name, frame), values in table.items():
    print(f"geometric mean of {name}, frame {(1, FRAMES)[frame]}: {mean(values):.2f}, least {min(values):.2f}")
