"""SFTTrainer of TRL trains on what the assistant said in the chats of the SFT export, and the check of that can fail."""

import json
import sys
from pathlib import Path

import datasets
import pytest
from test_trl import byte_tokenizer
from transformers import Qwen3Config, Qwen3ForCausalLM
from trl import SFTConfig, SFTTrainer

import unietp

sys.path.insert(0, str(Path(__file__).parents[2] / "training"))
from chat_masks import TEMPLATE, WrongMask, check_masks  # noqa: E402


@pytest.fixture(scope="module")
def chats(folder, tmp_path_factory):
    out = tmp_path_factory.mktemp("sft") / "chats"
    unietp.run_program("export", folder, "--format", "sft", "--modes", "M1", "--unit", "step", "--out", out)
    rows = [json.loads(line)["messages"] for line in (out / "M1.jsonl").read_text().splitlines()[:8]]
    return [[{"role": one["role"], "content": one["content"]} for one in messages] for messages in rows]


def trainer(chats, template, folder, steps=1):
    tokenizer = byte_tokenizer()
    tokenizer.chat_template = template
    config = Qwen3Config(
        vocab_size=len(tokenizer), hidden_size=16, intermediate_size=16, num_hidden_layers=1, num_attention_heads=1,
        num_key_value_heads=1, head_dim=16, max_position_embeddings=65536, tie_word_embeddings=True,
        eos_token_id=tokenizer.eos_token_id, pad_token_id=tokenizer.pad_token_id,
    )
    return SFTTrainer(
        model=Qwen3ForCausalLM(config),
        processing_class=tokenizer,
        train_dataset=datasets.Dataset.from_list([{"messages": messages} for messages in chats]),
        args=SFTConfig(
            output_dir=str(folder), per_device_train_batch_size=1, max_steps=steps, use_cpu=True, logging_steps=1, learning_rate=0.02,
            max_length=None, assistant_only_loss=True, report_to="none", save_strategy="no", bf16=False, gradient_checkpointing=False,
        ),
    )


def checked(made, chats):
    return check_masks(made.processing_class, chats, made.data_collator, list(made.train_dataset))


def test_only_what_the_assistant_said_is_trained_on_and_the_loss_falls(chats, tmp_path):
    made = trainer(chats, TEMPLATE, tmp_path, steps=16)
    assert checked(made, chats) == sum(len(messages[-1]["content"].encode()) + 1 for messages in chats)
    made.train()
    losses = [row["loss"] for row in made.state.log_history if "loss" in row]
    assert sum(map(float, losses[-4:])) < 0.8 * sum(map(float, losses[:4]))


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ("{% generation %}{{ message['content']", "{% generation %}{{ 'assistant\n' + message['content']"),
        ("+ '<|im_end|>' }}{% endgeneration %}", "}}{% endgeneration %}{{ '<|im_end|>' }}"),
        ("{{ '<|im_start|>' + message['role']", "{% generation %}{{ '!' }}{% endgeneration %}{{ '<|im_start|>' + message['role']"),
    ],
    ids=["more than the answer", "not its end", "what others said"],
)
def test_another_mask_is_noticed(chats, tmp_path, right, wrong):
    assert right in TEMPLATE
    with pytest.raises(WrongMask):
        checked(trainer(chats, TEMPLATE.replace(right, wrong), tmp_path), chats)
