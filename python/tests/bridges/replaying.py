"""A model that knows the stored demonstrations: the answers of the tests."""

import json
import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

import unietp


def next_step(dataset: unietp.Dataset, mode: str, first_text: str, answers: int) -> unietp.DemonstrationStep:
    """The step that follows `answers` answers in the episode that began with this text."""
    told = [task for task in dataset if task.instruction in first_text]
    task = max(told, key=lambda task: len(task.instruction))
    return dataset.demonstration(task, mode).steps[answers]


class ReplayServer:
    """Speaks as much of the chat-completions protocol as a client needs, on a port of loopback."""

    def __init__(self, dataset: unietp.Dataset, mode: str):
        class Handler(BaseHTTPRequestHandler):
            def do_POST(self):
                request = json.loads(self.rfile.read(int(self.headers["content-length"])))
                said = [message for message in request["messages"] if message["role"] == "assistant"]
                users = [message for message in request["messages"] if message["role"] == "user"]
                content = users[0]["content"]
                text = content if isinstance(content, str) else "".join(part.get("text", "") for part in content)
                answer = json.dumps(next_step(dataset, mode, text, len(said)).command())
                message = {"role": "assistant", "content": answer}
                choice = {"index": 0, "finish_reason": "stop"}
                head = {"id": "replay", "created": 0, "model": request["model"]}
                usage = {"prompt_tokens": 1, "completion_tokens": 1, "total_tokens": 2}
                if request.get("stream"):
                    parts = [
                        {**head, "object": "chat.completion.chunk", "choices": [{**choice, "finish_reason": None, "delta": message}]},
                        {**head, "object": "chat.completion.chunk", "choices": [{**choice, "delta": {}}], "usage": usage},
                    ]
                    body = "".join(f"data: {json.dumps(part)}\n\n" for part in parts) + "data: [DONE]\n\n"
                    kind = "text/event-stream"
                else:
                    whole = {**head, "object": "chat.completion", "choices": [{**choice, "message": message}], "usage": usage}
                    body, kind = json.dumps(whole), "application/json"
                self.send_response(200)
                self.send_header("content-type", kind)
                self.send_header("content-length", str(len(body)))
                self.end_headers()
                self.wfile.write(body.encode())

            def log_message(self, *_):
                pass

        self.server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self.url = f"http://127.0.0.1:{self.server.server_port}/v1"

    def __enter__(self):
        threading.Thread(target=self.server.serve_forever, daemon=True).start()
        return self

    def __exit__(self, *_):
        self.server.shutdown()
        self.server.server_close()
