#!/usr/bin/env bash
# Compiles every shader of the workspace in headless Chromium, whose compiler (Tint) refuses texts that naga takes. Chromium
# is Debian's, and is installed where there is none; another one is taken from the variable CHROMIUM.
set -euo pipefail
cd "$(dirname "$0")/.."

browser=${CHROMIUM:-chromium}
if ! command -v "$browser" >/dev/null; then
    sudo=$([ "$(id -u)" = 0 ] || echo sudo)
    $sudo apt-get update -qq
    $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends chromium
fi
cargo run --release --locked --quiet --bin browser-shaders -- "$browser"
