"""A stand-in for Magnum's Python bindings: what habitat-lab's sim_utilities and act_habitat.py use of them, by NumPy."""

from types import SimpleNamespace

import numpy


class Vector3(numpy.ndarray):
    def __new__(cls, x=0.0, y=None, z=None):
        values = [x] * 3 if y is None and numpy.ndim(x) == 0 else x if y is None else [x, y, z]
        return numpy.array(values, dtype=float).view(cls)

    @classmethod
    def x_axis(cls):
        return cls(1, 0, 0)

    @classmethod
    def y_axis(cls):
        return cls(0, 1, 0)

    @classmethod
    def z_axis(cls):
        return cls(0, 0, 1)

    def length(self):
        return float(numpy.linalg.norm(self))

    def normalized(self):
        return self / self.length()

    def projected_onto_normalized(self, line):
        return line * float(numpy.dot(self, line))


class Range3D:
    def __init__(self, low, high):
        self.min, self.max = Vector3(low), Vector3(high)

    def center(self):
        return (self.min + self.max) / 2


def _corner(back, bottom, left):
    def corner(box):
        x, y, z = (box.min, box.max)[not left], (box.min, box.max)[not bottom], (box.min, box.max)[not back]
        return Vector3(x[0], y[1], z[2])

    return property(corner)


for _back in (True, False):
    for _bottom in (True, False):
        for _left in (True, False):
            _name = f"{'back' if _back else 'front'}_{'bottom' if _bottom else 'top'}_{'left' if _left else 'right'}"
            setattr(Range3D, _name, _corner(_back, _bottom, _left))


class Matrix4:
    """Made of columns, as Magnum's are."""

    def __init__(self, columns):
        self.rows = numpy.array(columns, dtype=float).T

    @classmethod
    def of_rows(cls, rows):
        return cls(numpy.asarray(rows).T)

    @classmethod
    def identity_init(cls):
        return cls(numpy.eye(4))

    @classmethod
    def from_(cls, turn, translation):
        rows = numpy.eye(4)
        rows[:3, :3], rows[:3, 3] = turn, translation
        return cls.of_rows(rows)

    @property
    def translation(self):
        return Vector3(self.rows[:3, 3])

    def rotation(self):
        return self.rows[:3, :3]

    def inverted(self):
        return Matrix4.of_rows(numpy.linalg.inv(self.rows))

    def __matmul__(self, other):
        return Matrix4.of_rows(self.rows @ other.rows)

    def transform_point(self, point):
        return Vector3(self.rows[:3, :3] @ point + self.rows[:3, 3])


class Quaternion:
    def __init__(self, vector, scalar):
        self.vector, self.scalar = Vector3(vector), scalar

    def to_matrix(self):
        (x, y, z), w = self.vector, self.scalar
        return numpy.array([
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ])  # fmt: skip


math = SimpleNamespace(
    min=lambda a, b: Vector3(numpy.minimum(a, b)), max=lambda a, b: Vector3(numpy.maximum(a, b)), dot=lambda a, b: float(numpy.dot(a, b))
)
