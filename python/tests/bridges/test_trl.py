"""GRPOTrainer of TRL takes a step of training with a tiny model whose answers are the demonstrations."""

import json
from pathlib import Path

import pytest
import torch
import trl
from replaying import next_step
from tokenizers import Tokenizer, decoders, models, pre_tokenizers
from transformers import PreTrainedTokenizerFast, Qwen3Config, Qwen3ForCausalLM
from trl import GRPOConfig, GRPOTrainer

from unietp.integrations.trl import UnietpEnvironment, environment_factory, train_dataset

SPECIAL = ["<|endoftext|>", "<|im_start|>", "<|im_end|>"]


def byte_tokenizer() -> PreTrainedTokenizerFast:
    """A token for each byte, and Qwen3's template of chats, which calls tools."""
    alphabet = sorted(pre_tokenizers.ByteLevel.alphabet())
    model = models.BPE(vocab={letter: i for i, letter in enumerate(alphabet)}, merges=[])
    bare = Tokenizer(model)
    bare.pre_tokenizer = pre_tokenizers.ByteLevel(add_prefix_space=False)
    bare.decoder = decoders.ByteLevel()
    tokenizer = PreTrainedTokenizerFast(tokenizer_object=bare, pad_token=SPECIAL[0], eos_token=SPECIAL[2])
    tokenizer.add_special_tokens({"additional_special_tokens": SPECIAL[1:2]})
    tokenizer.chat_template = (Path(trl.__file__).parent / "chat_templates" / "qwen3.jinja").read_text()
    return tokenizer


class ReplayModel(Qwen3ForCausalLM):
    """Computes as any model does, and answers with the next step of the demonstration."""

    def generate(self, input_ids, **_):
        answers = [self._answer(ids) for ids in input_ids]
        return torch.cat([input_ids, torch.nn.utils.rnn.pad_sequence(answers, batch_first=True)], dim=1)

    def _answer(self, ids):
        told = self.tokenizer.decode(ids)
        first, *later = told.split("<|im_start|>assistant")[:-1] or [told]
        step = next_step(self.dataset, "M2", first, len(later)) if self.steps_left(first, later) else None
        if step is None:
            return torch.tensor(self.tokenizer.encode("Done.<|im_end|>"))
        call = {"name": "act", "arguments": {"action": step.action, **({"argument": step.args[0]} if step.args else {})}}
        return torch.tensor(self.tokenizer.encode(f"<tool_call>\n{json.dumps(call)}\n</tool_call><|im_end|>"))

    def steps_left(self, first, later):
        told = [task for task in self.dataset if task.instruction in first]
        task = max(told, key=lambda task: len(task.instruction))
        return len(later) < len(self.dataset.demonstration(task, "M2").steps)


@pytest.fixture
def model(dataset):
    tokenizer = byte_tokenizer()
    config = Qwen3Config(
        vocab_size=len(tokenizer), hidden_size=8, intermediate_size=8, num_hidden_layers=1, num_attention_heads=1,
        num_key_value_heads=1, head_dim=8, max_position_embeddings=65536, tie_word_embeddings=True,
        eos_token_id=tokenizer.eos_token_id, pad_token_id=tokenizer.pad_token_id,
    )
    model = ReplayModel(config)
    model.tokenizer, model.dataset = tokenizer, dataset
    return model


def test_the_demonstrations_are_rewarded(folder, dataset, model, tmp_path):
    rows = train_dataset(str(folder)).select([2])
    trainer = GRPOTrainer(
        model=model,
        processing_class=model.tokenizer,
        environment_factory=environment_factory(str(folder), "M2"),
        train_dataset=rows,
        args=GRPOConfig(
            output_dir=str(tmp_path), per_device_train_batch_size=2, num_generations=2, max_steps=1, use_cpu=True,
            max_completion_length=30_000, max_tool_calling_iterations=60, logging_steps=1, report_to="none",
            save_strategy="no", bf16=False, gradient_checkpointing=False,
        ),
    )
    trainer.train()
    [logged] = [row for row in trainer.state.log_history if "reward" in row]
    assert logged["rewards/UnietpEnvironment/mean"] == 1 and logged["reward"] == 1
    assert logged["tools/failure_frequency"] == 0


def test_an_environment_without_deeds_is_not_rewarded(folder, dataset):
    env: UnietpEnvironment = environment_factory(str(folder), "M2")()
    assert dataset[1].instruction in env.reset(task=dataset[1].id)
    env.act("stop")
    assert env.get_reward() == 0 and env.act("stop") == "The episode is over."
