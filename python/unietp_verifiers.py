"""The name under which verifiers finds the tasks: an id of a taskset is a module without dots."""

from unietp.integrations.verifiers import UnietpEnv, UnietpTaskset

__all__ = ["UnietpEnv", "UnietpTaskset"]
