#!/usr/bin/env bash
# Shows that every shared file reaches both processors: changes one constant in each in turn (scripts/mutations.txt), builds
# the images of `tests/src/shared_image` from the changed text, and demands that in one of them the picture of the CPU and
# the picture of the shader made of that text both change.
#
# It works on a copy of the sources below target/, without optimisation of what is rebuilt, and shares all other build
# results with the workspace. Needs a GPU adapter; a software one will do.
#
#   scripts/mutate-shared.sh            all files
#   scripts/mutate-shared.sh PATTERN    files whose path contains PATTERN
set -euo pipefail
cd "$(dirname "$0")/.."

root=$PWD
copy=$root/target/mutated
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$root/target}
export CARGO_INCREMENTAL=1
export REQUIRE_GPU=1
pattern=${1:-}

# Files that are shared but hold no code: crate and module roots, plain structs, traits without bodies.
has_code() {
    sed '/#\[cfg(test)\]/,$d' "$1" | grep -vE '^\s*(//|fn .*;$)' | grep -qE '\bfn\b|\bconst\b.*=.*[0-9]'
}

# Builds the program that makes the images.
build() {
    (cd "$copy" && cargo build --release --locked --quiet --bin shared-image) >"$copy/build.log" 2>&1 || {
        cat "$copy/build.log" >&2
        return 1
    }
}

# Prints a line for each image: name, hash from the CPU, hash from the GPU.
images() {
    timeout 300 "$CARGO_TARGET_DIR/release/shared-image" 2>"$copy/run.log" || {
        cat "$copy/run.log" >&2
        return 1
    }
}

# The first image of which both hashes are others than before; no more is made after it. Nothing where there is none.
first_changed() {
    local name cpu gpu
    exec 3< <(exec timeout 300 "$CARGO_TARGET_DIR/release/shared-image" 2>"$copy/run.log")
    local maker=$!
    while read -r name cpu gpu <&3; do
        if [ "$cpu" != "${base_cpu[$name]}" ] && [ "$gpu" != "${base_gpu[$name]}" ]; then
            echo "$name"
            break
        fi
    done
    kill "$maker" 2>/dev/null || true
    exec 3<&-
}

rm -rf "$copy"
mkdir -p "$copy"
git ls-files -z --cached --others --exclude-standard | while IFS= read -r -d '' file; do
    # With the time of now: cargo would take a file older than the last change's build for unchanged.
    [ ! -f "$file" ] || cp --parents "$file" "$copy"
done
for package in glimt-probe glimt-sampling glimt-envmap-cdf glimt-brdf glimt-light-cells glimt-smc glimt-sh glimt-render-gpu glimt glimt-generate glimt-tests; do
    printf '\n[profile.release.package.%s]\nopt-level = 0\n' "$package" >>"$copy/Cargo.toml"
done

failures=0
fail() {
    echo "FAILED $1"
    failures=$((failures + 1))
}

mapfile -t shared < <(grep -rl --include='*.rs' '^//! Shared file:' crates | sort)
for file in "${shared[@]}"; do
    if has_code "$file" && ! grep -qF "$file | " scripts/mutations.txt; then
        fail "$file: scripts/mutations.txt says no change for it"
    fi
done

build
base=$(images)
[ "$base" = "$(images)" ] || fail "two runs of the unchanged sources differ"
echo "$base"
declare -A base_cpu base_gpu
while read -r name cpu gpu; do
    base_cpu[$name]=$cpu
    base_gpu[$name]=$gpu
done <<<"$base"
while IFS= read -r line; do
    [[ $line != '#'* && $line == *"$pattern"* ]] || continue
    file=${line%% | *}
    rest=${line#* | }
    from=${rest% | *}
    to=${rest##* | }
    text=$(cat "$copy/$file" && printf x)
    text=${text%x}
    if [[ $text != *"$from"* ]]; then
        fail "$file: there is no '$from'"
        continue
    fi
    before=${text%%"$from"*}
    if [[ ${before##*$'\n'} == *//* ]]; then
        fail "$file: '$from' stands in a comment"
        continue
    fi
    printf %s "${text/"$from"/"$to"}" >"$copy/$file"
    if build; then
        both=$(first_changed)
        if [ -n "$both" ]; then
            echo "$file: '$from' → '$to' changes $both on both processors"
        else
            cat "$copy/run.log" >&2
            fail "$file: '$from' → '$to' changes no image on both processors"
        fi
    else
        fail "$file: does not build with '$to'"
    fi
    printf %s "$text" >"$copy/$file"
done <scripts/mutations.txt

[ "$failures" = 0 ] || {
    echo "$failures shared files are not shown to reach both processors"
    exit 1
}
echo "every shared file reaches both processors"
