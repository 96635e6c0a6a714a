"""The wheel of the Python module, as pip asks for it (PEP 517 and 427), with the standard library alone. CMake builds the package;
FACETMILL_BUILD names a folder where that has been done, else it is done in build/release."""
import base64, hashlib, os, pathlib, re, subprocess, zipfile

ROOT = pathlib.Path(__file__).resolve().parent.parent


def package():
    """The folder of the package as it is imported, and the name of the module in it."""
    build = os.environ.get("FACETMILL_BUILD")
    if not build:
        build = ROOT / "build" / "release"
        subprocess.run(["cmake", "--preset", "release"], cwd=ROOT, check=True)
        subprocess.run(["cmake", "--build", "--preset", "release", "--target", "facetmill_python"], cwd=ROOT, check=True)
    folder = pathlib.Path(build, "app", "python", "facetmill")
    modules = sorted(folder.glob("_core.cpython-*.so"))
    if len(modules) != 1:
        raise SystemExit("facetmill_wheel: there is no module in %s: install python3-dev, python3-numpy and pybind11-dev" % folder)
    return folder, modules[0].name


def version():
    return re.search(r"project\(facetmill VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    folder, module = package()
    # _core.cpython-311-x86_64-linux-gnu.so
    python, machine = re.fullmatch(r"_core\.cpython-(\d+)-(.+)-linux-gnu\.so", module).groups()
    tag = "cp%s-cp%s-linux_%s" % (python, python, machine)
    files = {"facetmill/" + name: (folder / name).read_bytes() for name in ("__init__.py", "__init__.pyi", "py.typed", module)}
    info = "facetmill-%s.dist-info/" % version()
    files[info + "METADATA"] = "\n".join([
        "Metadata-Version: 2.1", "Name: facetmill", "Version: " + version(),
        "Summary: Meshes, cutters, lifts, tool paths planned and verified",
        "Requires-Python: ==%s.%s.*" % (python[0], python[1:]), "Requires-Dist: numpy",
        # The libraries that core is linked with are those of the distribution.
        "Requires-External: Debian 12", "Description-Content-Type: text/markdown", "",
        (ROOT / "app" / "python" / "README.md").read_text()]).encode()
    files[info + "WHEEL"] = ("Wheel-Version: 1.0\nGenerator: facetmill_wheel\nRoot-Is-Purelib: false\nTag: %s\n" % tag).encode()
    files[info + "LICENSE"] = (ROOT / "LICENSE").read_bytes()

    def digest(content):
        return "sha256=" + base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()

    record = "".join("%s,%s,%d\n" % (name, digest(content), len(content)) for name, content in files.items())
    files[info + "RECORD"] = (record + info + "RECORD,,\n").encode()
    name = "facetmill-%s-%s.whl" % (version(), tag)
    os.makedirs(wheel_directory, exist_ok=True)
    with zipfile.ZipFile(os.path.join(wheel_directory, name), "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, content in files.items():
            # The same bytes whenever it is packed.
            entry = zipfile.ZipInfo(path, (1980, 1, 1, 0, 0, 0))
            entry.external_attr = (0o755 if path.endswith(".so") else 0o644) << 16
            wheel.writestr(entry, content, zipfile.ZIP_DEFLATED)
    return name


def get_requires_for_build_wheel(config_settings=None):
    return []
