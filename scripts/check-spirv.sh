#!/usr/bin/env bash
# Turns every shader of the workspace into SPIR-V by naga, and validates it with Khronos' spirv-val, which is Debian's and is
# installed where there is none.
set -euo pipefail
cd "$(dirname "$0")/.."

if ! command -v spirv-val >/dev/null; then
    sudo=$([ "$(id -u)" = 0 ] || echo sudo)
    $sudo apt-get update -qq
    $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends spirv-tools
fi
folder=${CARGO_TARGET_DIR:-target}/spirv
rm -rf "$folder"
cargo run --release --locked --quiet --bin write-spirv -- "$folder"

failures=0
# A file's folder is named by the environment that it is for.
valid() {
    spirv-val --target-env "$(basename "$(dirname "$1")")" "$1"
}
for file in "$folder"/*/*.spv; do
    if valid "$file"; then
        echo "ok ${file#"$folder"/}"
    else
        echo "FAILED ${file#"$folder"/}"
        failures=$((failures + 1))
    fi
done
# The validator does look: it refuses a module without its end.
head -c -8 "$file" >"${file%.spv}.cut"
if valid "${file%.spv}.cut" 2>/dev/null; then
    echo "FAILED: $file is valid without its end"
    failures=$((failures + 1))
fi
[ "$failures" = 0 ] || {
    echo "$failures shaders are not valid SPIR-V"
    exit 1
}
