"""Verified embodied-planning tasks, and an environment to act in them.

    import unietp
    env = unietp.make("out/first-benchmark", mode="M2")
    observation, info = env.reset(seed=1)
    observation, reward, terminated, truncated, info = env.step("stop()")

`make` gives a `gymnasium.Env`, `make_vec` a `gymnasium.vector.VectorEnv` that steps many environments on several threads,
`load_dataset` the tasks, demonstrations and homes of a data set, and `generate` and `validate` run the program.
Importing the package registers "unietp/M1-v0", "unietp/M2-v0" and "unietp/M3-v0" with Gymnasium.
"""

from unietp._native import Error, build
from unietp._native import version as _version
from unietp.dataset import Dataset, Demonstration, DemonstrationStep, TaskLine, load_dataset
from unietp.environment import Snapshot, TaskEnv
from unietp.making import complete_settings, make, make_vec, register
from unietp.program import ProgramError, generate, run_program, validate
from unietp.vector import VectorTaskEnv

__version__ = _version()
__all__ = [
    "Dataset", "Demonstration", "DemonstrationStep", "Error", "ProgramError", "Snapshot", "TaskEnv", "TaskLine",
    "VectorTaskEnv", "__version__", "build", "complete_settings", "generate", "load_dataset", "make", "make_vec",
    "run_program", "validate",
]

register()
