# Shared by packaging/run and packaging/test: installs what is missing, configures and builds. Sourced, not run.

facetmill_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf '\n== %s\n' "$*" >&2; }

# listed FILE: the packages that a list in this folder names
listed() { grep -vE '^[[:space:]]*(#|$)' "$facetmill_root/packaging/$1"; }

# missing_of PACKAGE ...: those of them that are not installed
missing_of() {
    local package
    for package; do
        dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || echo "$package"
    done
}

# install_missing [PACKAGE ...]: those, or all of both lists
install_missing() {
    local wanted=("$@") missing=()
    [ $# -gt 0 ] || mapfile -t wanted < <(listed packages-core.txt && listed packages.txt)
    mapfile -t missing < <(missing_of "${wanted[@]}")
    [ ${#missing[@]} -eq 0 ] && return 0
    say "Installing: ${missing[*]}"
    local sudo=()
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || {
            echo "packages are missing (${missing[*]}): run as root, or install sudo" >&2
            exit 1
        }
        sudo=(sudo)
    fi
    export DEBIAN_FRONTEND=noninteractive
    "${sudo[@]}" apt-get update -q
    "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"
}

# build PRESET [TARGET ...]; the array build_options has what the configuration is told beyond its preset.
build_options=()
build() {
    local preset=$1
    shift
    say "Building ($preset)"
    (cd "$facetmill_root" && cmake --preset "$preset" "${build_options[@]}" && cmake --build --preset "$preset" ${1:+--target "$@"})
}
