#!/usr/bin/env bash
# Proves that a shader crate of rust-gpu can use the algorithm crates, unchanged, as far as types go: entry points of
# `spirv-std` that call all of them type-check on the project's own toolchain. rust-gpu's code generator, which needs a
# nightly of its own, is not run here. A negative control shows that the check looks at what stands in the shader.
set -euo pipefail
cd "$(dirname "$0")"

log=$(mktemp)
trap 'rm -f "$log"' EXIT

fail() {
    echo "rust-gpu proof: $1" >&2
    sed 's/^/    /' "$log" >&2
    exit 1
}

# The proof is about the glam that the project is built with, and there is no second one.
versions() { awk -v name="\"$1\"" '/^name = / { found = $3 == name } /^version = / && found { print $3 }' "$2"; }
for package in glam libm; do
    versions "$package" Cargo.lock >"$log"
    [ "$(cat "$log")" = "$(versions "$package" ../../Cargo.lock)" ] || fail "another $package than the project's"
done

cargo check --locked --quiet >"$log" 2>&1 || fail "the shader does not type-check"
[ ! -s "$log" ] || fail "the shader type-checks with warnings"
if cargo check --locked --quiet --features control-type >"$log" 2>&1; then
    fail "a wrong type checks, so the proof proves nothing"
fi
grep -q 'error\[E0308\]: mismatched types' "$log" || fail "the control fails for another reason"
# One error, and cargo's line that it could not compile.
[ "$(grep -c '^error' "$log")" = 2 ] || fail "the control fails for more than one reason"
echo "a shader crate for rust-gpu type-checks with all algorithm crates; the negative control fails as it must"
