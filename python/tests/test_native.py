"""The compiled module: the same numbers on every processor, threads, and what a type checker reads."""

import ast
import hashlib
import inspect
import os
import threading
from pathlib import Path

import pytest

import unietp
from unietp import _native

DIGEST = """
import hashlib, json, sys
import unietp
digest = hashlib.sha256()
env = unietp.make(sys.argv[1], "M1", image_width=64, image_height=64)
for _ in range(6):
    env.action_space.seed(1)
    observation, info = env.reset()
    for _ in range(15):
        for array in observation.values():
            digest.update(array.tobytes())
        digest.update(json.dumps(env.scene()).encode())
        observation, *_ = env.step(env.action_space.sample())
print(digest.hexdigest())
"""
OLD_PROCESSOR = "glibc.cpu.hwcaps=-AVX2,-FMA,-AVX2_Usable,-FMA_Usable"


def test_the_libraries_call_our_mathematical_functions():
    rows = _native.math_bindings()
    libraries = {library.split(".so")[0] for library, _, _ in rows}
    assert {"libBulletCollision-float64", "libBulletDynamics-float64", "libfcl", "libembree3"} <= libraries
    assert {"sin", "cos", "pow", "sinf"} <= {function for _, function, _ in rows}
    assert not [(library, function) for library, function, own in rows if not own]


def test_other_variants_of_the_c_library_give_the_same_bytes(folder, run_python):
    assert run_python(DIGEST, str(folder)) == run_python(DIGEST, str(folder), GLIBC_TUNABLES=OLD_PROCESSOR)


def test_a_preloaded_allocator_does_no_harm(folder, run_python):
    allocator = Path("/usr/lib/x86_64-linux-gnu/libmimalloc.so.2")
    if not allocator.exists():
        pytest.skip(f"needs {allocator}")
    assert run_python(DIGEST, str(folder), LD_PRELOAD=str(allocator)) == run_python(DIGEST, str(folder))


def test_the_module_brings_no_allocator_of_its_own():
    loaded = Path("/proc/self/maps").read_text()
    assert "libBulletDynamics" in loaded and "mimalloc" not in loaded


def test_native_work_leaves_the_interpreter_free(folder):
    env = unietp.make(folder, "M1", image_width=2000, image_height=2000)
    env.reset(seed=1)
    ticks, done = 0, threading.Event()

    def step():
        for _ in range(3):
            env.step("turn_left()")
        done.set()

    worker = threading.Thread(target=step)
    worker.start()
    while not done.is_set():
        ticks += 1
        done.wait(0.001)
    worker.join()
    assert ticks > 20  # with the lock held, this thread would wait for each step to end


def test_threads_may_share_an_environment(folder):
    env = unietp.make(folder, "M1", picture=False, failures=5000, steps=5000)
    env.reset(seed=1)
    threads = [threading.Thread(target=lambda: [env.step("turn_left()") for _ in range(50)]) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert env.observe()["step"] == 200


def test_the_stub_names_all_that_the_module_has():
    stub = Path(_native.__file__).parent / "_native.pyi"
    named = {node.name for node in ast.parse(stub.read_text()).body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
    public = {name for name in dir(_native) if not name.startswith("_")}
    assert public == named and (stub.parent / "py.typed").exists()


def test_everything_public_is_explained():
    for name in unietp.__all__:
        thing = getattr(unietp, name)
        if inspect.isclass(thing) or inspect.isfunction(thing):
            assert inspect.getdoc(thing), name
        if inspect.isclass(thing) and thing.__module__.startswith("unietp.") and name != "Snapshot":
            for member, value in vars(thing).items():
                if not member.startswith("_") and inspect.isfunction(value):
                    assert inspect.getdoc(value), f"{name}.{member}"


def test_memory_stays_flat_over_resets(folder):
    env = unietp.make(folder, "M2", picture=False)

    def resident():
        return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGESIZE") / 2**20

    for i in range(100):
        env.reset(options={"index": i % 24})
    before = resident()
    for i in range(1500):
        env.reset(options={"index": i % 24})
        env.step("turn_left()")
    assert resident() - before < 12, "MB more after 1,500 resets"


def test_digests_notice_a_difference(folder, run_python):
    other = DIGEST.replace("seed(1)", "seed(2)")
    assert run_python(DIGEST, str(folder)) != run_python(other, str(folder))
    assert len(hashlib.sha256().hexdigest()) == len(run_python(DIGEST, str(folder)).strip())
