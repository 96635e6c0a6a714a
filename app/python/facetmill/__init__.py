"""Facetmill's core: meshes, cutters, lifts, projects planned and verified, studies.

Lengths are millimetres and angles radians; arrays are NumPy's. What takes a while lets other threads run, ends
with Ctrl-C, and takes a Job that another thread may cancel.
"""
from ._core import (
    Cancelled,
    Cutter,
    DropCutter,
    Error,
    Job,
    Mesh,
    Plan,
    Project,
    Verification,
    __version__,
    load_mesh,
    load_project,
    run_study,
    sample,
    set_threads,
)

__all__ = [
    "Cancelled", "Cutter", "DropCutter", "Error", "Job", "Mesh", "Plan", "Project", "Verification", "load_mesh",
    "load_project", "run_study", "sample", "set_threads",
]
