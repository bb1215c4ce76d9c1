#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace unietp {

/// The rooms lowest first, each with the rooms that it declares to include.
struct RoomGraph {
  std::vector<std::string> rooms;
  std::map<std::string, std::vector<std::string>> depends;
};
/// Lines of the form `logic: core;scene`, as cmake/Room.cmake writes them.
RoomGraph read_room_graph(std::string_view text);

/// What is wrong with the declared arrows: a room that is not built, an arrow to a room that stands higher.
std::vector<std::string> graph_problems(const RoomGraph& graph);

/// What is wrong with the includes of one file of a room, each with file, line and what would be accepted: a room that
/// is not declared, a third-party header in a header.
std::vector<std::string> include_problems(const RoomGraph& graph, const std::string& path, std::string_view text);
/// The arrows that a room declares and none of its files, whose texts these are, includes.
std::vector<std::string> unused_arrows(const RoomGraph& graph, const std::string& room,
                                       const std::vector<std::string>& texts);

/// The circles between the files of one room: sets of stems that include one another, directly or through others. A
/// stem is a header with the source file of its name; `texts` is by path ("akb/fit.h"). Each circle is sorted, and so
/// are they.
std::vector<std::vector<std::string>> file_circles(const std::map<std::string, std::string>& texts);

/// Types that a file defines in the project's own namespace. Two of one name in different rooms would be merged by the
/// linker without a word, and the program would crash in one of them.
std::vector<std::string> types_defined(std::string_view text);

}  // namespace unietp
