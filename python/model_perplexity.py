"""Measures how expected each line of a file is to a small language model (SmolLM2-135M-Instruct, through llama.cpp).

    python/venv model
    build/python-model/bin/python python/model_perplexity.py texts.txt > texts.tsv

Writes a line for each non-empty line of the file, in order: tokens, perplexity, text. The perplexity is exp of the mean
negative log probability (nats) of the text's tokens, each given those before it and the token of a beginning. The same file
gives the same numbers on one machine; another processor may differ in the last digits.
"""

import argparse
import pathlib

import numpy

from model_server import shipped_model

LONGEST = 1024  # tokens of a text that count
BEGINNING = 0  # <|endoftext|>, which stands between the texts that SmolLM2 was trained on


def log_probabilities(context, tokens: list[int]) -> numpy.ndarray:
    """Of tokens 1 to n-1, each given those before it, in nats; shape (n-1,)."""
    from ik_llama_cpp import _ctypes_api
    from ik_llama_cpp._internals import make_batch

    context.kv_cache_clear()
    batch = make_batch(tokens)
    for place in range(len(tokens)):
        batch.logits[place] = 1
    try:
        if context.decode(batch) != 0:
            raise RuntimeError("llama.cpp could not evaluate a text")
    finally:
        _ctypes_api.llama_batch_free(batch)
    found = []
    for place, token in enumerate(tokens[1:]):
        logits = numpy.ctypeslib.as_array(context.get_logits(place), shape=(context.model.n_vocab,)).astype(numpy.float64)
        highest = logits.max()
        found.append(logits[token] - highest - numpy.log(numpy.exp(logits - highest).sum()))
    return numpy.array(found)


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("texts", type=pathlib.Path, help="one text a line")
    options.add_argument("--model", type=pathlib.Path, help="a GGUF file (default: SmolLM2-135M-Instruct)")
    options.add_argument("--threads", type=int, default=2)
    chosen = options.parse_args()

    from ik_llama_cpp._internals import IkContext, IkModel

    model = IkModel(str(chosen.model or shipped_model()))
    context = IkContext(model, n_ctx=LONGEST, n_threads=chosen.threads, flash_attn=False)
    for text in chosen.texts.read_text(encoding="utf-8").splitlines():
        if not text.strip():
            continue
        tokens = [BEGINNING, *model.tokenize(text.strip(), add_bos=False)][:LONGEST]
        mean = -log_probabilities(context, tokens).mean()
        print(f"{len(tokens) - 1}\t{numpy.exp(mean):.2f}\t{text.strip()}")


if __name__ == "__main__":
    main()
