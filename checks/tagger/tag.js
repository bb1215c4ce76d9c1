// Reads a text a line and prints its words, each with its part of speech behind a slash (Universal Dependencies), separated
// by blanks.
const model = require("wink-eng-lite-web-model");
const nlp = require("wink-nlp")(model, ["sbd", "pos"]);
const its = nlp.its;
const lines = require("fs").readFileSync(0, "utf8").split("\n");
lines.pop();
for (const line of lines) {
  const tokens = nlp.readDoc(line).tokens();
  const tags = tokens.out(its.pos);
  console.log(tokens.out(its.normal).map((word, i) => `${word.replace(/\s/g, "")}/${tags[i]}`).join(" "));
}
