"""Times Embree's single shadow rays on the rays of `benches/rays.rs`, and checks that the answers are the same.

    RAYS_DIR=/tmp/rays cargo bench -p glimt-benches --bench rays
    pip install embreex numpy
    python benches/peers/against_embree.py /tmp/rays
"""

import importlib.metadata
import sys
import time

import embreex.mesh_construction
import embreex.rtcore_scene
import numpy

ROUNDS = 15

folder = sys.argv[1]
triangles = numpy.fromfile(f"{folder}/triangles.f32", numpy.float32).reshape(-1, 3, 3)
rays = numpy.fromfile(f"{folder}/rays.f32", numpy.float32).reshape(-1, 2, 3)
expected = numpy.fromfile(f"{folder}/blocked.u8", numpy.uint8) > 0
origins = numpy.ascontiguousarray(rays[:, 0])
directions = numpy.ascontiguousarray(rays[:, 1])

scene = embreex.rtcore_scene.EmbreeScene()
embreex.mesh_construction.TriangleMesh(scene, triangles)

times = []
for _ in range(ROUNDS):
    begun = time.process_time()
    found = scene.run(origins, directions, query="OCCLUDED")
    times.append(time.process_time() - begun)
blocked = numpy.asarray(found) >= 0
if blocked.mean() > 0.5:
    blocked = ~blocked
median = sorted(times)[ROUNDS // 2]
print(f"embreex {importlib.metadata.version('embreex')}: {len(triangles)} triangles, {len(rays)} rays")
print(f"{(blocked != expected).sum()} answers differ")
print(f"{1e9 * median / len(rays):.1f} ns/ray, median of {ROUNDS} rounds")
