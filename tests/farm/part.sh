# Sourced by the parts of the farm tests, which are called with the folder of a build and one of
# their own: the scene, the scripts of docs/farm.md, and how to wait and to compare.
set -euo pipefail

build=$1 farm=$2
docs=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../docs" && pwd)/farm.md
export PATH=$build/io:$PATH
# Open MPI refuses the administrator, and more ranks than processors.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_hwloc_base_binding_policy=none
cd "$farm"

fail() {
  echo "farm: ${0##*/}: $*" >&2
  grep -hiE "job|error" slurm/slurmctld.log 2>/dev/null | tail -n 20 >&2; tail -n 5 slurm-*.out >&2; exit 1
}

# Waits until a command succeeds; false where that takes longer than so many seconds.
until_true() { # SECONDS COMMAND…
  local end=$((SECONDS + $1))
  shift
  until "$@"; do
    ((SECONDS < end)) || return 1
    sleep 0.2
  done
}
wait_for() { # SECONDS WHAT COMMAND…
  local seconds=$1 what=$2
  shift 2
  until_true "$seconds" "$@" || fail "after $seconds s: not $what"
}
same() { cmp "$1" "$2" || fail "$1 has not the bytes of $2"; }

# Light paths, their map and their splats; parts of a multiple of 16 samples.
samples=128
write_scene() {
  cat >scene.sdl <<'SCENE'
imageSize 120 90 bands 27 integrator path eye 0 1.2 5 fieldOfView 40
background 0.1 0.1 0.2
falloff square intensity 4 light E 1 3 2 1
defaultMaterials diffuse 0.7 0.7 0.7
push rotate -90 1 0 0 scale 4 4 1 square pop
glass N-SF11 push translate 0 0.8 0 scale 0.7 0.7 0.7 sphere pop
SCENE
}

# The script of that name in docs/farm.md, for this scene and so many parts, with its state kept each
# second.
docs_script() { # NAME PARTS
  sed -n "/\`$1\`:\$/,/^\`\`\`\$/p" "$docs" | sed '1,/^```bash$/d; /^```$/d' |
    sed "s/--spp 1024/--spp $samples --threads 1 --checkpoint-every 1/; s|/8\"|/${2:-1}\"|" >"$1"
  grep -q '^#!' "$1" || fail "docs/farm.md has no script $1"
}
# The lines of docs/farm.md that begin with four spaces and have this text in them.
docs_lines() { # TEXT
  grep "^    .*$1" "$docs" || fail "docs/farm.md has no line with $1"
}
