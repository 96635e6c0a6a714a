"""A project planned, and its programs written: the bytes that the command line writes."""
import os
import pathlib
import subprocess
import facetmill

plan = facetmill.load_project("job.facetmill").plan()
files = plan.write("programs")
for operation in plan.report["operations"]:
    print(operation["name"], operation["passes"], "passes,", round(operation["time_seconds"]), "s")

subprocess.run([os.environ["FACETMILL_CLI"], "plan", "job.facetmill", "-o", "by_cli"], check=True, stdout=subprocess.DEVNULL)
for file in map(pathlib.Path, files):
    if file.name != "report.json":  # which tells how long planning took
        assert file.read_bytes() == (pathlib.Path("by_cli") / file.name).read_bytes(), file
assert len(files) > 1
