"""Serves a model of transformers as OpenAI's chat completions on this machine; requests that come together are one batch."""

import json
import queue
import threading
from collections.abc import Iterator
from concurrent.futures import Future
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any, NamedTuple

import torch


class Answer(NamedTuple):
    text: str
    ended: bool  # by itself
    read: int  # tokens of the prompt
    written: int


class Request(NamedTuple):
    messages: list[dict[str, str]]
    max_tokens: int  # of the answer


def answers(model: Any, tokenizer: Any, requests: list[Request]) -> list[Answer]:
    """The likeliest answer to each request."""
    told = tokenizer.apply_chat_template(
        [request.messages for request in requests], add_generation_prompt=True, return_tensors="pt", return_dict=True, padding=True,
        tokenizer_kwargs={"padding_side": "left"},
    ).to(model.device)
    longest = max(request.max_tokens for request in requests)
    with torch.no_grad():
        said = model.generate(**told, max_new_tokens=longest, do_sample=False)[:, told["input_ids"].shape[1]:].tolist()
    found = []
    for request, tokens, mask in zip(requests, said, told["attention_mask"], strict=True):
        tokens = tokens[:request.max_tokens]
        ended = tokenizer.eos_token_id in tokens
        tokens = tokens[:tokens.index(tokenizer.eos_token_id) + 1] if ended else tokens
        found.append(Answer(tokenizer.decode(tokens, skip_special_tokens=True), ended, int(mask.sum()), len(tokens)))
    return found


@contextmanager
def served(model: Any, tokenizer: Any, name: str, at_once: int) -> Iterator[str]:
    """Gives the address for --llm-url."""
    asked: queue.Queue[tuple[Request, Future[Answer]]] = queue.Queue()

    def work() -> None:
        while True:
            batch = [asked.get()]
            while len(batch) < at_once:
                try:
                    batch.append(asked.get(timeout=0.2))
                except queue.Empty:
                    break
            try:
                for (_, future), one in zip(batch, answers(model, tokenizer, [request for request, _ in batch]), strict=True):
                    future.set_result(one)
            except Exception as error:  # told to those who wait
                for _, future in batch:
                    future.set_exception(error)

    class Handler(BaseHTTPRequestHandler):
        def do_POST(self) -> None:
            request = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
            if "max_tokens" not in request:
                self.send_error(400, "max_tokens is missing")
                return
            future: Future[Answer] = Future()
            asked.put((Request(request["messages"], request["max_tokens"]), future))
            one = future.result()
            choice = {"index": 0, "message": {"role": "assistant", "content": one.text}, "finish_reason": "stop" if one.ended else "length"}
            usage = {"prompt_tokens": one.read, "completion_tokens": one.written, "total_tokens": one.read + one.written}
            body = json.dumps({"object": "chat.completion", "model": name, "choices": [choice], "usage": usage}).encode()
            self.send_response(200)
            self.send_header("Content-Type", "application/json")
            self.send_header("Content-Length", str(len(body)))
            self.end_headers()
            self.wfile.write(body)

        def log_message(self, *_: Any) -> None:
            pass

    threading.Thread(target=work, daemon=True).start()
    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    try:
        yield f"http://127.0.0.1:{server.server_port}/v1"
    finally:
        server.shutdown()
        thread.join()
