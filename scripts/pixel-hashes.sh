#!/usr/bin/env bash
# Shows whether a change of the program changes a pixel: renders the demo and many small variants of the example shots on the
# CPU, by all methods, and prints a hash of each channel of each EXR, of each PNG and of each bake's coefficients. All data is
# made by the program itself. What the program of another commit prints is compared by diff:
#
#   scripts/pixel-hashes.sh GLIMT >hashes.txt
#   scripts/pixel-hashes.sh GLIMT FOLDER >hashes.txt    keeps the images in FOLDER, which must not exist
#
# GLIMT is the program, as target/release/glimt.
set -euo pipefail
[ $# -ge 1 ] || { sed -n '2,9s/^# \{0,1\}//p' "$0" >&2; exit 2; }
glimt=$(realpath "$1")
if [ $# -ge 2 ]; then
    mkdir -p "$(dirname "$2")"
    mkdir "$2"
    work=$(realpath "$2")
else
    work=$(mktemp -d)
    trap 'rm -rf "$work"' EXIT
fi
cd "$(dirname "$0")/.."
cargo build --release --locked --quiet --bin pixel-hashes
hashes=$(realpath "${CARGO_TARGET_DIR:-target}")/release/pixel-hashes
cp -r examples/shots "$work/shots"
rm -rf "$work"/shots/film "$work"/shots/helicopter/light "$work"/shots/out "$work"/shots/helicopter/out
cd "$work/shots"

run() {
    "$glimt" "$@" --quiet >>"$work/log.txt" 2>&1 || {
        echo "FAILED: $glimt $*" >&2
        tail -n 20 "$work/log.txt" >&2
        exit 1
    }
}

begun=$SECONDS
# render NAME SHOT FLAG …: small, with few rays; the images lie in images/NAME. A key set later wins.
small=(--device cpu --set image.rays_per_pixel=3 --set output.video=)
render() {
    local name=$1 shot=$2
    shift 2
    run render "$shot" --out "$work/images/$name" "${small[@]}" "$@"
    printf '%3d s %s\n' $((SECONDS - begun)) "$name" >&2
}

# The light of the shots. What is filmed is hashed too.
run synth synth.toml --device cpu --frames 1-4
run synth helicopter/synth.toml --device cpu --frames 1-4
printf '%3d s synth\n' $((SECONDS - begun)) >&2

size=(--set image.size=[120,68])
brdf_light=(--method bis --set render.bis.candidates=48 --set render.bis.samples=4)
particles=(--method smc --set render.smc.particles=4)
health='"ess","z-ratio","age","started","z-spread"'

# One object before the light.
still=("${size[@]}" --frames 1)
render still-mis still.toml "${still[@]}"
render still-centre-stratified still.toml "${still[@]}" --set image.filter=centre --set render.pattern=stratified
render still-independent-clear still.toml "${still[@]}" --set render.pattern=independent --set image.background=transparent
render still-reinhard still.toml "${still[@]}" --set image.tonemap=reinhard --set image.exposure_ev=-3.5 --seed 7
render still-turned still.toml "${still[@]}" --set probe.rotate_z_deg=70 --set probe.scale=0.5
render still-strata still.toml "${still[@]}" --set render.preset=stratified
render still-kronander still.toml "${still[@]}" --set render.preset=kronander
render still-kronander-bis still.toml "${still[@]}" --set render.preset=kronander --method bis
for source in brdf environment mixture; do
    render "still-bis-$source" still.toml "${still[@]}" "${brdf_light[@]}" --set render.bis.source=$source
done

# Film of a mirror ball, unwarped on the way.
ball=("${size[@]}" --frames 1-2)
render ball-mis mirror-ball.toml "${ball[@]}"
render ball-bis mirror-ball.toml "${ball[@]}" "${brdf_light[@]}"
render ball-smc mirror-ball.toml "${ball[@]}" "${particles[@]}" --set "output.aovs=[$health]"

# Over a plate, with layers; and the same shot before the light and before nothing.
layers='"object","catcher","difference"'
sed '/^\[backplate\]/,/^$/d' catcher.toml >no-plate.toml
film=("${size[@]}" --frames 1-2 --set "output.aovs=[$layers]")
render plate-mis catcher.toml "${film[@]}"
render plate-bis catcher.toml "${film[@]}" "${brdf_light[@]}"
render plate-smc catcher.toml "${film[@]}" "${particles[@]}" --set "output.aovs=[$layers,$health]"
render plate-add catcher.toml "${film[@]}" --set backplate.shadow=add --set image.size=[100,80] --set backplate.fit=crop
render plate-kronander catcher.toml "${film[@]}" --set render.preset=kronander
render no-plate-mis no-plate.toml "${film[@]}"
render no-plate-bis-clear no-plate.toml "${film[@]}" "${brdf_light[@]}" --set image.background=transparent
render no-plate-smc-clear no-plate.toml "${film[@]}" "${particles[@]}" --set image.background=transparent

# Everything moves: objects, lamps, camera.
moving=("${size[@]}" --frames 1-4)
render helicopter-mis helicopter/shot.toml "${moving[@]}"
render helicopter-bis helicopter/shot.toml "${moving[@]}" "${brdf_light[@]}"
render helicopter-smc helicopter/shot.toml "${moving[@]}" "${particles[@]}" --set "output.aovs=[$health]"
render helicopter-kronander-smc helicopter/shot.toml "${size[@]}" --frames 1-2 --method smc --set render.preset=kronander \
    --set image.filter=centre --set "output.aovs=[$health]"
for scheme in stratified multinomial residual; do
    render "helicopter-smc-$scheme" helicopter/shot.toml "${moving[@]}" "${particles[@]}" \
        --set render.smc.resampling=$scheme --set render.smc.path=geometric --set render.smc.floor=0.1 --set render.smc.max_age=2
done
# A part of a shot: led up to, and continued from a saved state.
render helicopter-preroll helicopter/shot.toml "${size[@]}" "${particles[@]}" --frames 3-4 --preroll 2
render helicopter-first helicopter/shot.toml "${size[@]}" "${particles[@]}" --frames 1-2 --state-out "$work/state"
render helicopter-second helicopter/shot.toml "${size[@]}" "${particles[@]}" --frames 3-4 --state-in "$work/state"
# Frames that are followed, all of which are there.
render helicopter-follow helicopter/shot.toml "${size[@]}" --follow --wait 1 --max-lag 1000
render helicopter-follow-smc helicopter/shot.toml "${size[@]}" "${particles[@]}" --follow --wait 1 --max-lag 1000

# Precomputed transfer.
bake=(--set render.prt.directions=100 --set object.1.subdivide=5)
run bake prt.toml --device cpu "${bake[@]}" -o "$work/images/prt.prt.glb"
stored=(--set "render.prt.bake=\"$work/images/prt.prt.glb\"" "${bake[@]}" "${size[@]}")
render prt prt.toml "${stored[@]}" --frames 1-3
render prt-window prt.toml "${stored[@]}" --frames 2 --set render.prt.temporal=0 --set render.prt.level=1 --set render.prt.window=5
render prt-unshadowed prt.toml "${stored[@]}" --frames 1 --set render.prt.shadows=false --set image.filter=centre \
    --set object.0.reflection=0.4
render prt-preroll prt.toml "${stored[@]}" --frames 3 --preroll 2
# The same over a plate.
sed -e '/^\[\[object.spin\]\]/,/^$/d' catcher.toml >plate-prt.toml
bake=(--set render.prt.directions=40 --set render.prt.bands=4 --set object.2.subdivide=6)
run bake plate-prt.toml --device cpu "${bake[@]}" -o "$work/images/plate.prt.glb"
stored=(--set "render.prt.bake=\"$work/images/plate.prt.glb\"" "${bake[@]}" --method prt)
render plate-prt plate-prt.toml "${film[@]}" "${stored[@]}"
render plate-prt-add plate-prt.toml "${film[@]}" "${stored[@]}" --set backplate.shadow=add

# A texture, and a mesh from glTF: the plate on a square, and what was baked.
cat >square.obj <<'OBJ'
mtllib square.mtl
v -3 0 -1
v 3 0 -1
v 3 0 3
v -3 0 3
vt 0 0
vt 1.5 0
vt 1.5 1
vt 0 1
usemtl picture
f 1/1 2/2 3/3 4/4
OBJ
printf 'newmtl picture\nKd 0.8 0.8 0.8\nKs 0.3 0.3 0.3\nNs 60\nmap_Kd film/plate/plate.0001.png\n' >square.mtl
textured=(--set object.0.mesh=square.obj --set object.0.up=z --set camera.eye=[1,-9,2] --set camera.target=[0,0,0.6])
render texture-mis still.toml "${still[@]}" "${textured[@]}"
render texture-smc still.toml "${still[@]}" "${textured[@]}" "${particles[@]}"
render gltf-mis still.toml "${still[@]}" --set "object.0.mesh=\"$work/images/prt.prt.glb\""

# Methods side by side: the mean images, against a reference of a few rays.
render reference still.toml "${still[@]}" --set image.background=transparent --set image.filter=centre
run compare still.toml --device cpu "${still[@]}" --equal-samples --seeds 2 --rounds 1 --keep --out "$work/images/compare" \
    --reference "$work/images/reference" --preset kronander-mis --preset kronander-bis --preset kronander-smc --preset shot
printf '%3d s compare\n' $((SECONDS - begun)) >&2

# The demo at its own size, without the video: its frames are hashed.
run demo --device cpu --set output.video= --out "$work/images/demo"
printf '%3d s demo\n' $((SECONDS - begun)) >&2

# What was filmed lies beside the shots.
mv film "$work/images/film"
mv helicopter/light "$work/images/light"
"$hashes" "$work/images"
