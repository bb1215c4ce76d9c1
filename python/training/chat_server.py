"""Serves a model of transformers as OpenAI's chat completions on this machine, one request at a time."""

import json
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, HTTPServer
from typing import Any

import torch


def answer(model: Any, tokenizer: Any, messages: list[dict[str, str]], most_tokens: int) -> tuple[str, bool, int, int]:
    """The likeliest answer: its text, whether it ended by itself, and the tokens of prompt and answer."""
    told = tokenizer.apply_chat_template(messages, add_generation_prompt=True, return_tensors="pt", return_dict=True)
    told = told.to(model.device)
    length = told["input_ids"].shape[1]
    with torch.no_grad():
        said = model.generate(**told, max_new_tokens=most_tokens, do_sample=False)[0][length:]
    ended = bool((said == tokenizer.eos_token_id).any())
    return tokenizer.decode(said, skip_special_tokens=True), ended, length, len(said)


@contextmanager
def served(model: Any, tokenizer: Any, name: str, most_tokens: int = 64) -> Iterator[str]:
    """Gives the address for --llm-url."""

    class Handler(BaseHTTPRequestHandler):
        def do_POST(self) -> None:
            asked = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
            tokens = min(asked.get("max_tokens", most_tokens), most_tokens)
            text, ended, read, written = answer(model, tokenizer, asked["messages"], tokens)
            choice = {"index": 0, "message": {"role": "assistant", "content": text}, "finish_reason": "stop" if ended else "length"}
            usage = {"prompt_tokens": read, "completion_tokens": written, "total_tokens": read + written}
            body = json.dumps({"object": "chat.completion", "model": name, "choices": [choice], "usage": usage}).encode()
            self.send_response(200)
            self.send_header("Content-Type", "application/json")
            self.send_header("Content-Length", str(len(body)))
            self.end_headers()
            self.wfile.write(body)

        def log_message(self, *_: Any) -> None:
            pass

    server = HTTPServer(("127.0.0.1", 0), Handler)
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    try:
        yield f"http://127.0.0.1:{server.server_port}/v1"
    finally:
        server.shutdown()
        thread.join()
