#pragma once

#include <string_view>

namespace unietp::fuzz {

// What must hold for any bytes that a parser of outside text is given: it returns, an error says what is wrong, and
// what it accepts is written and read back the same. Each aborts where that fails, and tells whether the text was
// accepted. The fuzz targets run them on what libFuzzer finds, sample/ on seeds/ and changes of them.

bool sexpr_body(std::string_view text);
bool formula_body(std::string_view text);

/// A file of families of shapes, and after a line `====` the table of their categories.
bool shapes_body(std::string_view text);

bool csv_body(std::string_view text);
/// The five tables of one simulator, one after the other, with a line `====` between them.
bool tables_body(std::string_view text);
/// An override file over small tables.
bool override_body(std::string_view text);
bool gzip_body(std::string_view text);
/// A question about sense, such as "place Mug on Table".
bool question_body(std::string_view text);
/// The tables of common sense, one after the other, with a line `====` between them.
bool sense_body(std::string_view text);
/// ProcTHOR's models, iTHOR's scenes, BEHAVIOR's models and its table of categories, with a line `====` between them.
bool upstream_body(std::string_view text);
/// BEHAVIOR's table of categories, tree of synsets, models, rooms and annotations, and our table of hypernyms, with a
/// line `====` between them.
bool catalog_body(std::string_view text);
/// A table kept by hand: its name, a line feed, its text.
bool curated_body(std::string_view text);
/// index.noun and data.noun, with a line `====` between them.
bool wordnet_body(std::string_view text);
/// The bytes that a language model's server sends over the network, from the first of its HTTP answer.
bool http_body(std::string_view text);
/// What a language model's server answers when it is asked for facts.
bool completion_body(std::string_view text);
/// A chat completion whose text may be anything, a stored one, and further fields of a request.
bool chat_body(std::string_view text);
/// A line of an evaluation's files or log, or what a policy's program answers.
bool episode_body(std::string_view text);
bool evaluation_body(std::string_view text);  // its manifest
bool prompt_body(std::string_view text);
/// What a batch service hands back for texts and judgments, and what a server may say of when to ask again.
bool answers_body(std::string_view text);
/// A simulator's own JSON file.
bool metadata_body(std::string_view text);

// The simulators' own homes.
bool ithor_body(std::string_view text);
bool procthor_body(std::string_view text);
bool virtualhome_body(std::string_view text);
bool habitat_body(std::string_view text);
bool behavior_body(std::string_view text);
/// One of these files, whichever it is, twice.
bool foreign_body(std::string_view text);
/// A table of the models that such homes name.
bool models_body(std::string_view text);

/// As one text, and by the lines that it has in common with others.
bool scene_body(std::string_view text);
bool delta_body(std::string_view text);
bool action_body(std::string_view text);

bool template_body(std::string_view text);
bool instruction_body(std::string_view text);

bool profile_body(std::string_view text);
/// The four tables of one simulator's recipe, with a line `====` between them.
bool recipe_body(std::string_view text);
bool benchmark_body(std::string_view text);
bool statistics_body(std::string_view text);

bool task_body(std::string_view text);
bool demonstration_body(std::string_view text);
bool wordings_body(std::string_view text);
bool rejection_body(std::string_view text);
bool manifest_body(std::string_view text);
/// A line of reviews.jsonl.
bool mark_body(std::string_view text);
/// tasks.jsonl, demonstrations/M1.jsonl and wordings.jsonl, read side by side, with a line `====` between them.
bool lines_body(std::string_view text);

/// The settings of a run.
bool configuration_body(std::string_view text);
/// What a finished shard says of itself, and its database.
bool shard_body(std::string_view text);
/// What the review page saves.
bool review_body(std::string_view text);
/// What an agent says.
bool said_body(std::string_view text);
/// How an environment treats its agent.
bool settings_body(std::string_view text);
/// An option of the command line: its name, a line feed, its value.
bool names_body(std::string_view text);

/// What a client of `unietp serve` sends, a message a line.
bool serve_body(std::string_view text);

// SQLite databases.
bool knowledge_body(std::string_view bytes);
bool library_body(std::string_view bytes);
/// dataset.sqlite, held against one task.
bool database_body(std::string_view bytes);
/// The same, to give its tasks other instructions.
bool rewording_body(std::string_view bytes);
bool cache_body(std::string_view bytes);
bool ledger_body(std::string_view bytes);

}  // namespace unietp::fuzz
