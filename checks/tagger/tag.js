// Reads a text a line and prints its parts of speech (Universal Dependencies), separated by blanks.
const model = require("wink-eng-lite-web-model");
const nlp = require("wink-nlp")(model, ["sbd", "pos"]);
const its = nlp.its;
const lines = require("fs").readFileSync(0, "utf8").split("\n");
lines.pop();
for (const line of lines) console.log(nlp.readDoc(line).tokens().out(its.pos).join(" "));
