// Reads a JSON text with "id" and "text" from each line of standard input and writes one line for each finding of Harper.
//   node lint.js us|gb < texts.jsonl > findings.jsonl
import { createInterface } from "node:readline";
import { Dialect, LocalLinter } from "harper.js";
import { binary } from "harper.js/binary";

const linter = new LocalLinter({ binary, dialect: process.argv[2] === "gb" ? Dialect.British : Dialect.American });
await linter.setup();
for await (const line of createInterface({ input: process.stdin })) {
  const { id, text } = JSON.parse(line);
  for (const found of await linter.lint(text, { language: "plaintext" })) {
    const finding = { id, kind: found.lint_kind(), words: found.get_problem_text(), message: found.message(), text };
    process.stdout.write(JSON.stringify(finding) + "\n");
  }
}
