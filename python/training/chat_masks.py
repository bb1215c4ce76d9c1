"""Which tokens of a chat are trained on: the assistant's answers and the mark that ends each, nothing else."""

from collections.abc import Iterable, Mapping
from typing import Any

END = "<|im_end|>"

# The template of SmolLM2's chats with the marks by which TRL finds what the assistant said.
TEMPLATE = (
    "{% for message in messages %}"
    "{% if message['role'] == 'assistant' %}"
    "{{ '<|im_start|>assistant\n' }}{% generation %}{{ message['content'] + '<|im_end|>' }}{% endgeneration %}{{ '\n' }}"
    "{% else %}"
    "{{ '<|im_start|>' + message['role'] + '\n' + message['content'] + '<|im_end|>\n' }}"
    "{% endif %}"
    "{% endfor %}"
    "{% if add_generation_prompt %}{{ '<|im_start|>assistant\n' }}{% endif %}"
)


class WrongMask(Exception):
    """Other tokens are trained on than the assistant's."""


def spelled(messages: Iterable[Mapping[str, str]]) -> str:
    """A chat as the model reads it, written without the template."""
    return "".join(f"<|im_start|>{message['role']}\n{message['content']}{END}\n" for message in messages)


def check_masks(tokenizer: Any, chats: Iterable[Iterable[Mapping[str, str]]], collate: Any, rows: Iterable[Any]) -> int:
    """Compares what a trainer trains on with the chats themselves, one by one.

    `rows` are the trainer's, in the order of `chats`; `collate` makes a batch of one row as training does, with -100 in
    `labels` for what is not trained on. Returns how many tokens are trained on. Raises WrongMask with the chat's number
    if the tokens are not the chat, or the trained ones are not the assistant's answers with their ends.
    """
    trained = 0
    for number, (messages, row) in enumerate(zip(chats, rows, strict=True), 1):
        messages = list(messages)
        batch = collate([row])
        ids, labels = batch["input_ids"][0].tolist(), batch["labels"][0].tolist()
        if tokenizer.decode(ids) != spelled(messages):
            raise WrongMask(f"chat {number}: its tokens are not the chat")
        if any(label not in (-100, token) for token, label in zip(ids, labels, strict=True)):
            raise WrongMask(f"chat {number}: a label is not the token itself")
        learned = tokenizer.decode([label for label in labels if label != -100])
        answers = "".join(message["content"] + END for message in messages if message["role"] == "assistant")
        if learned != answers:
            raise WrongMask(f"chat {number}: trained on {learned[:200]!r}, but the assistant said {answers[:200]!r}")
        trained += sum(label != -100 for label in labels)
    return trained
