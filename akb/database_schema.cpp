#include "akb/database.h"

namespace unietp {

const char* const kDatabaseSchema = R"(
PRAGMA journal_mode=OFF; PRAGMA synchronous=OFF; PRAGMA page_size=16384;
CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL) STRICT;
CREATE TABLE simulator(id INTEGER PRIMARY KEY, name TEXT NOT NULL) STRICT;
CREATE TABLE size(simulator INTEGER NOT NULL, name TEXT NOT NULL, rows INTEGER NOT NULL,
  PRIMARY KEY(simulator, name)) STRICT, WITHOUT ROWID;
CREATE TABLE text(simulator INTEGER NOT NULL, id INTEGER NOT NULL, text TEXT NOT NULL,
  PRIMARY KEY(simulator, id)) STRICT, WITHOUT ROWID;
CREATE TABLE evidence(simulator INTEGER NOT NULL, id INTEGER NOT NULL, source INTEGER NOT NULL,
  confidence REAL NOT NULL, PRIMARY KEY(simulator, id)) STRICT, WITHOUT ROWID;

CREATE TABLE category_row(simulator INTEGER NOT NULL, name INTEGER NOT NULL, display TEXT NOT NULL,
  plural TEXT NOT NULL, synset TEXT NOT NULL, countable INTEGER NOT NULL, movable INTEGER NOT NULL,
  archetype INTEGER NOT NULL, width REAL NOT NULL, depth REAL NOT NULL, height REAL NOT NULL, mass REAL NOT NULL,
  rooms INTEGER NOT NULL, colours INTEGER NOT NULL, materials INTEGER NOT NULL, kinds INTEGER NOT NULL,
  traits INTEGER NOT NULL, evidence INTEGER NOT NULL,
  size_evidence INTEGER NOT NULL, mass_evidence INTEGER NOT NULL, synset_evidence INTEGER NOT NULL, PRIMARY KEY(simulator, name)) STRICT, WITHOUT ROWID;
CREATE TABLE affordance_row(simulator INTEGER NOT NULL, category INTEGER NOT NULL, affordance INTEGER NOT NULL,
  evidence INTEGER NOT NULL, PRIMARY KEY(simulator, category, affordance)) STRICT, WITHOUT ROWID;
CREATE TABLE relation_row(simulator INTEGER NOT NULL, object INTEGER NOT NULL, relation INTEGER NOT NULL,
  receptacle INTEGER NOT NULL, likelihood REAL NOT NULL, capacity INTEGER NOT NULL, evidence INTEGER NOT NULL,
  PRIMARY KEY(simulator, object, relation, receptacle)) STRICT, WITHOUT ROWID;
CREATE TABLE effect_row(simulator INTEGER NOT NULL, tool INTEGER NOT NULL, effect INTEGER NOT NULL,
  target INTEGER NOT NULL, gives INTEGER NOT NULL, amount INTEGER NOT NULL, needs INTEGER NOT NULL,
  evidence INTEGER NOT NULL, PRIMARY KEY(simulator, tool, effect, target, gives)) STRICT, WITHOUT ROWID;
CREATE TABLE alias_row(simulator INTEGER NOT NULL, category INTEGER NOT NULL, kind INTEGER NOT NULL,
  text TEXT NOT NULL, evidence INTEGER NOT NULL, PRIMARY KEY(simulator, category, kind, text)) STRICT, WITHOUT ROWID;
CREATE TABLE asset_row(simulator INTEGER NOT NULL, category INTEGER NOT NULL, asset TEXT NOT NULL,
  width REAL NOT NULL, depth REAL NOT NULL, height REAL NOT NULL, evidence INTEGER NOT NULL,
  PRIMARY KEY(simulator, category, asset)) STRICT, WITHOUT ROWID;

CREATE VIEW sourced AS SELECT e.simulator AS simulator, e.id AS id, t.text AS source, e.confidence AS confidence
  FROM evidence e JOIN text t ON t.simulator = e.simulator AND t.id = e.source;
CREATE VIEW category AS SELECT s.name AS simulator, n.text AS name, r.display AS display, r.plural AS plural,
  r.synset AS synset, r.countable AS countable, r.movable AS movable, a.text AS archetype, r.width AS width,
  r.depth AS depth, r.height AS height, r.mass AS mass, o.text AS rooms, c.text AS colours, m.text AS materials, k.text AS kinds,
  q.text AS traits,
  e.source AS source, e.confidence AS confidence, ze.source AS size_source, ze.confidence AS size_confidence,
  me.source AS mass_source, me.confidence AS mass_confidence, ye.source AS synset_source,
  ye.confidence AS synset_confidence
  FROM category_row r JOIN simulator s ON s.id = r.simulator
  JOIN text n ON n.simulator = r.simulator AND n.id = r.name
  JOIN text a ON a.simulator = r.simulator AND a.id = r.archetype
  JOIN text o ON o.simulator = r.simulator AND o.id = r.rooms
  JOIN text c ON c.simulator = r.simulator AND c.id = r.colours
  JOIN text m ON m.simulator = r.simulator AND m.id = r.materials
  JOIN text k ON k.simulator = r.simulator AND k.id = r.kinds
  JOIN text q ON q.simulator = r.simulator AND q.id = r.traits
  JOIN sourced e ON e.simulator = r.simulator AND e.id = r.evidence
  JOIN sourced ze ON ze.simulator = r.simulator AND ze.id = r.size_evidence
  JOIN sourced me ON me.simulator = r.simulator AND me.id = r.mass_evidence
  JOIN sourced ye ON ye.simulator = r.simulator AND ye.id = r.synset_evidence;
CREATE VIEW affordance AS SELECT s.name AS simulator, c.text AS category, a.text AS affordance, e.source AS source,
  e.confidence AS confidence FROM affordance_row r JOIN simulator s ON s.id = r.simulator
  JOIN text c ON c.simulator = r.simulator AND c.id = r.category
  JOIN text a ON a.simulator = r.simulator AND a.id = r.affordance
  JOIN sourced e ON e.simulator = r.simulator AND e.id = r.evidence;
CREATE VIEW relation AS SELECT s.name AS simulator, o.text AS object, w.text AS relation, c.text AS receptacle,
  r.likelihood AS likelihood, r.capacity AS capacity, e.source AS source, e.confidence AS confidence
  FROM relation_row r JOIN simulator s ON s.id = r.simulator
  JOIN text o ON o.simulator = r.simulator AND o.id = r.object
  JOIN text w ON w.simulator = r.simulator AND w.id = r.relation
  JOIN text c ON c.simulator = r.simulator AND c.id = r.receptacle
  JOIN sourced e ON e.simulator = r.simulator AND e.id = r.evidence;
CREATE VIEW effect AS SELECT s.name AS simulator, o.text AS tool, w.text AS effect, c.text AS target, g.text AS gives,
  r.amount AS amount, n.text AS needs, e.source AS source, e.confidence AS confidence
  FROM effect_row r JOIN simulator s ON s.id = r.simulator
  JOIN text o ON o.simulator = r.simulator AND o.id = r.tool
  JOIN text w ON w.simulator = r.simulator AND w.id = r.effect
  JOIN text c ON c.simulator = r.simulator AND c.id = r.target
  JOIN text g ON g.simulator = r.simulator AND g.id = r.gives
  JOIN text n ON n.simulator = r.simulator AND n.id = r.needs
  JOIN sourced e ON e.simulator = r.simulator AND e.id = r.evidence;
CREATE VIEW alias AS SELECT s.name AS simulator, c.text AS category, k.text AS kind, r.text AS text,
  e.source AS source, e.confidence AS confidence FROM alias_row r JOIN simulator s ON s.id = r.simulator
  JOIN text c ON c.simulator = r.simulator AND c.id = r.category
  JOIN text k ON k.simulator = r.simulator AND k.id = r.kind
  JOIN sourced e ON e.simulator = r.simulator AND e.id = r.evidence;
CREATE VIEW asset AS SELECT s.name AS simulator, r.asset AS asset, c.text AS category, r.width AS width,
  r.depth AS depth, r.height AS height, e.source AS source, e.confidence AS confidence
  FROM asset_row r JOIN simulator s ON s.id = r.simulator
  JOIN text c ON c.simulator = r.simulator AND c.id = r.category
  JOIN sourced e ON e.simulator = r.simulator AND e.id = r.evidence;
)";

}  // namespace unietp
