#pragma once

#include <cstddef>
#include <cstdint>

/// Limits on input, each with its reason. Input beyond one is refused with an error that names the limit, or counted in
/// a report.
namespace unietp::limits {

// Names that may become names of files (core/plain_name.h). Most file systems allow 255 bytes, and endings are added.
inline constexpr std::size_t kNameBytes = 200;
inline constexpr std::size_t kFileNameBytes = 240;  // such a name and its endings
inline constexpr std::size_t kLabelBytes = 200;     // ids of objects and rooms, categories and other words of a scene

// Files. A file is read as a whole, or line by line where it is a data set's; a thousand homes of ProcTHOR have 200 MB.
inline constexpr std::size_t kFileBytes = std::size_t{256} << 20;
inline constexpr std::size_t kUnpackedBytes = kFileBytes;        // of a gzip file: a small one may claim terabytes
inline constexpr std::size_t kLineBytes = std::size_t{8} << 20;  // one task or demonstration of a data set: some 20 kB
// Of a text or a row of a database. The longest that is stored is a task with its demonstrations, a line of each mode.
inline constexpr int kDatabaseBytes = 64 << 20;

// Text of any file. Readers of nested text are recursive, so its depth is bounded for the sake of the stack.
inline constexpr int kFormulaDepth = 200;            // brackets of a formula, clauses of a sentence
inline constexpr std::size_t kExpressions = 20'000;  // bracketed lists and words of a template or formula
inline constexpr std::size_t kTextBytes = 10'000;    // of an instruction, or of a goal as text
inline constexpr int kFormulaParts = 5000;           // operators, terms and categories of a formula
inline constexpr int kQuantifiers = 8;               // of a formula, in one another
inline constexpr double kCombinations = 50'000'000;  // of objects that the quantifiers of a task's goal range over
inline constexpr int kTemporal = 8;                  // the same for temporal operators
inline constexpr int kJsonDepth = 64;                // objects and arrays in one another

// JSON. A value takes up to 130 bytes of memory where its text has two. Fields of one object are counted so that no
// input costs more time than its length.
inline constexpr std::size_t kJsonValues = 4'000'000;      // in one text: numbers, texts, lists, objects
inline constexpr std::size_t kJsonFields = 64;             // in files of this project
inline constexpr std::size_t kJsonTableFields = 100'000;   // where a simulator keeps all its scenes in one object
inline constexpr std::size_t kJsonHomeFields = 4'000'000;  // where a simulator names every part of a home by a field

// Homes. Physics and navigation take memory by area and time by number of objects.
inline constexpr std::size_t kRooms = 200;
inline constexpr std::size_t kRoomCorners = 500;
inline constexpr std::size_t kOpenings = 1000;
inline constexpr std::size_t kWalls = 5000;         // listed in a home of a simulator
inline constexpr std::size_t kObjects = 6000;       // imported ones and those that a template adds
inline constexpr std::size_t kEdges = 100'000;      // relations between objects
inline constexpr std::size_t kObjectBoards = 1000;  // solids of one object; BEHAVIOR has one of 138
inline constexpr double kWallHeight_m = 50, kWallThickness_m = 5;
inline constexpr double kObject_m = 100;     // a side of an object in a scene
inline constexpr double kPosition_m = 2000;  // of what stands or has fallen out of a home, from the origin
inline constexpr double kHomeWidth_m = 200;
inline constexpr double kRoomsArea_m2 = 40'000;        // of the boxes around the rooms, together
inline constexpr double kHomeOffset_m = 1000;          // from the origin, beyond which positions lose precision
inline constexpr double kImportedObject_m = 50;        // a side of one object's box
inline constexpr std::size_t kListedObjects = 20'000;  // in a simulator's file, walls and floors among them
inline constexpr std::size_t kImportedObjects = 5000;  // to be placed in one home
inline constexpr std::size_t kImportedRooms = kRooms;
inline constexpr std::size_t kHomesInFile = 10'000;
inline constexpr std::size_t kObjectsInFile = 500'000;  // of all its homes
inline constexpr std::size_t kNamedRooms = 100;  // distinguished by the names that objects give; more are no rooms
// Of physics for a home, as SettleOptions::most_work counts it: some twenty times what 300 movable objects take that
// stand apart. A heap of thousands would take hours.
inline constexpr std::size_t kMostWork = 25'000'000;

// Knowledge tables: what is larger is a slip of the unit (millimeters, grams).
inline constexpr double kCategory_m = 100, kCategory_kg = 90'000;
inline constexpr double kCompleted_m = 20, kCompleted_kg = 2000;  // as a language model may state it
inline constexpr std::int64_t kReservedRows = 1 << 20;            // a damaged file must not ask for all memory
inline constexpr double kProfileCount = 100'000;                  // pixels or hands in a simulator's profile
inline constexpr std::size_t kKindDepth = 100;                    // kinds above one another; the committed table has 5

// Shapes. A picture draws some hundreds of objects, and a shape file is a table that people write.
inline constexpr std::size_t kShapeParts = 10'000;  // of the families of one file
inline constexpr std::size_t kShapeNumbers = 200;   // of one part
inline constexpr std::size_t kShapePieces = 120;    // that one object is drawn of
inline constexpr double kShapeNumber = 1000;        // that a shape file may write, up or down from 0

// Templates. Starts are drawn with as many objects as they ask for, and a home has some hundreds.
inline constexpr int kCountedObjects = 1000;  // that init asks for in all, or that a goal counts to

// Runs. Many JSON readers hold numbers as doubles, which are exact for whole numbers up to 2^53.
inline constexpr std::uint64_t kSeed = 9'007'199'254'740'991;  // 2^53 - 1
inline constexpr int kTasks = 1'000'000'000;                   // of a run
inline constexpr int kAttempts = 1024;                         // for one task (dataset/candidate_number.h)
inline constexpr int kThreads = 1024;                          // of one command
inline constexpr int kWordings = 50;                           // different texts of one goal in wordings.jsonl

// Servers. A session takes some 20 MB, and a message may hold an agent's longest answer with every sign escaped.
inline constexpr std::size_t kMessageBytes = std::size_t{2} << 20;
inline constexpr std::uint32_t kHeaderBytes = 16 << 10;  // of a request over HTTP, before its body
inline constexpr int kServedSessions = 256;              // that may be open at once
inline constexpr int kServedConnections = 256;           // over HTTP and WebSocket, likewise
inline constexpr int kIdle_s = 1'000'000;                // that a session may be allowed

// Answers of language models, which may be anything.
inline constexpr std::size_t kAnswerBytes = std::size_t{4} << 20;  // of one HTTP answer
inline constexpr std::int64_t kAnswerTokens = 1'000'000'000;       // as a server counts them
inline constexpr int kRequests = 256;                              // at once
inline constexpr int kRequestAttempts = 100;                       // of one request
inline constexpr int kAskedTokens = 1'000'000;                     // of an answer, as a user may ask for
inline constexpr double kLeastTimeout_s = 0.01, kTimeout_s = 86'400, kTotal_s = 864'000, kWait_s = 3600;
// Files for a provider's batch service, which takes as many requests and 200 MB. What is more goes into further files.
inline constexpr std::size_t kBatchLines = 50'000;
inline constexpr std::size_t kBatchBytes = std::size_t{190} << 20;

// Environments. What an agent says may be anything, and many of them may be served by one process.
inline constexpr std::size_t kAgentAnswerBytes = std::size_t{1} << 20;  // of one answer
inline constexpr std::size_t kAgentActions = 100;                       // in one answer
inline constexpr int kEpisodeSteps = 1'000'000'000;                     // that an episode may be allowed
inline constexpr int kLeastImageSide = 16, kImageSide = 4096;           // pixels of a picture
inline constexpr int kLeastRenderedSide = 64, kRenderedSide = 1024;     // of one that a person asks for
inline constexpr std::size_t kEnvironments = 4096;                      // in a batch
inline constexpr int kProceduralHomes = 1000;                           // of a simulator, kept for new tasks

// Evaluations. What is kept of the text of an episode, so that its line can be read again (kLineBytes).
inline constexpr std::size_t kReplyBytes = std::size_t{32} << 10;    // of one reply; what follows is cut off
inline constexpr std::size_t kRepliesBytes = std::size_t{3} << 20;   // of all replies of an episode, shared evenly
inline constexpr std::size_t kThinkingBytes = std::size_t{2} << 20;  // of an episode; the log has the rest
inline constexpr int kEvaluatedSteps = 10'000;                       // that an evaluated episode may be allowed
inline constexpr std::size_t kPackageFiles = 10'000;  // of a package that acts, whose digests are recorded

}  // namespace unietp::limits
