"""One setting after the other, and what goes wrong."""
import facetmill

project = facetmill.load_project("job.facetmill")
seconds = []
for tolerance in (0.1, 0.2, 0.4):
    project.set(f"Finish.tolerance={tolerance}")
    seconds.append(project.plan().report["operations"][0]["time_seconds"])
print(seconds)
assert seconds[0] > seconds[1] > seconds[2]

try:
    project.set("Finish.tolerance=-1")
    raise SystemExit("it was taken")
except facetmill.Error as error:
    assert error.code == "out_of_range" and "tolerance" in error.where
