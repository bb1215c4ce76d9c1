"""What pixels hold besides color, and pictures from other places than the agent's eye."""

import struct
import zlib

import numpy as np
import pytest

import unietp

SIZE = (96, 72)


@pytest.fixture
def env(folder):
    env = unietp.make(folder, "M1")
    env.reset(options={"index": 0})
    return env


def png_values(path) -> np.ndarray:
    """The samples of a PNG, rows from the top."""
    data = path.read_bytes()
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at : at + 8])
        if kind == b"IHDR":
            width, height, bits, colors = struct.unpack(">IIBB", data[at + 8 : at + 18])
        if kind == b"IDAT":
            packed += data[at + 8 : at + 8 + length]
        at += 12 + length
    step = bits // 8 * {0: 1, 2: 3}[colors]
    raw, rows, above = zlib.decompress(packed), [], bytes(width * step)
    for y in range(height):
        start = y * (width * step + 1)
        method, row = raw[start], bytearray(raw[start + 1 : start + 1 + width * step])
        for i in range(len(row)):
            left, corner = (row[i - step], above[i - step]) if i >= step else (0, 0)
            guess = left + above[i] - corner
            paeth = min((left, above[i], corner), key=lambda one: abs(guess - one))
            row[i] = (row[i] + (0, left, above[i], (left + above[i]) // 2, paeth)[method]) % 256
        rows.append(bytes(row))
        above = rows[-1]
    return np.frombuffer(b"".join(rows), ">u2" if bits == 16 else np.uint8).reshape(height, width, -1)


@pytest.mark.parametrize("camera", ["agent", "behind", "above"])
def test_shapes_and_meaning(env, camera):
    seen = env.channels(camera, SIZE)
    assert {name: (array.dtype, array.shape) for name, array in seen.items() if name != "ids"} == {
        "color": (np.uint8, (72, 96, 3)), "depth": (np.float32, (72, 96)),
        "normals": (np.float32, (72, 96, 3)), "instances": (np.int32, (72, 96)),
    }
    assert (seen["depth"] > 0).all()
    lengths = np.linalg.norm(seen["normals"], axis=2)
    assert np.allclose(lengths[np.isfinite(seen["depth"])], 1, atol=1e-5)
    shown = {seen["ids"][number] for number in np.unique(seen["instances"])}
    assert ("agent" in shown) == (camera != "agent")
    assert shown <= {"", "agent"} | {node["id"] for node in env.scene()["nodes"]}


def test_instances_are_those_of_the_boxes(env):
    for furniture in env.observe()["furniture"]:
        env.step(f"go_to({furniture['id']})")
        if len(env.observe()["boxes"]) > 3:
            break
    height, width, _ = env.observe()["image"].shape
    seen = env.channels(size=(width, height))
    assert np.array_equal(seen["color"], env.observe()["image"])
    boxes = env.observe()["boxes"]
    equal = 0
    for thing in boxes:
        ys, xs = np.nonzero(seen["instances"] == seen["ids"].index(thing["id"]))
        if not len(xs):
            continue  # seen through glass alone
        x0, y0, x1, y1 = thing["box"]
        assert x0 <= xs.min() and xs.max() <= x1 and y0 <= ys.min() and ys.max() <= y1
        equal += [xs.min(), ys.min(), xs.max(), ys.max()] == [x0, y0, x1, y1]
    assert boxes and equal >= len(boxes) / 2


def test_the_program_writes_the_same_numbers(env, folder, tmp_path):
    seen = env.channels("behind", SIZE)
    task = unietp.load_dataset(folder)[0].id
    written = {}
    for channel in ("color", "depth", "normals", "instances"):
        out = tmp_path / f"{channel}.png"
        unietp.run_program(
            "render", folder, task, "--out", out, "--camera", "behind", "--channel", channel, "--size", "96x72"
        )
        written[channel] = png_values(out)
    assert np.array_equal(written["color"], seen["color"])
    assert np.array_equal(written["instances"][..., 0], seen["instances"])
    depth = np.where(seen["depth"] < 65.535, np.round(1000 * seen["depth"].astype(float)), 0)
    assert np.abs(written["depth"][..., 0] - depth).max() == 0
    assert np.abs(written["normals"] - (seen["normals"].astype(float) + 1) * 127.5).max() <= 0.5


def test_render_takes_the_camera_that_was_asked_for(folder):
    frames = []
    for camera in ("agent", "behind", "above"):
        env = unietp.make(folder, "M1", picture=False, render_mode="rgb_array", render_camera=camera)
        env.reset(options={"index": 0})
        frames.append(env.render().tobytes())
        assert env.unwrapped.clone().render().tobytes() == frames[-1]
    assert len(set(frames)) == 3
    with pytest.raises(unietp.Error, match="behind"):
        unietp.make(folder, render_camera="below")


def test_wrong_cameras_and_sizes_are_refused(env):
    with pytest.raises(unietp.Error, match="camera"):
        env.channels("below")
    with pytest.raises(unietp.Error, match="size"):
        env.channels(size=(8, 8))


def test_observations_have_the_channels_that_were_asked_for(folder):
    env = unietp.make(folder, "M3", image_width=64, image_height=48, channels=["depth", "normals"], picture=False)
    observation, info = env.reset(options={"index": 1})
    assert observation in env.observation_space
    seen = env.unwrapped.channels()
    assert np.array_equal(observation["depth"], seen["depth"]) and observation["depth"].shape == (48, 64)
    assert np.allclose(observation["normals"], seen["normals"], atol=1e-6)
    assert np.array_equal(info["observation"]["depth"], seen["depth"])
    after, *_ = env.step("turn_left()")
    assert not np.array_equal(after["depth"], observation["depth"])
    assert "depth" not in unietp.make(folder, "M3").observation_space.spaces
    for wrong in (["instances"], "depth", ["color"]):
        with pytest.raises(unietp.Error, match="channels"):
            unietp.make(folder, channels=wrong)


def test_channels_of_smaller_pictures_are_framed(folder):
    env = unietp.make(folder, "M1", channels=["depth"])
    for index in range(4):
        observation, info = env.reset(options={"index": index})
        height, width, _ = info["observation"]["image"].shape
        assert observation in env.observation_space
        assert info["observation"]["depth"].shape == (height, width)
        assert not observation["depth"][height:].any() and not observation["depth"][:, width:].any()
