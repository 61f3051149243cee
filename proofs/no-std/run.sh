#!/usr/bin/env bash
# Proves that every algorithm crate builds, links and runs without the standard library and without a heap.
#
# For each crate a `no_std`, `no_main` program on this host links it alone, calls it, and exits with 0 if what it computed
# is right. A program that had an allocating crate in it would not build: rustc refuses to link `alloc` without a global
# allocator. Two negative controls show that this would be noticed: the same programs must fail to build
#   control-alloc  once they use `alloc`:        "no global memory allocator found"
#   control-std    once they turn on glam's std: E0152, two panic handlers
# and for no other reason.
set -euo pipefail
cd "$(dirname "$0")"

crates=(probe sampling envmap-cdf brdf light-cells smc sh)
declare -A expected=(
    [control-alloc]='no global memory allocator found'
    [control-std]='error\[E0152\]: found duplicate lang item `panic_impl`'
)
log=$(mktemp)
trap 'rm -f "$log"' EXIT

fail() {
    echo "no_std proof: $1" >&2
    sed 's/^/    /' "$log" >&2
    exit 1
}

# The proof is about the versions that the project is built with.
packages() { awk '/^name = / { name = $3 } /^version = / { version = $3 } /^source = / { print name, version }' "$1" | sort; }
comm -23 <(packages Cargo.lock) <(packages ../../Cargo.lock) >"$log"
[ ! -s "$log" ] || fail "Cargo.lock has packages or versions that the project's has not"

for crate in "${crates[@]}"; do
    package=proof-$crate
    cargo build --locked --quiet -p "$package" >"$log" 2>&1 || fail "$crate does not build without std and alloc"
    "./target/debug/$package" >"$log" 2>&1 || fail "$crate computes something else without std"
    for control in control-alloc control-std; do
        if cargo build --locked --quiet -p "$package" --features "$control" >"$log" 2>&1; then
            fail "$crate: $control builds, so the proof proves nothing"
        fi
        grep -q "${expected[$control]}" "$log" || fail "$crate: $control fails for another reason"
        # One error, and cargo's line that it could not compile.
        [ "$(grep -c '^error' "$log")" = 2 ] || fail "$crate: $control fails for more than one reason"
    done
    echo "glimt-$crate: links and runs without std and alloc; both negative controls fail as they must"
done
