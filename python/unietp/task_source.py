"""Where the tasks of an environment come from."""

from dataclasses import dataclass, field

from unietp import _native
from unietp._native import Error


@dataclass
class TaskSource:
    """The tasks of a data set, one of them, or new ones without end. Shared by environments of all threads."""

    native: _native.EpisodeTasks
    catalog: _native.Catalog
    extended: bool  #: agents have the profile `wide`
    single: int | None = None  #: position of the one task
    listing: list[dict[str, str]] = field(default_factory=list)  #: of a data set: id, split, simulator, ... of each task

    def __post_init__(self) -> None:
        if not self.listing:
            self.listing = self.native.listing()

    def only(self, id: str) -> "TaskSource":
        """The same with one task. Raises Error when no task has the id."""
        return TaskSource(self.native, self.catalog, self.extended, self.position(id), self.listing)

    def position(self, id: str) -> int:
        """Where a task stands in the data set."""
        for position, row in enumerate(self.listing):
            if row["id"] == id:
                return position
        raise Error(f"no task has the id {id!r}")

    @property
    def image_size(self) -> tuple[int, int]:
        """The largest width and height of the cameras of the simulators that there are tasks for."""
        names = {row["simulator"] for row in self.listing} or {"ai2thor", "virtualhome", "habitat", "behavior"}
        sizes = [self.catalog.image_size(name) for name in names]
        return max(width for width, _ in sizes), max(height for _, height in sizes)

    def task_of_episode(self, seed: int | None, episode: int) -> _native.Task:
        """The task of an episode, counted from 0: in the order of the file, or of a seed."""
        if self.single is not None:
            return self.native.task(self.single)
        return self.native.task_of_episode(seed, episode)

    def task(self, options: dict[str, object]) -> _native.Task:
        """The task that options of `reset` name: {"task": id} or {"index": position, or seed of a new task}."""
        if not isinstance(options, dict):
            raise Error('expected the options {"task": ID} or {"index": NUMBER}')
        if options.keys() == {"task"} and isinstance(options["task"], str):
            return self.native.task(self.position(options["task"]))
        index = options.get("index")
        if options.keys() == {"index"} and type(index) is int and 0 <= index < 2**53:
            if not self.listing or index < len(self.listing):
                return self.native.task(index)
            raise Error(f"there is no task {index}; the data set has {len(self.listing)}")
        raise Error('expected the options {"task": ID} or {"index": NUMBER}')
