"""What the judge says of a plan, and how much stands where."""
import json
import os
import pathlib
import subprocess
import numpy as np
import facetmill

verification = facetmill.load_project("job.facetmill").plan().verify()
highest = np.argmax(verification.deviation)
print(verification.verdict, "- most stands at", verification.points[highest])
verification.write("verified")

subprocess.run([os.environ["FACETMILL_CLI"], "simulate", "job.facetmill", "-o", "by_cli"], check=True, stdout=subprocess.DEVNULL)
for name in ("stock.stl", "deviation.vtp"):
    assert pathlib.Path("verified", name).read_bytes() == pathlib.Path("by_cli", name).read_bytes(), name
by_cli = json.loads(pathlib.Path("by_cli/verify.json").read_text())
assert verification.verdict == by_cli["verdict"] == "verified"
assert verification.json["excess_max"] == by_cli["excess_max"]
