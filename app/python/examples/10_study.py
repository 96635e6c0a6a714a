"""A study: which direction and tolerance take the least time and leave no more than they may."""
import json
import pathlib
import facetmill

pathlib.Path("job.study.json").write_text(json.dumps({
    "study": 1, "project": "job.facetmill", "want": ["machining_time"], "limits": {"excess_p99": 0.3},
    "vary": [{"path": "operations[Finish].direction", "values": ["x", "y"]},
             {"path": "operations[Finish].tolerance", "values": [0.2, 0.3]}]}))
found = facetmill.run_study("job.study.json")
print(found["winner"]["choice"], found["winner"]["measures"]["machining_time"], "s")

assert found["candidates"] == 4 and pathlib.Path("job.study/table.md").exists()
assert found["winner"]["measures"]["machining_time"] <= found["project"]["measures"]["machining_time"]
